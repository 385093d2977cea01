// SPDX-License-Identifier: GPL-3.0-or-later
// Documents with everything that a mesh file can say, drawn at random and small.
#pragma once

#include <array>
#include <cstdint>
#include <ostream>

#include "io/document.hpp"

namespace tetproof::test {

/// What a random document may have besides a few tetrahedra with nodes. Each feature rolls dice of its own,
/// so that leaving one out changes nothing else.
enum class Feature {
  surface,           ///< triangles
  low_dimensions,    ///< lines and points
  quadrangles,       ///< and hexahedra, prisms, pyramids
  second_order,      ///< tetrahedra, triangles and lines
  all_types,         ///< any type with a fixed number of nodes
  polygons,          ///< of five corners and more
  repeated,          ///< elements that come twice, or name a node twice
  no_tetrahedra,     ///< only what the features above bring
  loose_nodes,       ///< that no element names
  unknown_nodes,     ///< numbers that no node has
  wild_coordinates,  ///< any double but NaN: 17 digits, -0, subnormal, infinite
  nan_coordinates,
  from_zero,  ///< numbered from 0
  node_tags,
  element_tags,
  long_tags,  ///< beyond 32 bits
  element_entities,
  node_entities,
  parameters,
  entities,  ///< with boxes and boundaries
  groups,
  several_groups,  ///< of an element, some negative
  group_names,
  partitions,
  partitioned_entities,
  ghosts,
  periodic,
  node_values,
  element_values,
  element_node_values,
  subsets,        ///< values of some nodes or elements
  unknown_at,     ///< and of some that do not exist
  integers,       ///< as values
  labels,         ///< of integers
  view_steps,     ///< values that are steps of a view
  odd_names,      ///< of groups and values: quotes, blanks, anything but line ends
  tetgen_values,  ///< attributes and markers
  boundary,       ///< polygons of a body to mesh
  facets,         ///< of several polygons, and with holes
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

/// The same document for the same recipe on every machine. Its nodes have different x, even in 32 bits.
/// Numbers of nodes and elements are positive, those of entities and groups fit 32 bits.
Document random_document(const Recipe& recipe);

}  // namespace tetproof::test
