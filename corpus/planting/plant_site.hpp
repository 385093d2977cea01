// SPDX-License-Identifier: GPL-3.0-or-later
// Where a defect is planted: a sound mesh's parts, and the copy that is changed. Internal.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "corpus/generators/random.hpp"
#include "corpus/plant.hpp"
#include "io/tet_mesh.hpp"

namespace tetproof::corpus {

using Point = Eigen::Vector3d;
using Tet = std::array<Index, 4>;

/// How a sound mesh hangs together.
struct Parts {
  explicit Parts(TetMesh mesh);
  TetMesh mesh;
  std::vector<Tet> neighbours;                 ///< across the face opposite to each corner; -1: boundary
  std::vector<std::vector<Index>> tets_at;     ///< of each vertex
  std::vector<std::uint8_t> on_boundary;       ///< of each vertex
  std::vector<std::array<Index, 2>> boundary;  ///< faces: tetrahedron, corner opposite
  std::vector<const char*> warned;  ///< checks that find something to warn of before anything is planted
  Point low, high;
  double diagonal = 0;
};

/// A face seen from outside its tetrahedron.
using Face = std::array<Index, 3>;

/// One planting. The copy keeps the positions of the sound mesh's points and tetrahedra: new ones stand
/// behind, and what is removed is only marked.
struct Site {
  Site(const Parts& given, Random& numbers, const std::vector<std::uint8_t>& not_free)
      : parts(given),
        random(numbers),
        taken(not_free),
        mesh(given.mesh),
        removed(given.mesh.tets.size(), 0) {}

  const Parts& parts;
  Random& random;
  const std::vector<std::uint8_t>& taken;  ///< vertices that are not to be used
  TetMesh mesh;
  std::vector<std::uint8_t> removed;
  std::vector<Index> vertices;  ///< concerned, besides those that the copy shows to be new or moved

  // Of the sound mesh:
  const Point& at(Index v) const { return parts.mesh.points[static_cast<std::size_t>(v)]; }
  const Tet& tet(Index t) const { return parts.mesh.tets[static_cast<std::size_t>(t)]; }
  Index tets() const { return static_cast<Index>(parts.mesh.tets.size()); }
  const std::vector<Index>& tets_at(Index v) const { return parts.tets_at[static_cast<std::size_t>(v)]; }
  Index neighbour(Index t, int corner) const {
    return parts.neighbours[static_cast<std::size_t>(t)][static_cast<std::size_t>(corner)];
  }
  bool inner(Index t) const;  ///< all four faces are shared
  Face face(Index t, int corner) const;
  Point normal(const Face& face) const;  ///< twice its area, outwards
  Point centroid(const Face& face) const;
  Point centroid(Index t) const;
  double size(Index t) const;                         ///< its shortest edge
  std::vector<Index> around(Index a, Index b) const;  ///< tetrahedra at an edge
  bool free(Index t) const;
  bool free_star(Index v) const;        ///< all tetrahedra at the vertex are
  double unit() const;                  ///< how far apart points of the mesh's place are at least
  Point within(Index t);                ///< a random point well inside
  Point direction();                    ///< random, of length 1
  double magnitude(int low, int high);  ///< random, from 2^low to 2^high, every power as likely

  /// A random one of those that fit, among free tetrahedra, or vertices with free stars; -1: none.
  Index some_tet(const std::function<bool(Index)>& fits = {});
  Index some_vertex(const std::function<bool(Index)>& fits = {});
  /// A random face of one tetrahedron, which is free: tetrahedron and corner. False: none.
  bool some_boundary_face(Index& t, int& corner);
  bool some_inner_face(Index& t, int& corner);

  // Of the copy:
  Index add(const Point& p);
  /// With its vertices in the order that makes it positive.
  Index add_positive(Tet tet);
  int sign(const Tet& tet) const;  ///< of its volume, exactly; 0 if it has none
  void remove(Index t);
  /// Moves p by single steps of doubles along the steepest axis of the face until it is on its other side
  /// (wanted 1) or in its plane (0); or to the last place before it (-1). False: not reached.
  bool step_through(const Face& face, Point& p, int wanted) const;
  /// Replaces tetrahedra with the edge a b by two each, with the vertex `node` on it. False if one is not
  /// positive.
  bool split_edge(const std::vector<Index>& tets, Index a, Index b, Index node);
  /// Adds another copy of the mesh, with points of its own.
  void add_copy(const std::function<Point(const Point&)>& place, bool wound_negative = false);
};

// The kinds by theme.
std::vector<PlantKind> number_kinds();       // plant_numbers.cpp
std::vector<PlantKind> orientation_kinds();  // plant_orientation.cpp
std::vector<PlantKind> push_kinds();         // plant_pushes.cpp
std::vector<PlantKind> thin_kinds();         // plant_thin.cpp
std::vector<PlantKind> copy_kinds();         // plant_copies.cpp
std::vector<PlantKind> overlap_kinds();      // plant_overlaps.cpp
std::vector<PlantKind> contact_kinds();      // plant_contacts.cpp
std::vector<PlantKind> conformity_kinds();   // plant_conformity.cpp
std::vector<PlantKind> crack_kinds();        // plant_cracks.cpp
std::vector<PlantKind> missing_kinds();      // plant_missing.cpp

}  // namespace tetproof::corpus
