// SPDX-License-Identifier: GPL-3.0-or-later
// A tetrahedron, and a document with everything that a mesh file can hold.
#pragma once

#include "io/mesh_files.hpp"

namespace tetproof::test {

inline const TetMesh one_tet{{{0, 0, 0}, {0.1, 0, 0}, {0, 5e-324, 0}, {-0., 0, 1e22}}, {{0, 1, 2, 3}}};

/// A document with everything: two tetrahedra (one of second order), a triangle in two groups, sparse
/// numbers, a node that does not exist, parameters, a boundary, attributes, and a section of another program.
inline Document rich_document() {
  Document document;
  document.format = "msh41";
  document.path = "rich.msh";
  document.points = {{0, 0, 0},    {0.1, 0, 0}, {0, 1, 0},  {0, 0, 1},   {.05, 0, 0},
                     {.05, .5, 0}, {0, .5, 0},  {0, 0, .5}, {0, .5, .5}, {.05, 0, .5}};
  document.node_tags = {10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
  document.node_blocks = {{.dim = 2, .entity = 6, .first = 0, .count = 3, .parameters_each = 2},
                          {.dim = 3, .entity = 5, .first = 3, .count = 7}};
  document.parameters = {0, 0, 1, 0, 0, 1};
  document.tag_sets = {{}, {7, 8}, {9}};
  document.blocks = {
      {.type = 11, .dim = 3, .entity = 5, .groups = 2, .nodes_each = 10, .count = 1},
      {.type = 4, .dim = 3, .entity = 5, .groups = 2, .nodes_each = 4, .count = 1, .first = 1, .nodes = 10},
      {.type = 2, .dim = 2, .entity = 6, .groups = 1, .nodes_each = 3, .count = 1, .first = 2, .nodes = 14}};
  document.connectivity = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 1, 2, -1, 0, 1, 2};
  document.element_tags = {5, 3, 9};
  document.unknown = {999};
  document.entities = {{.dim = 2, .groups = 1, .tag = 6, .box = {0, 0, 0, 0.1, 1, 0}},
                       {.dim = 3, .groups = 2, .tag = 5, .box = {0, 0, 0, 0.1, 1, 1}, .boundary = {-6}}};
  document.group_names = {{2, 7, "skin"}};
  document.node_values.push_back(
      {.name = "markers", .components = 1, .reals = {}, .integers = std::vector<std::int64_t>(10, 1)});
  document.element_values.push_back(
      {.name = "attributes", .components = 1, .reals = {2.25, 0, 0}, .integers = {}});
  document.sections = {{.name = "Periodic", .body = "0\n", .format = "msh41"},
                       {.name = "Mine", .body = "x\n", .format = "msh41"}};
  return document;
}

}  // namespace tetproof::test
