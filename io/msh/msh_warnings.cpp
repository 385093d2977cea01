// SPDX-License-Identifier: GPL-3.0-or-later
// Warns of content of a .msh file that is legal but probably a mistake.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "io/msh/msh_sections.hpp"

namespace tetproof::io {
namespace {

void repeated_tags(Document& document) {
  const std::vector<std::int64_t>& given = document.element_tags;
  if (std::is_sorted(given.begin(), given.end(), std::less_equal<>())) return;  // strictly ascending
  std::vector<std::int64_t> tags = given;
  std::sort(tags.begin(), tags.end());
  const auto twice = std::adjacent_find(tags.begin(), tags.end());
  if (twice != tags.end())
    document.warnings.push_back(
        fmt::format("{}: several elements have the tag {} (the first such)", document.path, *twice));
}

bool repeats_a_node(const Index* nodes, int count, std::vector<Index>& sorted) {
  if (count <= 10) {
    for (int i = 1; i < count; ++i)
      for (int k = 0; k < i; ++k)
        if (nodes[i] == nodes[k]) return true;
    return false;
  }
  sorted.assign(nodes, nodes + count);
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

void repeated_nodes(Document& document) {
  std::size_t count = 0, first = 0;
  std::vector<Index> sorted;
  for (const ElementBlock& block : document.blocks) {
    const Index* nodes = document.connectivity.data() + block.nodes;
    for (std::size_t e = 0; e < block.count; ++e, nodes += block.nodes_each)
      if (repeats_a_node(nodes, block.nodes_each, sorted) && count++ == 0) first = block.first + e;
  }
  if (count > 0)
    document.warnings.push_back(fmt::format("{}: {} element{} the same node twice; the first is element {}",
                                            document.path, count, count == 1 ? " names" : "s name",
                                            document.element_tag(first)));
}

}  // namespace

void warn_of_oddities(Document& document, const std::vector<ElementTag>& copies) {
  repeated_tags(document);
  repeated_nodes(document);
  if (!copies.empty())
    document.warnings.push_back(
        fmt::format("{}: {} element{} another one in a further physical group and {} merged with it; the "
                    "first is element {}, "
                    "which repeats element {}",
                    document.path, copies.size(), copies.size() == 1 ? " repeats" : "s repeat",
                    copies.size() == 1 ? "is" : "are", copies[0].first,
                    document.element_tag(static_cast<std::size_t>(copies[0].second))));
}

}  // namespace tetproof::io
