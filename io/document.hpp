// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh file said, whatever its format: every reader makes one, every writer takes one.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/tet_mesh.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof {

/// A run of elements of one type in one entity. The elements of a document stand block after block, in the
/// file's order.
struct ElementBlock {
  int type = 4;                 ///< Gmsh's number of the element type, see io/element_types.hpp
  int dim = 3;                  ///< dimension of the entity
  std::int64_t entity = 0;      ///< tag of the entity; 0: none
  std::int32_t groups = 0;      ///< physical groups: position in `Document::tag_sets`
  std::int32_t partitions = 0;  ///< likewise; a negative one is a ghost
  std::int32_t nodes_each = 4;
  std::size_t count = 0;
  std::size_t first = 0;  ///< position of its first element
  std::size_t nodes = 0;  ///< where its connectivity starts in `Document::connectivity`
};

/// A run of nodes of one entity; nodes that no block covers belong to none.
struct NodeBlock {
  int dim = 0;
  std::int64_t entity = 0;
  std::size_t first = 0, count = 0;
  int parameters_each = 0;     ///< parametric coordinates of each node, 0 to 3
  std::size_t parameters = 0;  ///< where they start in `Document::parameters`
};

/// A point, curve, surface or volume of the geometry that was meshed.
struct Entity {
  int dim = 0;
  std::int32_t groups = 0;  ///< physical groups: position in `Document::tag_sets`
  std::int64_t tag = 0;
  std::array<double, 6> box{};  ///< xmin ymin zmin xmax ymax zmax; a point's coordinates stand in both halves
  std::vector<std::int64_t> boundary{};  ///< signed tags of entities of one dimension less

  // Of an entity that partitioning made:
  int parent_dim = -1;          ///< -1: not partitioned
  std::int64_t parent = 0;      ///< tag of the entity that it is a part of
  std::int32_t partitions = 0;  ///< position in `Document::tag_sets`
};

/// An entity of the ghost elements of a partition.
struct GhostEntity {
  std::int64_t tag = 0, partition = 0;
};

/// The name of a physical group.
struct GroupName {
  int dim = 0;
  std::int64_t group = 0;
  std::string name;
};

/// Named values, `components` for each node or for each element; `reals` or `integers`, the other one is
/// empty.
struct Values {
  std::string name;
  int components = 1;
  std::vector<double> reals;
  std::vector<std::int64_t> integers;
};

/// A section of a .msh file that is kept as it stood.
struct Section {
  std::string name;    ///< without the dollar sign
  std::string body;    ///< from after the line `$name` to `$Endname`
  std::string format;  ///< of the file: "msh1", "msh22", "msh3", "msh40" or "msh41"
  bool binary = false;
  bool swapped = false;  ///< binary numbers of the other byte order than this machine's
  bool before_nodes = false;
};

/// A mesh with everything its file said of it. Nothing is promised but that positions stay inside their
/// arrays.
struct Document {
  std::string path;    ///< the file, for messages; empty for none
  std::string format;  ///< "msh22", "tetgen", "stl", ...; empty when no file was read

  std::vector<Eigen::Vector3d> points;
  std::vector<std::int64_t> node_tags;  ///< empty: numbered from `first_node` on
  std::int64_t first_node = 1;
  std::vector<NodeBlock> node_blocks;
  std::vector<double> parameters;

  std::vector<ElementBlock> blocks;
  std::vector<Index>
      connectivity;  ///< positions in `points`; -1-k: the number `unknown[k]`, which no node has
  std::vector<std::int64_t> element_tags;  ///< empty: numbered from `first_element` on
  std::int64_t first_element = 1;
  std::vector<std::int64_t> unknown;

  std::vector<std::vector<std::int64_t>> tag_sets{{}};  ///< each once; 0 is the empty set
  std::vector<Entity> entities;
  std::int64_t partitions = 0;  ///< how many; 0: not partitioned
  std::vector<GhostEntity> ghosts;
  std::vector<GroupName> group_names;
  std::vector<Values> node_values;     ///< of all nodes; TetGen's are called "attributes" and "markers"
  std::vector<Values> element_values;  ///< of all elements, in their order
  std::vector<Section> sections;

  std::vector<std::string> warnings;  ///< legal but suspicious, each with its place

  std::size_t elements() const { return blocks.empty() ? 0 : blocks.back().first + blocks.back().count; }
  std::int64_t node_tag(std::size_t i) const {
    return node_tags.empty() ? first_node + static_cast<std::int64_t>(i) : node_tags[i];
  }
  std::int64_t element_tag(std::size_t i) const {
    return element_tags.empty() ? first_element + static_cast<std::int64_t>(i) : element_tags[i];
  }
  /// The number that the file gave to a node of the connectivity.
  std::int64_t named(Index i) const { return i < 0 ? unknown[-1 - i] : node_tag(i); }
};

/// All tetrahedra of any order in the document's order, by their corners. Points are the document's nodes
/// without those that only stand on edges, faces or inside of elements of higher order.
TetMesh tet_mesh(const Document&);
/// How the file numbered the points and tetrahedra of `tet_mesh(document)`.
Numbering numbering(const Document&);

/// The region of each tetrahedron of `tet_mesh(document)`: the first physical group of its block, its entity
/// where it has none; TetGen's first attribute. Empty where all are in one region, or attributes are not whole
/// numbers.
std::vector<std::int64_t> tet_regions(const Document&);

/// All triangles of any order, by their corners; vertices are the document's nodes without those that
/// elements use, but none as a triangle's corner.
TriangleSurface surface_of(const Document&);

/// Tetrahedra in volume 1, numbered from 1. Indices that name no point (any number outside [0, points))
/// become unknown numbers: index i is the number i + 1, as all others.
Document document_of(const TetMesh&);
/// Triangles in surface 1, numbered from 1, indices as above.
Document document_of(const TriangleSurface&);

}  // namespace tetproof
