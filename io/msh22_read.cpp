// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of .msh 1 to 3, but for the entities of 3.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>

#include "io/element_types.hpp"
#include "io/large_pages.hpp"
#include "io/msh22_limits.hpp"
#include "io/msh22_plain.hpp"
#include "io/msh_sections.hpp"
#include "io/plain_lines.hpp"

namespace tetproof::io {
namespace {

class ElementReader {
 public:
  ElementReader(Numbers& in, ElementTags kind, Document& document, NodeIndex& index, TagSets& sets,
                std::vector<ElementTag>& copies)
      : in_(in),
        kind_(kind),
        document_(document),
        index_(index),
        sets_(sets),
        tags_(document.element_tags, document.first_element),
        copies_(copies) {}

  // A line: tag, type, number of tags, tags, nodes; for polygons and polyhedra their number before them.
  void read_text(std::int64_t count) {
    if (read_plain(static_cast<std::size_t>(count))) return;
    document_.connectivity.reserve(document_.connectivity.size() + 2 * count);
    for (std::int64_t e = 0; e < count; ++e) {
      const std::int64_t tag = in_.integer("the tag of an element");
      set_type(in_.integer("an element type"));
      const std::int64_t tags = in_.integer("the number of tags");
      in_.check_count(tags, "the number of tags", 2);
      read_element_tags(tags);
      const std::int64_t each = type_                                          ? type_->nodes
                                : has_counted_nodes(static_cast<int>(number_)) ? read_node_count()
                                                                               : in_.words_in_line();
      if (each == 0) in_.fail(fmt::format("expected the nodes of an element of type {}", number_));
      read_nodes(each);
      add(tag);
    }
    put_waiting();
  }

  // A line: tag, type, physical and elementary tag, number of nodes, nodes.
  void read_1(std::int64_t count) {
    for (std::int64_t e = 0; e < count; ++e) {
      const std::int64_t tag = in_.integer("the tag of an element");
      set_type(in_.integer("an element type"));
      read_element_tags(2);
      read_nodes(read_node_count());
      add(tag);
    }
    put_waiting();
  }

  // A line: tag, type, entity, how many numbers follow: nodes; then partitions, if there are more, behind
  // their number. Of a type that is not known all are nodes.
  void read_3(std::int64_t count) {
    for (std::int64_t e = 0; e < count; ++e) {
      const std::int64_t tag = in_.integer("the tag of an element");
      set_type(in_.integer("an element type"));
      entity_ = in_.integer("the tag of an entity");
      const std::int64_t numbers = in_.integer("how many numbers follow");
      in_.check_count(numbers, "how many numbers follow", in_.binary() ? 4 : 2);
      if (numbers == 0 || (type_ && numbers < type_->nodes))
        in_.fail(
            fmt::format("expected the nodes of an element of type {}, found {} numbers", number_, numbers));
      read_nodes(type_ ? type_->nodes : numbers);
      std::vector<std::int64_t> partitions(static_cast<std::size_t>(type_ ? numbers - type_->nodes : 0));
      for (std::int64_t& partition : partitions)
        partition = in_.integer("a partition, or how many there are");
      if (!partitions.empty()) {
        if (partitions[0] == static_cast<std::int64_t>(partitions.size()) - 1) {
          partitions.erase(partitions.begin());
        } else {  // the parent of a sub-element, for which there is no room
          partitions.clear();
          if (++ignored_ == 1)
            document_.warnings.push_back(
                fmt::format("{}: element {} has numbers behind its nodes that are no partitions: they are "
                            "ignored (the first such)",
                            document_.path, tag));
        }
      }
      partitions_ = sets_(partitions);
      add(tag);
    }
    put_waiting();
  }

  // Headers (type, number of elements, number of tags), each with its elements (tag, tags, nodes).
  void read_binary(std::int64_t count) {
    for (std::int64_t left = count; left > 0;) {
      set_type(in_.integer("an element type"));
      if (!type_) in_.fail(fmt::format("unknown element type {}", number_));
      const std::int64_t here = in_.integer("the number of elements that follow");
      if (here < 1 || here > left)
        in_.fail(fmt::format("expected the number of elements that follow, 1 to {}, found {}", left, here));
      const std::int64_t tags = in_.integer("the number of tags");
      in_.check_count(tags, "the number of tags", 4);
      in_.check_count(here, "the number of elements that follow", 4 * (1 + tags + type_->nodes));
      for (std::int64_t e = 0; e < here; ++e) {
        const std::int64_t tag = in_.integer("the tag of an element");
        read_element_tags(tags);
        read_nodes(type_->nodes);
        add(tag);
      }
      left -= here;
    }
    put_waiting();
  }

