// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a supplement, and puts what it says back into the document that the native part gave.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "io/loss/loss_list.hpp"
#include "io/model/document_positions.hpp"
#include "io/supplement/supplement.hpp"
#include "io/supplement/supplement_blocks.hpp"
#include "io/supplement/supplement_decoder.hpp"

namespace tetproof::io {
namespace {

class Joiner {
 public:
  Joiner(Decoder& in, Document& native) : in_(in), native_(native) {}

  void join() {
    for (std::string_view name = in_.word(); !name.empty(); name = in_.word()) field(name);
    if (const char* wrong = misplaced(native_)) in_.fail(fmt::format("{} do not fit the file", wrong));
  }

 private:
  void field(std::string_view name) {
    Document& d = native_;
    if (name == "unknown") {
      unknown();
    } else if (name == "tag_sets") {
      in_(d.tag_sets);
    } else if (name == "blocks") {
      blocks();
    } else if (name == "faces") {
      std::size_t block = 0;
      in_(block);
      if (block >= d.blocks.size()) in_.fail(fmt::format("there is no block {}", block));
      in_(d.blocks[block].faces);
    } else if (name == "node_tags") {
      in_(d.first_node, d.node_tags);
    } else if (name == "element_tags") {
      in_(d.first_element, d.element_tags);
    } else if (name == "node_blocks") {
      in_(d.node_blocks, d.parameters);
    } else if (name == "entities") {
      in_(d.entities);
    } else if (name == "groups") {
      in_(d.group_names);
    } else if (name == "partitions") {
      in_(d.partitions, d.ghosts);
    } else if (name == "ghost_elements") {
      in_(d.ghost_elements);
      for (GhostElement& ghost : d.ghost_elements) rename(ghost.element);
    } else if (name == "periodic") {
      in_(d.periodic);
      for (PeriodicLink& link : d.periodic)
        for (auto& pair : link.nodes) rename(pair[0]), rename(pair[1]);
    } else if (name == "node_values") {
      all_values(d.node_values);
    } else if (name == "element_values") {
      all_values(d.element_values);
    } else if (name == "element_node_values") {
      all_values(d.element_node_values);
    } else if (name == "roles") {
      in_(named_values().roles);
    } else if (name == "texts") {
      named_values().texts = true;
    } else if (name == "facets") {
      in_(d.facets);
    } else if (name == "holes") {
      in_(d.holes);
    } else if (name == "regions") {
      in_(d.regions);
    } else if (name == "bounds") {
      in_(d.area_bounds, d.length_bounds);
      for (LengthBound& bound : d.length_bounds) rename(bound.nodes[0]), rename(bound.nodes[1]);
    } else if (name == "voronoi") {
      in_(d.voronoi);
    } else if (name == "tables") {
      in_(d.tables);
    } else if (name == "title") {
      in_(d.title);
    } else if (name == "sections") {
      sections();
    } else {
      in_.fail(fmt::format("expected the name of a field, found '{}'", name.substr(0, 40)));
    }
  }

  // The supplement lists the document's unknown numbers, and the numbers that the native part has in their
  // place.
  void unknown() {
    std::vector<std::int64_t> numbers, written;
    in_(numbers, written);
    if (written.size() != numbers.size()) in_.fail("two lists of unknown numbers differ in length");
    std::map<std::int64_t, std::size_t> place;
    for (std::size_t k = 0; k < native_.unknown.size(); ++k) place.emplace(native_.unknown[k], k);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const auto [found, is_new] = place.try_emplace(written[k], native_.unknown.size());
      if (is_new) native_.unknown.push_back(0);
      native_.unknown[found->second] = numbers[k];
      renamed_.push_back(-1 - static_cast<Index>(found->second));
    }
  }

  // Turns a position in the document into the position that it has now.
  void rename(Index& i) const {
    if (i >= 0) return;
    const auto k = static_cast<std::size_t>(-1 - static_cast<std::int64_t>(i));
    if (k >= renamed_.size()) in_.fail(fmt::format("there is no unknown number {}", k));
    i = renamed_[k];
  }

  void blocks() {
    std::vector<SupplementBlock> all(in_.count());
    for (SupplementBlock& b : all) {
      in_(b.block, b.kind, b.written, b.native);
      if (b.block.nodes_each < 1) in_.fail("an element has at least one node");
      if (b.native) continue;
      const auto each = static_cast<std::size_t>(b.block.nodes_each);
      for (std::size_t e = 0; e < b.block.count; ++e)
        for (std::size_t k = 0; k < each; ++k) {
          in_(b.listed.emplace_back());
          rename(b.listed.back());
        }
    }
    join_blocks(all, native_, in_);
  }

