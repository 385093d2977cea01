// SPDX-License-Identifier: GPL-3.0-or-later
// The content of a mesh file of any format: every reader makes a document, every writer takes one.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/tet_mesh.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof {

/// A run of elements of one type in one entity. The blocks of a document follow each other in the file's
/// order.
struct ElementBlock {
  int type = 4;                 ///< the number of the element type, see io/model/element_types.hpp
  int dim = 3;                  ///< dimension of the entity
  std::int64_t entity = 0;      ///< tag of the entity; 0: none
  std::int32_t groups = 0;      ///< physical groups: position in `Document::tag_sets`
  std::int32_t partitions = 0;  ///< partitions: position there; ghosts are `Document::ghost_elements`
  std::int32_t nodes_each = 4;
  std::size_t count = 0;
  std::size_t first = 0;  ///< position of its first element
  std::size_t nodes = 0;  ///< where its connectivity starts in `Document::connectivity`
  bool of_boundary =
      false;  ///< a polygon of a .poly or .smesh: of the boundary to mesh, not a face of a mesh

  /// Of polyhedra: for each face the number of its corners, and then these as places among the nodes of the
  /// element. All polyhedra of a block have the same faces. Empty: the file does not tell.
  std::vector<std::int32_t> faces{};
};

/// A run of nodes of one entity. Nodes that no block covers belong to no entity.
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
  std::array<double, 6> box{};  ///< xmin ymin zmin xmax ymax zmax; of a point: its coordinates, twice
  std::vector<std::int64_t> boundary{};  ///< signed tags of entities of one dimension less

  // For an entity that partitioning made:
  int parent_dim = -1;          ///< -1: not partitioned
  std::int64_t parent = 0;      ///< tag of the entity of which it is a part
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

/// Named values, `components` numbers for each item: a node, an element, or a node of an element. Either
/// `reals` or `integers` has them, the other is empty.
struct Values {
  std::string name;
  int components = 1;
  std::vector<double> reals;
  std::vector<std::int64_t> integers;
  std::vector<std::string> labels;  ///< names of the integers: `labels[0]` is that of 0; empty: plain numbers

  // The nodes or elements that have values: those listed in `at`, or else `items()` of them from `first` on.
  std::size_t first = 0;
  std::vector<Index> at;            ///< positions; -1-k: the number `Document::unknown[k]`, which none has
  std::vector<std::int32_t> nodes;  ///< for values of elements' nodes: the number of nodes of each element

  // The step of a view, as in Gmsh's sections of data.
  bool of_view = false;
  double time = 0;
  std::int64_t step = 0, partition = 0;
  std::string interpolation;  ///< the name of its interpolation scheme

  std::vector<std::string> roles{};  ///< in VTK's attributes: "Scalars", "Vectors", "GlobalIds", ...
  bool texts = false;                ///< VTK's files have the labels as texts in place of the integers

  /// By which power of lengths they grow with the mesh, where a join has left no format that tells. 0: not,
  /// or the format tells.
  int length_power = 0;

  std::size_t size() const { return reals.empty() ? integers.size() : reals.size(); }
  /// The number of nodes or elements that have values.
  std::size_t items() const {
    return !nodes.empty() ? nodes.size()
           : !at.empty()  ? at.size()
                          : size() / static_cast<std::size_t>(components > 0 ? components : 1);
  }
};

/// An entity whose nodes are those of another entity, moved.
struct PeriodicLink {
  int dim = 0;
  std::int64_t entity = 0, master = 0;
  std::vector<double> affine;               ///< 16 numbers row by row, none, or what else a .msh 4.1 has
  std::vector<std::array<Index, 2>> nodes;  ///< positions of each node and its master; negative as in `at`
};

/// An element that other partitions see as a ghost.
struct GhostElement {
  Index element = 0;  ///< position; negative as in `Values::at`
  std::int64_t partition = 0;
  std::vector<std::int64_t> ghosts;  ///< partitions
};

/// A facet of TetGen's .poly that is more than one polygon: `polygons` elements from `first` on. A line among
/// them is an edge in the facet's plane, a point a vertex in it. `holes`: a point in each of its holes.
struct Facet {
  std::size_t first = 0, polygons = 1;
  std::vector<Eigen::Vector3d> holes;
};

/// A point in a region of TetGen's .poly, with the region's attribute and bound.
struct Region {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  double attribute = 0, max_volume = -1;  ///< not positive: no bound
};

/// Bounds in TetGen's .var: for the area of the triangles of a facet, and for the length of a segment.
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
    std::array<Index, 2> cells{};  ///< positions of the nodes whose cells these are
    std::vector<Index> edges;      ///< -1 as the last: the face is open
  };
  std::vector<Eigen::Vector3d> points;
  std::vector<Edge> edges;
  std::vector<Face> faces;
  std::vector<std::vector<Index>> cells;  ///< faces of each; -1 as the last: the cell is open
  std::int64_t first = 0;                 ///< the first number in the files
};

/// A column of a table: a number or text in each row, or a list in each row if `lengths` is not empty.
struct Column {
  std::string name, type;  ///< the type by its name in the file: "float", "int32", "Float64", ...
  int components = 1;
  std::vector<double> reals;  ///< one of reals, integers and texts; the others are empty
  std::vector<std::int64_t> integers;
  std::vector<std::string> texts;
  std::vector<std::int32_t> lengths;
};

/// An element of a PLY file that is neither vertices, faces nor edges; or VTK's field data.
struct Table {
  std::string name;
  std::size_t rows = 0;
  std::vector<Column> columns;
};

