// SPDX-License-Identifier: GPL-3.0-or-later
// What we understand of a .msh file, in the lines in which gmsh_listing.py says what Gmsh does.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/document.hpp"

namespace tetproof::test {

using Listing = std::multiset<std::string>;

inline std::string bits(double x) {
  return fmt::format("{:016x}", std::bit_cast<std::uint64_t>(x));
}

template <class Numbers>
std::string joined(const Numbers& numbers) {
  return fmt::format("{}", fmt::join(numbers, " "));
}

inline std::string place(int dim, std::int64_t tag) {
  return fmt::format("{} {}", dim, tag);
}

inline void list_nodes(const Document& document, Listing& out) {
  for (std::size_t i = 0; i < document.points.size(); ++i) {
    const auto& p = document.points[i];
    out.insert(fmt::format("node {} {} {} {}", document.node_tag(i), bits(p.x()), bits(p.y()), bits(p.z())));
  }
  for (const NodeBlock& block : document.node_blocks)
    for (std::size_t i = block.first; i < block.first + block.count; ++i)
      out.insert(fmt::format("node {} in {}", document.node_tag(i), place(block.dim, block.entity)));
}

inline std::string element_text(const Document& document, const ElementBlock& block, std::size_t e,
                                const std::string& where) {
  std::string line =
      fmt::format("element {} {} in {}:", document.element_tag(block.first + e), block.type, where);
  const auto each = static_cast<std::size_t>(block.nodes_each);
  for (std::size_t k = 0; k < each; ++k)
    line += fmt::format(" {}", document.named(document.connectivity[block.nodes + e * each + k]));
  return line;
}

inline void list_elements(const Document& document, Listing& out) {
  for (const ElementBlock& block : document.blocks)
    for (std::size_t e = 0; e < block.count; ++e)
      out.insert(element_text(document, block, e, place(block.dim, block.entity)));
}

inline void list_entities(const Document& document, Listing& out) {
  std::map<std::pair<int, std::int64_t>, std::set<std::int64_t>> groups;
  const auto add = [&](int dim, std::int64_t tag, std::int32_t set) {
    auto& all = groups[{dim, tag}];
    for (std::int64_t group : document.tag_sets[set]) all.insert(std::abs(group));
  };
  for (const NodeBlock& block : document.node_blocks) add(block.dim, block.entity, 0);
  for (const ElementBlock& block : document.blocks) add(block.dim, block.entity, block.groups);
  for (const Entity& entity : document.entities) {
    add(entity.dim, entity.tag, entity.groups);
    const std::string where = place(entity.dim, entity.tag);
    std::vector<std::int64_t> boundary = entity.boundary;
    std::sort(boundary.begin(), boundary.end());
    if (!boundary.empty()) out.insert(fmt::format("boundary {}: {}", where, joined(boundary)));
    if (entity.parent_dim >= 0) {
      std::vector<std::int64_t> partitions = document.tag_sets[entity.partitions];
      std::sort(partitions.begin(), partitions.end());
      out.insert(fmt::format("partitions {} ({}): {}", where, place(entity.parent_dim, entity.parent),
                             joined(partitions)));
    }
  }
  for (const auto& [key, tags] : groups) {
    out.insert(fmt::format("entity {}", place(key.first, key.second)));
    if (!tags.empty()) out.insert(fmt::format("groups {}: {}", place(key.first, key.second), joined(tags)));
  }
  for (const GroupName& name : document.group_names)
    out.insert(fmt::format("name {} {}", place(name.dim, name.group), name.name));
}

// Gmsh shows each ghost element once more, in the entity of each partition that has it as a ghost.
inline void list_ghosts(const Document& document, Listing& out) {
  int dim = 0;
  for (const ElementBlock& block : document.blocks) dim = std::max(dim, block.dim);
  for (const GhostEntity& ghost : document.ghosts) {
    const std::string where = place(dim, ghost.tag);
    out.insert(fmt::format("entity {}", where));
    out.insert(fmt::format("partitions {} (-1 -1): {}", where, ghost.partition));
    for (const GhostElement& element : document.ghost_elements) {
      if (element.element < 0) continue;
      if (std::find(element.ghosts.begin(), element.ghosts.end(), ghost.partition) == element.ghosts.end())
        continue;
      const auto position = static_cast<std::size_t>(element.element);
      const auto block = std::find_if(document.blocks.begin(), document.blocks.end(),
                                      [&](const auto& b) { return position < b.first + b.count; });
      out.insert(element_text(document, *block, position - block->first, where));
    }
  }
}

inline void list_periodic(const Document& document, Listing& out) {
  for (const PeriodicLink& link : document.periodic) {
    std::string line = fmt::format("periodic {} {} ", place(link.dim, link.entity), link.master);
    for (std::size_t i = 0; i < link.affine.size(); ++i)
      line.append(i ? " " : "").append(bits(link.affine[i]));
    std::vector<std::pair<std::int64_t, std::int64_t>> nodes;
    for (const auto& pair : link.nodes) nodes.push_back({document.named(pair[0]), document.named(pair[1])});
    std::sort(nodes.begin(), nodes.end());
    line += ":";
    for (const auto& [node, master] : nodes) line += fmt::format(" {}-{}", node, master);
    out.insert(line);
  }
}

inline void list_data(const Document& document, const std::vector<Values>& all, const std::string& kind,
                      Listing& out) {
  for (const Values& values : all) {
    if (!values.of_view) continue;
    const std::string start = fmt::format("data {} {} {} {} {} ", kind, values.name, values.step,
                                          bits(values.time), values.components);
    std::size_t at = 0;
    for (std::size_t i = 0; i < values.items(); ++i) {
      const std::size_t each =
          static_cast<std::size_t>(values.components) * (values.nodes.empty() ? 1 : values.nodes[i]);
      const Index position = values.at.empty() ? static_cast<Index>(values.first + i) : values.at[i];
      const std::int64_t tag = position < 0         ? document.unknown[-1 - position]
                               : kind == "NodeData" ? document.node_tag(position)
                                                    : document.element_tag(position);
      std::string line = fmt::format("{}{}:", start, tag);
      for (std::size_t k = 0; k < each; ++k)
        line.append(" ").append(bits(values.reals.empty() ? static_cast<double>(values.integers.at(at + k))
                                                          : values.reals.at(at + k)));
      at += each;
      out.insert(line);
    }
  }
}

inline Listing listing_of(const Document& document) {
  Listing out;
  list_nodes(document, out);
  list_elements(document, out);
  list_entities(document, out);
  list_ghosts(document, out);
  list_periodic(document, out);
  list_data(document, document.node_values, "NodeData", out);
  list_data(document, document.element_values, "ElementData", out);
  list_data(document, document.element_node_values, "ElementNodeData", out);
  return out;
}

}  // namespace tetproof::test
