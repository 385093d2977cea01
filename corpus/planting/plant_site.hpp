// SPDX-License-Identifier: GPL-3.0-or-later
// The tools of the kinds: the adjacency of the sound mesh, and the copy in which a defect is planted.
// Internal.
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

/// A sound mesh with its adjacency.
struct Parts {
  explicit Parts(TetMesh mesh);
  TetMesh mesh;
  std::vector<Tet> neighbours;                 ///< across the face opposite to each corner; -1: boundary
  std::vector<std::vector<Index>> tets_at;     ///< for each vertex, the tetrahedra that have it
  std::vector<std::uint8_t> on_boundary;       ///< for each vertex
  std::vector<std::array<Index, 2>> boundary;  ///< the boundary faces: tetrahedron, opposite corner
  std::vector<const char*> warned;             ///< the checks that warn before anything is planted
  Point low, high;                             ///< the bounding box
  double diagonal = 0;                         ///< of the bounding box [length]
};

/// The vertices of a face, anticlockwise as seen from outside its tetrahedron.
using Face = std::array<Index, 3>;

/// One planting: a copy of the sound mesh that is changed. Points and tetrahedra of the sound mesh keep their
/// positions in the copy. New ones are added behind them, and removed tetrahedra are only marked.
struct Site {
  Site(const Parts& given, Random& numbers, const std::vector<std::uint8_t>& not_free)
      : parts(given),
        random(numbers),
        taken(not_free),
        mesh(given.mesh),
        removed(given.mesh.tets.size(), 0) {}

  const Parts& parts;
  Random& random;
  const std::vector<std::uint8_t>& taken;  ///< for each vertex, whether it must not be used
  TetMesh mesh;                            ///< the copy
  std::vector<std::uint8_t> removed;       ///< for each tetrahedron of the copy
  std::vector<Index> vertices;             ///< vertices that are concerned, besides new and moved ones

  // The sound mesh:
  const Point& at(Index v) const { return parts.mesh.points[static_cast<std::size_t>(v)]; }
  const Tet& tet(Index t) const { return parts.mesh.tets[static_cast<std::size_t>(t)]; }
  Index tets() const { return static_cast<Index>(parts.mesh.tets.size()); }
  const std::vector<Index>& tets_at(Index v) const { return parts.tets_at[static_cast<std::size_t>(v)]; }
  Index neighbour(Index t, int corner) const {
    return parts.neighbours[static_cast<std::size_t>(t)][static_cast<std::size_t>(corner)];
  }
  bool inner(Index t) const;  ///< whether all four faces are shared
  Face face(Index t, int corner) const;
  Point normal(const Face& face) const;  ///< outward, of length twice the area
  Point centroid(const Face& face) const;
  Point centroid(Index t) const;
  double size(Index t) const;                         ///< the length of its shortest edge
  std::vector<Index> around(Index a, Index b) const;  ///< the tetrahedra at an edge
  bool free(Index t) const;                           ///< whether none of its vertices is taken
  bool free_star(Index v) const;  ///< whether the vertex has tetrahedra, and all of them are free
  double unit() const;            ///< one unit in the last place of the largest coordinate [length]
  Point within(Index t);          ///< a random point well inside a tetrahedron
  Point direction();              ///< a random unit vector
  /// A random number from 2^low to 2^high; every power of two is equally likely.
  double magnitude(int low, int high);

  /// A random free tetrahedron, or vertex with a free star, for which `fits` is true; -1 if there is none.
  Index some_tet(const std::function<bool(Index)>& fits = {});
  Index some_vertex(const std::function<bool(Index)>& fits = {});
  /// A random boundary face of a free tetrahedron, or a random face between two free ones: sets a tetrahedron
  /// of the face and the opposite corner. False if there is none.
  bool some_boundary_face(Index& t, int& corner);
  bool some_inner_face(Index& t, int& corner);

  // The copy:
  Index add(const Point& p);
  /// Adds a tetrahedron with its vertices in the order that makes it positive.
  Index add_positive(Tet tet);
  int sign(const Tet& tet) const;  ///< of its volume, exact; 0 if it is flat or has an unusable vertex
  void remove(Index t);
  /// Moves p along the axis closest to the normal of the face, from one double to the next: until it is
  /// beyond the face (wanted 1), exactly in its plane (0), or at the last double before the plane (-1). False
  /// if this fails.
  bool step_through(const Face& face, Point& p, int wanted) const;
  /// Splits each of the tetrahedra, which have the edge a b, into two at the vertex `node` on this edge.
  /// False if one of the halves is not positive.
  bool split_edge(const std::vector<Index>& tets, Index a, Index b, Index node);
  /// Adds another copy of the mesh with its own points, which `place` maps to their places.
  void add_copy(const std::function<Point(const Point&)>& place, bool wound_negative = false);
};

// The kinds, by theme.
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
