// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model/polylines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "io/model/element_types.hpp"

namespace tetproof::io {
namespace {

bool is_polyline(const ElementBlock& block) {
  return block.type == polyline && block.nodes_each > 2 && block.count > 0;
}

class Cutter {
 public:
  explicit Cutter(const Document& document) : from_(document), to_(document) {}

  Document cut() {
    blocks();
    for (Values& values : to_.element_values) of_elements(values);
    for (Values& values : to_.element_node_values) of_corners(values);
    for (GhostElement& ghost : to_.ghost_elements)
      if (ghost.element >= 0)
        ghost.element = static_cast<Index>(start_[static_cast<std::size_t>(ghost.element)]);
    for (Facet& facet : to_.facets) facet.first = start_[facet.first];
    to_.element_tags.clear();
    return std::move(to_);
  }

 private:
  void blocks() {
    to_.blocks.clear();
    to_.connectivity.clear();
    for (ElementBlock block : from_.blocks) {
      const Index* node = from_.connectivity.data() + block.nodes;
      const std::size_t count = block.count;
      const std::int32_t each = block.nodes_each;
      const bool cut = is_polyline(block);
      block.first = to_.elements();
      block.nodes = to_.connectivity.size();
      if (cut)
        block.type = line2, block.nodes_each = 2, block.count = count * static_cast<std::size_t>(each - 1);
      for (std::size_t e = 0; e < count; ++e, node += each) {
        start_.push_back(block.first + e * static_cast<std::size_t>(cut ? each - 1 : 1));
        for (std::int32_t k = 0; cut && k + 1 < each; ++k)
          to_.connectivity.insert(to_.connectivity.end(), {node[k], node[k + 1]});
        if (!cut) to_.connectivity.insert(to_.connectivity.end(), node, node + each);
      }
      to_.blocks.push_back(std::move(block));
    }
    start_.push_back(to_.elements());
  }

  // Repeats the value of each polyline for its parts.
  void of_elements(Values& values) const {
    if (values.components < 1) return;
    const auto each = static_cast<std::size_t>(values.components);
    const std::size_t items = values.items();
    Values cut = values;
    cut.reals.clear(), cut.integers.clear(), cut.at.clear();
    for (std::size_t i = 0; i < items; ++i) {
      const std::int64_t at =
          values.at.empty() ? static_cast<std::int64_t>(values.first + i) : std::int64_t{values.at[i]};
      const bool known = at >= 0 && static_cast<std::size_t>(at) + 1 < start_.size();
      const std::size_t first = known ? start_[static_cast<std::size_t>(at)] : 0,
                        end = known ? start_[static_cast<std::size_t>(at) + 1] : 1;
      if (i == 0) cut.first = known ? first : values.first;
      for (std::size_t e = first; e < end; ++e) {
        if (!values.at.empty()) cut.at.push_back(known ? static_cast<Index>(e) : values.at[i]);
        const auto take = [&](const auto& all, auto& to) {
          if (all.size() >= (i + 1) * each)
            to.insert(to.end(), all.begin() + static_cast<std::ptrdiff_t>(i * each),
                      all.begin() + static_cast<std::ptrdiff_t>((i + 1) * each));
        };
        take(values.reals, cut.reals);
        take(values.integers, cut.integers);
      }
    }
    values = std::move(cut);
  }

  // Only polygons have values of their corners; the places of others move.
  void of_corners(Values& values) const {
    for (Index& at : values.at)
      if (at >= 0 && static_cast<std::size_t>(at) < start_.size())
        at = static_cast<Index>(start_[static_cast<std::size_t>(at)]);
    if (!values.at.empty()) return;
    for (std::size_t i = 0; i < values.nodes.size() && values.first + i < start_.size(); ++i)
      values.at.push_back(static_cast<Index>(start_[values.first + i]));
    values.first = 0;
  }

  const Document& from_;
  Document to_;
  std::vector<std::size_t> start_;  // the new position of each element, and of the end
};

}  // namespace

bool has_polylines(const Document& document) {
  return std::any_of(document.blocks.begin(), document.blocks.end(), is_polyline);
}

Document with_polylines_cut(const Document& document, std::vector<Loss>& lost) {
  std::size_t count = 0;
  const ElementBlock* first = nullptr;
  for (const ElementBlock& block : document.blocks) {
    if (!is_polyline(block)) continue;
    count += block.count;
    if (!first) first = &block;
  }
  if (first)
    lost.push_back(
        {"polylines, cut into lines", static_cast<std::int64_t>(count),
         fmt::format("element {} of {} nodes", document.element_tag(first->first), first->nodes_each),
         false});
  if (!document.element_tags.empty())
    lost.push_back({"numbers of elements", static_cast<std::int64_t>(document.elements()),
                    fmt::format("the first is {}", document.element_tag(0)), false});
  return Cutter(document).cut();
}

}  // namespace tetproof::io