 private:
  bool read_plain(std::size_t count) {
    const std::size_t first = document_.elements(), nodes = document_.connectivity.size();
    const std::vector<ElementBlock> blocks = document_.blocks;
    const auto take_piece = [&](const PlainElements22& piece) { take(piece, first + count); };
    reserve_in_large_pages(document_.connectivity, nodes + 4 * count);  // most are tetrahedra in most files
    if (read_plain_elements22(in_, count, index_, take_piece)) return true;
    document_.blocks = blocks;
    document_.connectivity.resize(nodes);
    tags_.cut(first);
    last_tags_.clear();
    return false;
  }

  // `elements`: how many there will be in the end.
  void take(const PlainElements22& piece, std::size_t elements) {
    std::vector<Index>& all = document_.connectivity;
    if (all.size() + piece.nodes.size() > all.capacity()) {
      const std::size_t left = elements - document_.elements();  // probably as large as these
      reserve_in_large_pages(all, all.size() + std::max(piece.nodes.size() / piece.tags.size() * left,
                                                        piece.nodes.size() + all.size() / 4));
    }
    const Index* node = piece.nodes.data();
    std::size_t from = 0;
    for (const auto& run : piece.runs) {
      tags_read_ = run.tags;
      use_element_tags();
      ElementBlock& block = block_of({.type = run.type->type,
                                      .dim = run.type->dim,
                                      .entity = entity_,
                                      .groups = group_ != 0 ? sets_({group_}) : sets_({}),
                                      .partitions = partitions_,
                                      .nodes_each = run.type->nodes});
      tags_.add(block.first + block.count, std::span(piece.tags).subspan(from, run.count));
      block.count += run.count, from += run.count;
      const Index* const end = node + run.count * static_cast<std::size_t>(run.type->nodes);
      all.insert(all.end(), node, end);
      node = end;
    }
  }

  void set_type(std::int64_t number) {
    if (number == number_) return;
    number_ = number;
    type_ = number < 0 || number > std::numeric_limits<int>::max() ? nullptr
                                                                   : element_type(static_cast<int>(number));
    if (number < 0 || number > std::numeric_limits<int>::max())
      in_.fail(fmt::format("expected an element type, found {}", number));
  }

  std::int64_t read_node_count() {
    const std::int64_t each = in_.integer("the number of nodes of an element");
    in_.check_count(each, "the number of nodes of an element", 2);
    if (each == 0 || (type_ && each != type_->nodes))
      in_.fail(fmt::format("expected {} nodes of an element of type {}, found {}",
                           type_ ? std::to_string(type_->nodes) : "the", number_, each));
    return each;
  }

  void read_nodes(std::int64_t each) {
    nodes_.resize(static_cast<std::size_t>(each));
    for (Index& node : nodes_) node = index_(in_.integer("the tag of a node"));
  }

  // Physical, elementary, partitions: what the element belongs to.
  void read_element_tags(std::int64_t count) {
    tags_read_.resize(count);
    for (std::int64_t& tag : tags_read_)
      tag = in_.integer("an element's physical, elementary or partition tag");
    use_element_tags();
  }

  void use_element_tags() {
    if (tags_read_ == last_tags_) return;
    last_tags_ = tags_read_;
    const auto count = static_cast<std::int64_t>(tags_read_.size());
    group_ = count > 0 ? tags_read_[0] : 0;
    entity_ = count > 1 ? tags_read_[1] : 0;
    partitions_ = 0;
    if (count > 2 && kind_ != ElementTags::v22) partitions_ = sets_({tags_read_[2]});
    if (count > 3 && kind_ == ElementTags::v22) {
      const auto named = tags_read_.begin() + 3;
      partitions_ = sets_({named, named + std::clamp<std::int64_t>(tags_read_[2], 0, count - 3)});
    }
  }

  // An element in several physical groups stands once for each of them: the last one again, but for its group
  // and its tag. So an element waits until the next one has been read. One with another number of tags is no
  // such copy: our writer has no other way to tell the two apart.
  void add(std::int64_t tag) {
    if (repeats_waiting()) {
      waiting_.groups.push_back(group_);
      copies_.emplace_back(tag, static_cast<Index>(document_.elements()));  // where the first one will be
      return;
    }
    put_waiting();
    waiting_ = {.any = true,
                .tag = tag,
                .number = number_,
                .type = type_,
                .tags = tags_read_.size(),
                .entity = entity_,
                .partitions = partitions_,
                .groups = std::move(waiting_.groups),
                .nodes = std::move(waiting_.nodes)};
    waiting_.groups.clear();
    if (group_ != 0) waiting_.groups.push_back(group_);
    waiting_.nodes.swap(nodes_);
  }

  bool repeats_waiting() const {
    return waiting_.any && waiting_.number == number_ && waiting_.entity == entity_ &&
           waiting_.tags == tags_read_.size() && waiting_.partitions == partitions_ &&
           waiting_.nodes == nodes_ && group_ != 0 && !waiting_.groups.empty() &&
           waiting_.groups.size() < most_groups22 &&
           std::find(waiting_.groups.begin(), waiting_.groups.end(), group_) == waiting_.groups.end();
  }