  // Where the native part has the numbers, its values are in the same order. It may have others among them.
  void all_values(std::vector<Values>& all) {
    std::vector<Values> joined(in_.count());
    auto next = all.begin();
    for (Values& values : joined) {
      std::int32_t native = not_native;
      in_(values, native);
      for (Index& i : values.at) rename(i);
      if (native < not_native || native > integers_as_reals)
        in_.fail(fmt::format("{} is out of range", native));
      if (native == not_native) {
        in_(values.reals, values.integers);
        continue;
      }
      const auto is_it = [&](const Values& v) {
        return v.name == values.name && v.components == values.components;
      };
      // Values of other elements may have the same name.
      const auto exact = std::find_if(next, all.end(), [&](const Values& v) {
        return is_it(v) && v.first == values.first && v.at == values.at;
      });
      next = exact != all.end() ? exact : std::find_if(next, all.end(), is_it);
      if (next == all.end())  // the document had them in another order
        next =
            std::find_if(all.begin(), all.end(), [&](const Values& v) { return is_it(v) && v.size() > 0; });
      if (next == all.end()) in_.fail(fmt::format("the file has no values \"{}\"", values.name));
      values.reals = std::move(next->reals);
      values.integers = std::move(next->integers);
      if (native == integers_as_reals) make_integers(values);
      ++next;
    }
    all = std::move(joined);
  }

  // The values of which a field gives the kind and the place.
  Values& named_values() {
    std::vector<Values>* all[] = {&native_.node_values, &native_.element_values,
                                  &native_.element_node_values};
    std::size_t kind = 0, place = 0;
    in_(kind, place);
    if (kind >= std::size(all) || place >= all[kind]->size()) in_.fail("there are no such values");
    return (*all[kind])[place];
  }

  void make_integers(Values& values) {
    for (const double real : values.reals) {
      if (!(std::abs(real) <= 0x1p53))
        in_.fail(fmt::format("{} is no integer of values \"{}\"", real, values.name));
      values.integers.push_back(static_cast<std::int64_t>(real));
    }
    values.reals.clear();
  }

  void sections() {
    std::vector<Section> joined(in_.count());
    for (Section& section : joined) {
      bool native = false;
      in_(section, native);
      if (!native) {
        in_(section.body);
        continue;
      }
      // The writer keeps a section on its side of the nodes, so the name and the side identify it.
      const auto found = std::find_if(
          native_.sections.begin(), native_.sections.end(),
          [&](const Section& s) { return s.name == section.name && s.before_nodes == section.before_nodes; });
      if (found == native_.sections.end()) in_.fail(fmt::format("the file has no section ${}", section.name));
      section.body = std::move(found->body);
      found->name.clear();
    }
    native_.sections = std::move(joined);
  }

  Decoder& in_;
  Document& native_;
  std::vector<Index> renamed_;  // for each unknown number of the document, its position now
};

}  // namespace

std::vector<Checksum> read_supplement_head(std::string_view lines, Document& native) {
  Decoder in(lines.substr(0, lines.find('\n')), native.path);
  if (in.word() != "tetproof" || in.word() != "1") {
    native.warnings.push_back(
        fmt::format("{}: the supplement is of a version that is not known here: it is ignored", native.path));
    add_loss(native.dropped, "supplements of unknown versions", 1, native.path);
    return {};
  }
  std::vector<Checksum> checksums;
  for (std::string_view ending = in.word(); !ending.empty(); ending = in.word()) {
    Checksum& checksum = checksums.emplace_back();
    if (ending != "this") checksum.ending = ending;
    const std::string_view digits = in.word();
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), checksum.crc32, 16);
    if (error != std::errc() || end != digits.data() + digits.size()) in.fail("expected a checksum");
  }
  return checksums;
}

bool has_no_element_values(std::string_view lines) {
  return lines.find("\nelement_values 0\n") != lines.npos;  // names of fields start their lines
}

void take_back(std::string_view lines, const std::string& place, Document& native) {
  if (lines.empty()) return;
  const std::size_t head = lines.find('\n');
  Decoder in(head == lines.npos ? std::string_view{} : lines.substr(head), place);
  Joiner(in, native).join();
}

}  // namespace tetproof::io
