// SPDX-License-Identifier: GPL-3.0-or-later
// Reads $Periodic, $GhostElements, $NodeData, $ElementData and $ElementNodeData.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "io/bytes/scanner.hpp"
#include "io/error.hpp"
#include "io/msh/msh_data.hpp"

namespace tetproof::io {
namespace {

constexpr std::size_t affine_size = 16;

// The text between the quotes of a line, if the line has nothing else.
std::optional<std::string> quoted(std::string_view line) {
  constexpr std::string_view blanks = " \t\v\f";
  const std::size_t from = line.find_first_not_of(blanks);
  if (from == line.npos) return std::nullopt;
  line = line.substr(from, line.find_last_not_of(blanks) + 1 - from);
  if (line.size() < 2 || line.front() != '"' || line.back() != '"') return std::nullopt;
  return std::string(line.substr(1, line.size() - 2));
}

bool skip_word(Numbers& in, std::string_view word) {
  in.skip_blanks();
  if (!in.source().bytes.substr(in.offset()).starts_with(word)) return false;
  in.go_to(in.offset() + word.size());
  return true;
}

// Finds elements by their tags. If several have the same tag, the first.
class ElementIndex {
 public:
  ElementIndex(Document& document, const std::vector<ElementTag>& copies) : document_(document) {
    const std::size_t elements = document.elements();
    if (elements > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
      throw InputError(fmt::format("{}: {} elements are more than the {} that data can be given to",
                                   document.path, elements, std::numeric_limits<Index>::max()));
    if (!document.element_tags.empty() || !copies.empty()) {
      sorted_.reserve(elements + copies.size());
      for (std::size_t e = 0; e < elements; ++e)
        sorted_.emplace_back(document.element_tag(e), static_cast<Index>(e));
      sorted_.insert(sorted_.end(), copies.begin(), copies.end());
      if (!std::is_sorted(sorted_.begin(), sorted_.end())) std::sort(sorted_.begin(), sorted_.end());
    }
  }

  Index operator()(std::int64_t tag) {
    if (sorted_.empty()) {
      const std::uint64_t offset =
          static_cast<std::uint64_t>(tag) - static_cast<std::uint64_t>(document_.first_element);
      return offset < document_.elements() ? static_cast<Index>(offset) : unknown(tag);
    }
    const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), ElementTag{tag, 0});
    return found != sorted_.end() && found->first == tag ? found->second : unknown(tag);
  }

 private:
  Index unknown(std::int64_t tag) {
    for (; known_ < document_.unknown.size(); ++known_)
      unknown_.emplace(document_.unknown[known_], -1 - static_cast<Index>(known_));
    const auto [place, is_new] = unknown_.try_emplace(tag, -1 - static_cast<Index>(document_.unknown.size()));
    if (is_new) document_.unknown.push_back(tag);
    return place->second;
  }

  Document& document_;
  std::vector<ElementTag> sorted_;
  std::unordered_map<std::int64_t, Index> unknown_;  // of the document's first `known_`
  std::size_t known_ = 0;
};

// Positions that only count up are not listed.
void set_positions(Values& values, std::vector<Index> at) {
  bool counts_up = !at.empty() && at[0] >= 0;
  for (std::size_t i = 1; i < at.size() && counts_up; ++i) counts_up = at[i] == at[i - 1] + 1;
  if (counts_up)
    values.first = static_cast<std::size_t>(at[0]);
  else
    values.at = std::move(at);
}

template <class Find>
std::vector<Index> positions(const std::vector<std::int64_t>& tags, Find& find) {
  std::vector<Index> found(tags.size());
  std::transform(tags.begin(), tags.end(), found.begin(), [&](std::int64_t tag) { return find(tag); });
  return found;
}

}  // namespace

void MshData::read_periodic(Numbers& in, bool affine_word) {
  const std::int64_t count = in.count("the number of periodic entities", 8, 28);
  for (std::int64_t i = 0; i < count; ++i) {
    TaggedLink& read = links_.emplace_back();
    const std::int64_t dim = in.integer("the dimension of a periodic entity");
    if (dim < 0 || dim > 3)
      in.fail(fmt::format("expected the dimension of a periodic entity, 0 to 3, found {}", dim));
    read.link.dim = static_cast<int>(dim);
    read.link.entity = in.integer("the tag of a periodic entity");
    read.link.master = in.integer("the tag of the entity that it follows");
    std::size_t values = 0;
    if (!affine_word)
      values = static_cast<std::size_t>(in.count("the number of values of an affine transformation", 2, 8));
    else if (skip_word(in, "Affine"))
      values = affine_size;
    for (std::size_t k = 0; k < values; ++k)
      read.link.affine.push_back(in.real("a value of an affine transformation"));
    const std::int64_t nodes = in.count("the number of periodic nodes", 4, 16);
    read.tags.reserve(static_cast<std::size_t>(nodes));
    for (std::int64_t k = 0; k < nodes; ++k) {
      const std::int64_t node = in.size("the tag of a periodic node");
      read.tags.push_back({node, in.size("the tag of the node that it follows")});
    }
  }
}

void MshData::read_ghosts(Numbers& in) {
  const std::int64_t count = in.count("the number of ghost elements", 6, 20);
  ghosts_.reserve(ghosts_.size() + static_cast<std::size_t>(count));
  for (std::int64_t i = 0; i < count; ++i) {
    TaggedGhost& read = ghosts_.emplace_back();
    read.tag = in.size("the tag of a ghost element");
    read.ghost.partition = in.integer("the partition of a ghost element");
    read.ghost.ghosts.resize(
        static_cast<std::size_t>(in.count("the number of partitions that see a ghost element", 2, 4)));
    for (std::int64_t& partition : read.ghost.ghosts)
      partition = in.integer("a partition that sees a ghost element");
  }
}

