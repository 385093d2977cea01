// SPDX-License-Identifier: GPL-3.0-or-later
// The truth about a mesh, by brute force with exact numbers. It is a second opinion on the judge in verify/,
// with which it shares no code.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::corpus {

/// A vertex that lies in a tetrahedron, inside or on its boundary, and is not one of its vertices.
struct Touch {
  Index vertex, tet;
  auto operator<=>(const Touch&) const = default;
};

/// The facts about a mesh. Numbers are positions in the arrays of the mesh, from 0. All lists ascend.
struct Truth {
  // Unusable tetrahedra:
  std::vector<Index> out_of_range;  ///< name a point that does not exist
  std::vector<Index> not_finite;    ///< name a point with a coordinate that is not finite
  std::vector<Index> repeating;     ///< name a point twice
  // The other tetrahedra, and the points. A boundary face is a face of exactly one tetrahedron.
  /// All tetrahedra are positive with vertex numbers lower by this, and not all are as they are. 0: none
  /// such.
  Index shift = 0;
  std::vector<std::vector<Index>> duplicates;  ///< groups with the same four vertices
  /// Groups whose four vertices have the same coordinates, but not the same numbers.
  std::vector<std::vector<Index>> copies;
  std::vector<Index> negative, flat;            ///< exact; only among the tetrahedra asked for
  std::vector<std::vector<Index>> thrice;       ///< groups of three or more that share a face
  std::vector<std::array<Index, 2>> one_sided;  ///< pairs that give a common face the same orientation
  /// Pairs whose boundary faces have the same coordinates and opposite orientations, but not the same points.
  std::vector<std::array<Index, 2>> coinciding_faces;
  std::vector<std::array<Index, 2>> nonmanifold_edges;  ///< edges of more than two boundary faces
  std::vector<Index> nonmanifold_vertices;  ///< vertices whose boundary faces form more than one fan
  /// The first point with some finite coordinates, and another one with the same coordinates.
  std::vector<std::array<Index, 2>> equal_points;
  std::vector<Index> unused;  ///< points of no tetrahedron
  // Pairs of tetrahedra, at least one of them asked for; neither is flat, and they are not duplicates:
  std::vector<std::array<Index, 2>> overlaps;   ///< their interiors meet
  std::vector<Touch> touches;                   ///< between tetrahedra whose interiors do not meet
  std::vector<std::array<Index, 2>> crossings;  ///< likewise, and an edge of one crosses an edge of the other
  /// Likewise, and a face of one and a face of the other lie in one plane and have an area in common, but not
  /// all three corners.
  std::vector<std::array<Index, 2>> touching_faces;
  bool all = true;  ///< false: the search for pairs stopped early, at `most_pairs`

  /// Whether the tetrahedra asked for triangulate the space that they cover: each one is positive, and two of
  /// them meet in a common vertex, edge or face, or not at all.
  bool valid() const;
  /// Whether the mesh has what the check with this id looks for. The ids are those of `tetproof-verify
  /// --list-checks`. Checks about near contacts, hanging nodes, crossed diagonals and cavities are always
  /// confirmed, because nothing here contradicts them.
  bool confirms(std::string_view id) const;
};

/// Finds the truth about the tetrahedra `asked` and about all pairs with at least one of them. The search for
/// pairs stops when `most_pairs` are found (0: no search). Time: proportional to `asked` x all tetrahedra for
/// the bounding boxes, and some 10 microseconds for each pair of boxes that meet.
Truth truth(const TetMesh& mesh, std::span<const Index> asked, std::size_t most_pairs = 64);
/// The truth about all tetrahedra.
Truth truth(const TetMesh& mesh);

/// The sign of (b-a) x (c-a) . (d-a), exact.
int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                const Eigen::Vector3d& d);
/// Whether p is at most `limit` [length] from the line through a and b, exact.
bool within_of_line(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                    double limit);
/// Whether p is at most `limit` [length] from the plane through a, b and c, exact.
bool within_of_plane(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                     const Eigen::Vector3d& c, double limit);

}  // namespace tetproof::corpus
