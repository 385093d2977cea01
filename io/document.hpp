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
  int type = 4;                 ///< Gmsh's number of the element type, see io/model/element_types.hpp
  int dim = 3;                  ///< dimension of the entity
  std::int64_t entity = 0;      ///< tag of the entity; 0: none
  std::int32_t groups = 0;      ///< physical groups: position in `Document::tag_sets`
  std::int32_t partitions = 0;  ///< likewise; a negative one is a ghost
  std::int32_t nodes_each = 4;
  std::size_t count = 0;
  std::size_t first = 0;     ///< position of its first element
  std::size_t nodes = 0;     ///< where its connectivity starts in `Document::connectivity`
  bool of_boundary = false;  ///< a polygon of TetGen's .poly or .smesh: what to mesh, not a face of the mesh
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

/// Named values, `components` for each item: a node, an element, or a node of an element. `reals` or
/// `integers`, the other one is empty.
struct Values {
  std::string name;
  int components = 1;
  std::vector<double> reals;
  std::vector<std::int64_t> integers;
  std::vector<std::string> labels;  ///< names of the integers: 0 is `labels[0]`; empty: they are just numbers

  // Of which nodes or elements: those listed in `at`, or else `items()` of them from `first` on.
  std::size_t first = 0;
  std::vector<Index> at;            ///< positions; -1-k: the number `Document::unknown[k]`, which none has
  std::vector<std::int32_t> nodes;  ///< values of elements' nodes: for each element, of how many nodes

  // Of a step of a view, as Gmsh's sections of data tell it.
  bool of_view = false;
  double time = 0;
  std::int64_t step = 0, partition = 0;
  std::string interpolation;  ///< the name of its interpolation scheme

  std::size_t size() const { return reals.empty() ? integers.size() : reals.size(); }
  /// How many nodes or elements have values.
  std::size_t items() const {
    return !nodes.empty() ? nodes.size()
           : !at.empty()  ? at.size()
                          : size() / static_cast<std::size_t>(components > 0 ? components : 1);
  }
};

/// An entity whose nodes are those of another one, moved.
struct PeriodicLink {
  int dim = 0;
  std::int64_t entity = 0, master = 0;
  std::vector<double> affine;               ///< 16 numbers row by row, or none
  std::vector<std::array<Index, 2>> nodes;  ///< positions of each node and its master; negative as in `at`
};

/// An element that other partitions see as a ghost.
struct GhostElement {
  Index element = 0;  ///< position; negative as in `Values::at`
  std::int64_t partition = 0;
  std::vector<std::int64_t> ghosts;  ///< partitions
};

/// A facet of TetGen's .poly that is more than one polygon: `polygons` elements from `first` on, of which a
/// line is an edge and a point a vertex in its plane; and a point in each of its holes.
struct Facet {
  std::size_t first = 0, polygons = 1;
  std::vector<Eigen::Vector3d> holes;
};

/// A point in a region of TetGen's .poly, and what it says of it.
struct Region {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  double attribute = 0, max_volume = -1;  ///< a bound that is not positive: none
};

/// TetGen's .var: an upper bound for the area of the triangles of a facet, or for the length of a segment.
struct AreaBound {
  std::int64_t marker = 0;
  double area = 0;
};
struct LengthBound {
  std::array<Index, 2> nodes{};  ///< negative as in `Values::at`
  double length = 0;
};

/// The Voronoi diagram in TetGen's .v.node, .v.edge, .v.face and .v.cell. Positions count from 0; -1: none.
struct Voronoi {
  struct Edge {
    std::array<Index, 2> points{};                        ///< the second -1: a ray
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< of a ray
  };
  struct Face {
    std::array<Index, 2> cells{};  ///< a cell is that of the node with this position
    std::vector<Index> edges;      ///< a last -1: it is open
  };
  std::vector<Eigen::Vector3d> points;
  std::vector<Edge> edges;
  std::vector<Face> faces;
  std::vector<std::vector<Index>> cells;  ///< faces; a last -1: it is open
  std::int64_t first = 0;                 ///< numbered from here on in the files
};

/// A column of a table: numbers, or where `lengths` is not empty a list of so many of them in each row.
struct Column {
  std::string name, type;  ///< the type as its file calls it: "float", "int32", "Float64", ...
  int components = 1;
  std::vector<double> reals;  ///< reals, integers or texts, the others are empty
  std::vector<std::int64_t> integers;
  std::vector<std::string> texts;
  std::vector<std::int32_t> lengths;
};

/// What a PLY file says of other things than vertices and faces, or VTK's field data.
struct Table {
  std::string name;
  std::size_t rows = 0;
  std::vector<Column> columns;
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

/// Something that is lost between a file and a document: an item that one has and the other does not.
struct Loss {
  std::string item;        ///< what is lost
  std::int64_t count = 0;  ///< how many of it
  std::string example;     ///< the first one
  bool elements = false;   ///< elements that the mesh lacks
};

/// A mesh with everything its file said of it. Nothing is promised but that positions stay inside their
/// arrays.
struct Document {
  std::string path;    ///< the file, for messages; empty for none
  std::string format;  ///< "msh22", "tetgen", "stl", ...; empty when no file was read
  std::string title;   ///< VTK's second line, the header of a binary STL; comments of PLY line by line

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
  std::vector<GhostElement> ghost_elements;
  std::vector<PeriodicLink> periodic;

  // TetGen's are called "attributes" and "markers", and what io/tetgen/tetgen.hpp says.
  std::vector<Values> node_values, element_values, element_node_values;

  std::vector<Facet> facets;  ///< those of more than one polygon, or with holes
  std::vector<Eigen::Vector3d> holes;
  std::vector<Region> regions;
  std::vector<AreaBound> area_bounds;
  std::vector<LengthBound> length_bounds;
  Voronoi voronoi;

  std::vector<Table> tables;
  std::vector<Section> sections;

  std::vector<std::string> warnings;  ///< legal but suspicious, each with its place
  std::vector<Loss> dropped;  ///< what the file has and the reader did not take, see io/loss/loss_list.hpp

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

/// Whether the block holds elements of dimension 3 that are no tetrahedra: hexahedra, polyhedra, ...
bool has_other_cells(const ElementBlock&);
/// The points of `tet_mesh(document)` that belong to such elements, ascending.
std::vector<Index> points_of_other_cells(const Document&);

/// The region of each tetrahedron of `tet_mesh(document)`: the first physical group of its block, its entity
/// where it has none; TetGen's first attribute. Empty where all are in one region, or attributes are not
/// whole numbers.
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