std::optional<MshData::Header> MshData::read_header(Scanner& in) {
  Header header;
  Values& values = header.values;
  const std::int64_t strings = in.count("the number of string tags", 1);
  in.next_line();
  bool usual = strings == 1 || strings == 2;
  for (std::int64_t i = 0; i < strings; ++i, in.next_line()) {
    const auto text = quoted(in.rest_of_line());
    if (!usual || !text) return std::nullopt;
    (i == 0 ? values.name : values.interpolation) = *text;
  }
  usual = usual && (strings == 1 || !values.interpolation.empty());
  const std::int64_t reals = in.count("the number of real tags", 2);
  for (std::int64_t i = 0; i < reals; ++i) values.time = in.real("a real tag");
  values.of_view = reals > 0;
  std::vector<std::int64_t> integers(static_cast<std::size_t>(in.count("the number of integer tags", 2)));
  for (std::int64_t& integer : integers) integer = in.integer("an integer tag");
  if (!usual || reals > 1 || integers.size() < 3 || integers.size() > 4) return std::nullopt;
  if (integers[1] < 1 || integers[1] > std::numeric_limits<int>::max())
    in.fail_in_line(fmt::format("expected the number of components of the data, found {}", integers[1]));
  values.step = integers[0];
  values.components = static_cast<int>(integers[1]);
  values.partition = integers.size() > 3 ? integers[3] : 0;  // 0: none
  header.rows = integers[2];
  // Values without a time are of no view. Our own writer writes them like this.
  if (!values.of_view && (values.step != 0 || values.partition != 0 || !values.interpolation.empty()))
    return std::nullopt;
  in.next_line();
  return header;
}

void MshData::read_rows(Numbers& in, Header header, Of of) {
  const bool by_nodes = of == Of::element_node;
  const auto components = static_cast<std::size_t>(header.values.components);
  const std::size_t value_bytes = in.binary() ? 8 : 2;
  in.check_count(header.rows, "the number of nodes or elements that have data",
                 (in.binary() ? 4 : 2) * (by_nodes ? 2 : 1) + (by_nodes ? 0 : components * value_bytes));
  TaggedValues& read = values_.emplace_back(TaggedValues{std::move(header.values), of});
  const auto rows = static_cast<std::size_t>(header.rows);
  read.tags.reserve(rows);
  if (!by_nodes) read.values.reals.reserve(rows * components);
  Numbers here = in;  // a copy that the compiler can keep in registers
  for (std::size_t i = 0; i < rows; ++i) {
    read.tags.push_back(here.integer(of == Of::node ? "the tag of a node" : "the tag of an element"));
    std::size_t count = components;
    if (by_nodes) {
      const std::int64_t nodes = here.integer("the number of an element's nodes");
      here.check_count(nodes, "the number of an element's nodes", components * value_bytes);
      if (nodes > std::numeric_limits<std::int32_t>::max())
        here.fail(fmt::format("expected the number of an element's nodes, found {}", nodes));
      read.values.nodes.push_back(static_cast<std::int32_t>(nodes));
      count *= static_cast<std::size_t>(nodes);
    }
    for (std::size_t k = 0; k < count; ++k) read.values.reals.push_back(here.real("a value"));
  }
  in = here;
}

// Only 4.1 says how many numbers an affine transformation has.
void MshData::warn_of_maps(Document& document) const {
  const auto is_odd = [](const TaggedLink& read) {
    return !read.link.affine.empty() && read.link.affine.size() != affine_size;
  };
  const auto first = std::find_if(links_.begin(), links_.end(), is_odd);
  if (first == links_.end()) return;
  const auto count = std::count_if(first, links_.end(), is_odd);
  document.warnings.push_back(fmt::format(
      "{}: {} not 16 numbers (the first: that of entity {} of dimension {}, which has {})", document.path,
      count == 1 ? "an affine transformation has" : fmt::format("{} affine transformations have", count),
      first->link.entity, first->link.dim, first->link.affine.size()));
}

// Looks up nodes first. A number that no node has may be one that no element has either.
void MshData::look_up(Document& document, NodeIndex& nodes, const std::vector<ElementTag>& copies) {
  warn_of_maps(document);
  for (TaggedLink& read : links_) {
    read.link.nodes.reserve(read.tags.size());
    for (const auto& [node, master] : read.tags) {
      const Index position = nodes(node);
      read.link.nodes.push_back({position, nodes(master)});
    }
    document.periodic.push_back(std::move(read.link));
  }
  for (TaggedValues& read : values_)
    if (read.of == Of::node) {
      set_positions(read.values, positions(read.tags, nodes));
      document.node_values.push_back(std::move(read.values));
    }
  ElementIndex elements(document, copies);
  for (TaggedGhost& read : ghosts_) {
    read.ghost.element = elements(read.tag);
    document.ghost_elements.push_back(std::move(read.ghost));
  }
  for (TaggedValues& read : values_)
    if (read.of != Of::node) {
      set_positions(read.values, positions(read.tags, elements));
      (read.of == Of::element ? document.element_values : document.element_node_values)
          .push_back(std::move(read.values));
    }
  values_.clear(), links_.clear(), ghosts_.clear();
}

}  // namespace tetproof::io