/// A section of a .msh file that is kept as it is.
struct Section {
  std::string name;    ///< without the dollar sign
  std::string body;    ///< from after the line `$name` to `$Endname`
  std::string format;  ///< of the file: "msh1", "msh22", "msh3", "msh40" or "msh41"
  bool binary = false;
  bool swapped = false;  ///< binary numbers of the other byte order than this machine's
  bool before_nodes = false;
};

/// An item that a file has and its document has not, or the other way round.
struct Loss {
  std::string item;        ///< the kind of thing that is lost
  std::int64_t count = 0;  ///< how many of it
  std::string example;     ///< the first of them
  bool elements = false;   ///< elements that the mesh, or what is written of it, lacks
};

/// A mesh with everything in its file. The only promise is that positions stay inside their arrays.
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
  /// Whether numbers are those of files, where a join has left no format that tells.
  bool numbers_nodes = false, numbers_elements = false;

  std::vector<std::vector<std::int64_t>> tag_sets{{}};  ///< each once; 0 is the empty set
  std::vector<Entity> entities;
  std::int64_t partitions = 0;  ///< how many; 0: not partitioned
  std::vector<GhostEntity> ghosts;
  std::vector<GroupName> group_names;
  std::string
      group_word;  ///< what the file calls its array of groups, where it is VTK's; empty: as we call it
  std::vector<GhostElement> ghost_elements;
  std::vector<PeriodicLink> periodic;

  // io/tetgen/tetgen.hpp lists the names of TetGen's: "attributes", "markers", ...
  std::vector<Values> node_values, element_values, element_node_values;

  std::vector<Facet> facets;  ///< only those of more than one polygon, or with holes
  std::vector<Eigen::Vector3d> holes;
  std::vector<Region> regions;
  std::vector<AreaBound> area_bounds;
  std::vector<LengthBound> length_bounds;
  Voronoi voronoi;

  std::vector<Table> tables;
  std::vector<Section> sections;

  std::vector<std::string> warnings;  ///< of what is legal but suspicious, each with its place
  std::vector<Loss> dropped;          ///< items of the file that the reader did not take

  std::size_t elements() const { return blocks.empty() ? 0 : blocks.back().first + blocks.back().count; }
  std::int64_t node_tag(std::size_t i) const {
    return node_tags.empty() ? first_node + static_cast<std::int64_t>(i) : node_tags[i];
  }
  std::int64_t element_tag(std::size_t i) const {
    return element_tags.empty() ? first_element + static_cast<std::int64_t>(i) : element_tags[i];
  }
  /// The number of a node of the connectivity in the file.
  std::int64_t named(Index i) const { return i < 0 ? unknown[-1 - i] : node_tag(i); }
};

/// All tetrahedra of any order, by their corners, in the document's order. Points are the document's nodes,
/// without nodes that are no corner but lie on edges, on faces or inside of elements of higher order.
TetMesh tet_mesh(const Document&);
/// The file's numbers of the points and tetrahedra of `tet_mesh(document)`.
Numbering numbering(const Document&);

/// Whether the block holds elements of dimension 3 that are no tetrahedra: hexahedra, polyhedra, ...
bool has_other_cells(const ElementBlock&);
/// The points of `tet_mesh(document)` that belong to such elements, ascending.
std::vector<Index> points_of_other_cells(const Document&);

/// The region of each tetrahedron of `tet_mesh(document)`: the first physical group of its block, or its
/// entity if it has none; for TetGen, its first attribute. A group and an entity of the same number are two
/// regions. Empty if all are in one region, or if attributes are not whole numbers.
TetRegions tet_regions(const Document&);

/// The document's faces as triangles: triangles and quadrangles of any order by their corners, and polygons.
/// Elements of other dimensions are passed over.
///
/// Vertices are the document's nodes in their order, without the nodes that elements use but none as a corner
/// of a face. They are welded by exact equality: the first of equal ones stays (-0 equals 0; NaN equals
/// nothing). A triangle stays as it is, degenerate or not. Of a larger polygon, corners that repeat the one
/// before are dropped first: a quadrangle with a collapsed side is a triangle, and one that collapses
/// altogether leaves one degenerate triangle. Polygons, and TetGen's facets of several polygons and with
/// holes, are cut by the rules of io/surface/cutting.hpp: convex ones into a fan, others by a constrained
/// Delaunay triangulation, and quadrangles that are not planar along their shorter diagonal.
///
/// Facets of a .poly or .smesh, which have no direction and may stand inside of solids: what is left is the
/// surface of the solids, wound outwards (io/surface/solid_boundary.hpp), unless the facets enclose none.
///
/// InputError, naming the element by its number: there are no faces; a face names a node that does not exist,
/// has fewer than three corners, or crosses itself.
TriangleSurface surface_of(const Document&);
/// Likewise; `warnings` gets a line if polygons are not planar (how many, and the largest bend), and one if
/// facets were turned or left out.
TriangleSurface surface_of(const Document&, std::vector<std::string>& warnings);

/// Whether the facets of a .poly or .smesh mean the same body if they are taken for the faces of any other
/// surface: they are the surface of its solids, all of it, wound outwards, and there are no cells.
bool facets_are_surface(const Document&);

/// Tetrahedra in volume 1, numbered from 1. An index i that names no point (outside [0, points)) becomes the
/// unknown number i + 1.
Document document_of(const TetMesh&);
/// Triangles in surface 1, numbered from 1; indices as above. (u,v) become OBJ's values "texture" (`vt`).
Document document_of(const TriangleSurface&);

}  // namespace tetproof
