// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/loss/written_part.hpp"

#include <algorithm>

namespace tetproof::io {

WrittenPart::WrittenPart(const Document& document, const Holds& holds) : document_(document) {
  for (const ElementBlock& block : document.blocks) {
    const int each = holds.nodes_each(block);
    if (each == 0) {
      if (holds.cut_into) find_cut(block, holds);
      continue;
    }
    std::size_t count = block.count;
    if (!holds.unknown_nodes && !document.unknown.empty())
      for (std::size_t e = 0; e < block.count; ++e) count -= names_unknown(block, e);
    if (count > 0) blocks_.push_back({&block, each, count});
  }
  std::stable_sort(blocks_.begin(), blocks_.end(), [&](const Block& a, const Block& b) {
    return holds.kind(*a.block) < holds.kind(*b.block);
  });

  all_nodes_ = holds.which_nodes == Holds::Nodes::all && !holds.nodes_by_place;
  if (all_nodes_) return;
  nodes_ = in_order_of_elements();
  if (holds.nodes_by_place) return;
  std::vector<bool> kept(document.points.size()), used(document.points.size());
  for (const Index node : nodes_) kept[static_cast<std::size_t>(node)] = true;
  if (holds.which_nodes == Holds::Nodes::of_no_other_elements) {
    for (const Index node : document.connectivity)
      if (node >= 0) used[static_cast<std::size_t>(node)] = true;
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = kept[i] || !used[i];
  }
  nodes_.clear();
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) nodes_.push_back(static_cast<Index>(i));
}

void WrittenPart::find_cut(const ElementBlock& block, const Holds& holds) {
  for (std::size_t e = 0; e < block.count; ++e) {
    const std::size_t first = triangles_.size();
    if (!holds.cut_into(block, e, triangles_)) continue;
    const std::size_t count = triangles_.size() - first;
    const bool as_it_was = block.nodes_each == 3 && count == 1 &&
                           std::equal(triangles_[first].begin(), triangles_[first].end(), nodes_of(block, e));
    cut_.push_back({&block, e, first, count, as_it_was});
  }
}

bool WrittenPart::names_unknown(const ElementBlock& block, std::size_t e) const {
  const Index* node = nodes_of(block, e);
  return std::any_of(node, node + block.nodes_each, [](Index i) { return i < 0; });
}

std::vector<Index> WrittenPart::in_order_of_elements() const {
  std::vector<bool> seen(document_.points.size());
  std::vector<Index> nodes;
  const auto name = [&](Index node) {
    if (node < 0 || seen[static_cast<std::size_t>(node)]) return;
    seen[static_cast<std::size_t>(node)] = true;
    nodes.push_back(node);
  };
  auto cut = cut_.begin();
  const auto cut_before = [&](const ElementBlock* block) {
    for (; cut != cut_.end() && (!block || cut->block < block); ++cut)
      for (std::size_t t = cut->first; t < cut->first + cut->count; ++t)
        for (const Index node : triangles_[t]) name(node);
  };
  for (const Block& written : blocks_) {
    cut_before(written.block);
    for (std::size_t e = 0; e < written.block->count; ++e)
      for (int k = 0; k < written.nodes_each && comes_back(written, e); ++k)
        name(nodes_of(*written.block, e)[k]);
  }
  cut_before(nullptr);
  return nodes;
}

}  // namespace tetproof::io
