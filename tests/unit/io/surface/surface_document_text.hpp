// SPDX-License-Identifier: GPL-3.0-or-later
// A surface's document as a few lines of text; beginnings of surface files.
#pragma once

#include <fmt/format.h>

#include <string>

#include "io/document.hpp"

namespace tetproof::test {

/// One list of values, after the word that says what has them.
inline std::string text_of(const Values& values, const char* of) {
  std::string text = fmt::format("{} {} x{}{}: {}{}", of, values.name, values.components,
                                 values.integers.empty() ? "" : " i", fmt::join(values.reals, " "),
                                 fmt::join(values.integers, " "));
  if (values.first != 0) text += fmt::format(" from {}", values.first);
  if (!values.at.empty()) text += fmt::format(" at {}", fmt::join(values.at, " "));
  if (!values.nodes.empty()) text += fmt::format(" nodes {}", fmt::join(values.nodes, " "));
  if (!values.labels.empty()) text += fmt::format(" labels [{}]", fmt::join(values.labels, "|"));
  return text + "\n";
}

/// Everything in a document except its points.
inline std::string told(const Document& document) {
  std::string text = document.title.empty() ? "" : "title " + document.title + "\n";
  for (const GroupName& name : document.group_names)
    text += fmt::format("group {} {} {}\n", name.dim, name.group, name.name);
  for (const ElementBlock& block : document.blocks)
    for (std::size_t e = 0; e < block.count; ++e) {
      text += fmt::format("e{}", block.type);
      for (const std::int64_t group : document.tag_sets.at(static_cast<std::size_t>(block.groups)))
        text += fmt::format(" g{}", group);
      text += ":";
      for (int k = 0; k < block.nodes_each; ++k)
        text += fmt::format(" {}", document.named(document.connectivity.at(
                                       block.nodes + e * static_cast<std::size_t>(block.nodes_each) +
                                       static_cast<std::size_t>(k))));
      text += "\n";
    }
  for (const Values& values : document.node_values) text += text_of(values, "node");
  for (const Values& values : document.element_values) text += text_of(values, "element");
  for (const Values& values : document.element_node_values) text += text_of(values, "corner");
  for (const Table& table : document.tables) {
    text += fmt::format("table {} {}\n", table.name, table.rows);
    for (const Column& column : table.columns)
      text += fmt::format("  {} ({}) {}{}{} [{}]\n", column.name, column.type, fmt::join(column.reals, " "),
                          fmt::join(column.integers, " "), fmt::join(column.texts, "|"),
                          fmt::join(column.lengths, " "));
  }
  return text;
}

/// The four corners of a square in OFF and in OBJ, and the first lines of a PLY.
inline const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
inline const std::string obj_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
inline const std::string ply_start = "ply\nformat ascii 1.0\n";
inline const std::string ply_xyz = "property float x\nproperty float y\nproperty float z\n";
inline const std::string ply_list = "property list uchar int vertex_indices\n";

}  // namespace tetproof::test
