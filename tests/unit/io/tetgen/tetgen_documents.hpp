// SPDX-License-Identifier: GPL-3.0-or-later
// A document with everything that TetGen's files of a mesh can hold.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "io/document.hpp"

namespace tetproof::test {

inline Values integers(const char* name, int components, std::size_t first,
                       std::vector<std::int64_t> numbers) {
  return {.name = name,
          .components = components,
          .reals = {},
          .integers = std::move(numbers),
          .labels = {},
          .first = first};
}
inline Values reals(const char* name, int components, std::vector<double> numbers) {
  return {.name = name, .components = components, .reals = std::move(numbers), .integers = {}};
}

/// A tetrahedron, two of its faces and an edge, with all values that TetGen has for them.
inline Document tetgen_document() {
  Document document;
  document.points = {{0, 0, 0}, {0.1, 0, 0}, {-0.0, 1, 0}, {0, 0, 5e-324}};
  document.first_node = document.first_element = 0;
  document.blocks = {
      {.type = 4, .dim = 3, .nodes_each = 4, .count = 1},
      {.type = 2, .dim = 2, .nodes_each = 3, .count = 1, .first = 1, .nodes = 4},
      {.type = 2, .dim = 2, .groups = 1, .nodes_each = 3, .count = 1, .first = 2, .nodes = 7},
      {.type = 1, .dim = 1, .groups = 2, .nodes_each = 2, .count = 1, .first = 3, .nodes = 10}};
  document.tag_sets = {{}, {7}, {5}};
  document.connectivity = {0, 1, 2, 3, 0, 1, 2, 0, 1, 3, 2, 3};
  document.node_values = {reals("attributes", 2, {1, 2, 3, 4, 5, 6, 7, 0.1}),
                          integers("markers", 1, 0, {1, -1, 0, 9}), reals("sizes", 1, {1, 2, 3, 4})};
  document.element_values = {reals("attributes", 1, {2.25}),
                             integers("markers", 1, 0, {-7}),  // at element 1
                             integers("neighbours", 2, 1, {0, -1, -1, 0}),
                             integers("neighbours", 1, 3, {0}),
                             integers("neighbours", 4, 0, {-1, -1, -1, -1}),
                             integers("faces", 4, 0, {3, 2, 1, 0}),
                             integers("edges", 6, 0, {0, 1, 2, 3, 4, 5}),
                             integers("edges", 3, 1, {0, 1, 2, 2, 1, 0}),
                             reals("volume bounds", 1, {0.125})};
  document.element_values[1].at = {1};
  document.area_bounds = {{-7, 0.5}};
  document.length_bounds = {{{2, 3}, 0.25}};
  document.voronoi.points = {{1, 2, 3}};
  document.voronoi.edges = {{.points = {0, -1}, .direction = {0, 0, -1}}};
  document.voronoi.faces = {{.cells = {0, 1}, .edges = {0, -1}}};
  document.voronoi.cells = {{0, -1}};
  document.voronoi.first = 0;
  return document;
}

}  // namespace tetproof::test