  void put_waiting() {
    if (!waiting_.any) return;
    waiting_.any = false;
    ElementBlock& block = block_of({.type = static_cast<int>(waiting_.number),
                                    .dim = dimension22(static_cast<int>(waiting_.number)),
                                    .entity = waiting_.entity,
                                    .groups = sets_(waiting_.groups),
                                    .partitions = waiting_.partitions,
                                    .nodes_each = static_cast<std::int32_t>(waiting_.nodes.size())});
    tags_.add(block.first + block.count++, waiting_.tag);
    document_.connectivity.insert(document_.connectivity.end(), waiting_.nodes.begin(), waiting_.nodes.end());
  }

  // The last block if it is like this one, or else a new one.
  ElementBlock& block_of(ElementBlock like) {
    std::vector<ElementBlock>& blocks = document_.blocks;
    if (blocks.empty() || blocks.back().type != like.type || blocks.back().nodes_each != like.nodes_each ||
        blocks.back().entity != like.entity || blocks.back().partitions != like.partitions ||
        blocks.back().groups != like.groups) {
      like.first = document_.elements();
      like.nodes = document_.connectivity.size();
      blocks.push_back(like);
    }
    return blocks.back();
  }

  struct Waiting {
    bool any = false;
    std::int64_t tag = 0, number = 0;
    const ElementType* type = nullptr;
    std::size_t tags = 0;
    std::int64_t entity = 0;
    std::int32_t partitions = 0;
    std::vector<std::int64_t> groups{};
    std::vector<Index> nodes{};
  };

  Numbers& in_;
  const ElementTags kind_;
  Document& document_;
  NodeIndex& index_;
  TagSets& sets_;
  Tags tags_;
  std::vector<ElementTag>& copies_;
  std::int64_t number_ = -1;
  const ElementType* type_ = nullptr;
  std::vector<std::int64_t> tags_read_, last_tags_;
  std::vector<Index> nodes_;
  std::int64_t group_ = 0, entity_ = 0;
  std::int32_t partitions_ = 0;
  Waiting waiting_;
  std::size_t ignored_ = 0;
};

// A long run of plain lines; false where this is none, and nothing was read.
bool read_plain_nodes(Numbers& in, std::size_t count, Document& document, Tags& tags) {
  if (in.binary() || count < least_plain_lines) return false;
  in.skip_blanks();
  const std::size_t first = document.points.size();
  resize_in_large_pages(document.points, first + count);
  const auto behind =
      read_tagged_lines(in.source(), in.offset(), count, tags, first, [&](PlainLine& line, std::size_t i) {
        Eigen::Vector3d& p = document.points[first + i];
        return line.real(p.x()) && line.real(p.y()) && line.real(p.z());
      });
  if (behind)
    in.go_to(*behind);
  else
    document.points.resize(first);
  return behind.has_value();
}

}  // namespace

void read_nodes22(Numbers& in, std::int64_t count, bool parametric, Document& document) {
  Tags tags(document.node_tags, document.first_node);
  check_node_count(in, document.points.size() + count);
  if (!parametric && read_plain_nodes(in, static_cast<std::size_t>(count), document, tags)) return;
  document.points.reserve(document.points.size() + count);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::size_t position = document.points.size();
    tags.add(position, in.integer("the tag of a node"));
    const double x = in.real("a coordinate"), y = in.real("a coordinate"), z = in.real("a coordinate");
    document.points.emplace_back(x, y, z);
    if (!parametric) continue;
    const std::int64_t dim = in.integer("the dimension of a node's entity");
    if (dim < 0 || dim > 3)
      in.fail(fmt::format("expected the dimension of a node's entity, 0 to 3, found {}", dim));
    const std::int64_t entity = in.integer("the tag of a node's entity");
    const int each = dim == 1 || dim == 2 ? static_cast<int>(dim) : 0;
    if (document.node_blocks.empty() || document.node_blocks.back().dim != dim ||
        document.node_blocks.back().entity != entity)
      document.node_blocks.push_back({.dim = static_cast<int>(dim),
                                      .entity = entity,
                                      .first = position,
                                      .parameters_each = each,
                                      .parameters = document.parameters.size()});
    ++document.node_blocks.back().count;
    for (int k = 0; k < each; ++k) document.parameters.push_back(in.real("a parametric coordinate"));
  }
}

void read_elements22(Numbers& in, std::int64_t count, ElementTags tags, Document& document, NodeIndex& index,
                     TagSets& sets, std::vector<ElementTag>& copies) {
  ElementReader reader(in, tags, document, index, sets, copies);
  if (tags == ElementTags::v3)
    reader.read_3(count);
  else if (tags == ElementTags::v1)
    reader.read_1(count);
  else
    in.binary() ? reader.read_binary(count) : reader.read_text(count);
}

}  // namespace tetproof::io
