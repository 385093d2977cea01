// SPDX-License-Identifier: GPL-3.0-or-later
// Small random documents with everything that a mesh file can say.
#pragma once

#include <array>
#include <cstdint>
#include <ostream>

#include "io/document.hpp"

namespace tetproof::test {

/// Features of a random document, besides a few tetrahedra with nodes. Each feature has its own random
/// numbers, so switching one off changes nothing else.
enum class Feature {
  surface,           ///< triangles
  low_dimensions,    ///< lines and points
  quadrangles,       ///< and hexahedra, prisms, pyramids
  second_order,      ///< tetrahedra, triangles and lines
  all_types,         ///< any type with a fixed number of nodes
  polygons,          ///< with five or more corners
  repeated,          ///< elements that occur twice, or name a node twice
  no_tetrahedra,     ///< only elements of the features above
  loose_nodes,       ///< nodes that no element names
  unknown_nodes,     ///< numbers that no node has
  wild_coordinates,  ///< any double except NaN: 17 digits, -0, subnormal, infinite
  nan_coordinates,
  from_zero,  ///< numbered from 0
  node_tags,
  element_tags,
  long_tags,  ///< numbers beyond 32 bits
  element_entities,
  node_entities,
  parameters,
  entities,  ///< with boxes and boundaries
  groups,
  several_groups,  ///< several groups of an element, some of them negative
  group_names,
  partitions,
  partitioned_entities,
  ghosts,
  periodic,
  node_values,
  element_values,
  element_node_values,
  subsets,        ///< values of only some nodes or elements
  unknown_at,     ///< values of nodes or elements that do not exist
  integers,       ///< integer values
  labels,         ///< for integer values
  view_steps,     ///< values that are steps of a view
  odd_names,      ///< names with quotes, blanks, anything except line ends
  tetgen_values,  ///< attributes and markers
  boundary,       ///< polygons of a body to mesh
  facets,         ///< facets of several polygons, and with holes
  regions,        ///< and holes
  bounds,
  voronoi,
  tables,
  sections,
  title,
  count
};
constexpr std::size_t features = static_cast<std::size_t>(Feature::count);

struct Recipe {
  std::uint64_t seed = 0;
  int nodes = 0;
  std::array<bool, features> with{};

  bool has(Feature feature) const { return with[static_cast<std::size_t>(feature)]; }
  friend std::ostream& operator<<(std::ostream& out, const Recipe& recipe);
};

/// Gives the same document for the same recipe on every machine. All nodes have different x, even as 32-bit
/// numbers. Numbers of nodes and elements are positive; numbers of entities and groups fit 32 bits.
Document random_document(const Recipe& recipe);

}  // namespace tetproof::test
