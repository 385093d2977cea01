// SPDX-License-Identifier: GPL-3.0-or-later
// A document as a few lines of text, for tests to write down what they expect.
#pragma once

#include <fmt/format.h>

#include <string>

#include "io/document.hpp"

namespace tetproof::test {

/// Nodes as "n TAG X Y Z", elements as "e TAG TYPE DIM/ENTITY gGROUPS pPARTITIONS: NODES" (?N: a node N that
/// does not exist), node blocks as "N DIM/ENTITY COUNT: PARAMETERS", entities as "E DIM/TAG BOX gGROUPS
/// bBOUNDARY (PARENT pPARTITIONS)". Doubles are the shortest text that names them.
inline std::string text_of(const Document& document, bool with_format = true) {
  std::string text = with_format ? document.format + "\n" : "";
  for (const GroupName& name : document.group_names)
    text += fmt::format("G {} {} {}\n", name.dim, name.group, name.name);
  for (const Entity& entity : document.entities) {
    text += fmt::format("E {}/{} {} g{} b{}", entity.dim, entity.tag, fmt::join(entity.box, " "),
                        fmt::join(document.tag_sets.at(entity.groups), ","), fmt::join(entity.boundary, ","));
    if (entity.parent_dim >= 0)
      text += fmt::format(" ({}/{} p{})", entity.parent_dim, entity.parent,
                          fmt::join(document.tag_sets.at(entity.partitions), ","));
    text += "\n";
  }
  for (const GhostEntity& ghost : document.ghosts)
    text += fmt::format("ghost {} {}\n", ghost.tag, ghost.partition);
  for (std::size_t i = 0; i < document.points.size(); ++i)
    text += fmt::format("n {} {}\n", document.node_tag(i),
                        fmt::join(document.points[i].data(), document.points[i].data() + 3, " "));
  for (const NodeBlock& block : document.node_blocks) {
    const double* parameters = document.parameters.data() + block.parameters;
    text += fmt::format("N {}/{} {}: {}\n", block.dim, block.entity, block.count,
                        fmt::join(parameters, parameters + block.count * block.parameters_each, " "));
  }
  for (const ElementBlock& block : document.blocks)
    for (std::size_t e = 0; e < block.count; ++e) {
      text += fmt::format("e {} {} {}/{} g{} p{}:", document.element_tag(block.first + e), block.type,
                          block.dim, block.entity, fmt::join(document.tag_sets.at(block.groups), ","),
                          fmt::join(document.tag_sets.at(block.partitions), ","));
      for (int k = 0; k < block.nodes_each; ++k) {
        const Index i = document.connectivity.at(block.nodes + e * block.nodes_each + k);
        text += i < 0 ? fmt::format(" ?{}", document.unknown.at(-1 - i))
                      : fmt::format(" {}", document.node_tag(i));
      }
      text += "\n";
    }
  const auto node = [&](Index i) {
    return i < 0 ? fmt::format("?{}", document.unknown.at(static_cast<std::size_t>(-1 - i)))
                 : fmt::format("{}", document.node_tag(static_cast<std::size_t>(i)));
  };
  const auto element = [&](Index i) {
    return i < 0 ? fmt::format("?{}", document.unknown.at(static_cast<std::size_t>(-1 - i)))
                 : fmt::format("{}", document.element_tag(static_cast<std::size_t>(i)));
  };
  const auto add_values = [&](const std::vector<Values>& all, const char* of, const auto& name) {
    for (const Values& v : all) {
      text += fmt::format("v {} {} {}", of, v.name, v.components);
      if (v.of_view) text += fmt::format(" view {} {} {} [{}]", v.time, v.step, v.partition, v.interpolation);
      if (v.of_view || v.first != 0 || !v.at.empty()) {
        text += " at";
        for (std::size_t i = 0; i < v.items(); ++i)
          text.append(" ").append(name(v.at.empty() ? static_cast<Index>(v.first + i) : v.at[i]));
      }
      if (!v.nodes.empty()) text += fmt::format(" of {}", fmt::join(v.nodes, " "));
      text += fmt::format(": {}{}\n", fmt::join(v.reals, " "), fmt::join(v.integers, " "));
    }
  };
  add_values(document.node_values, "nodes", node);
  add_values(document.element_values, "elements", element);
  add_values(document.element_node_values, "elements' nodes", element);
  for (const PeriodicLink& link : document.periodic) {
    text += fmt::format("periodic {}/{} {} ({}):", link.dim, link.entity, link.master,
                        fmt::join(link.affine, " "));
    for (const auto& [one, master] : link.nodes) text += fmt::format(" {}-{}", node(one), node(master));
    text += "\n";
  }
  for (const GhostElement& ghost : document.ghost_elements)
    text += fmt::format("ghost element {} {}: {}\n", element(ghost.element), ghost.partition,
                        fmt::join(ghost.ghosts, " "));
  for (const Section& section : document.sections)
    text += fmt::format("S {}{} [{}]\n", section.before_nodes ? "^" : "", section.name, section.body);
  return text;
}

}  // namespace tetproof::test
