// SPDX-License-Identifier: GPL-3.0-or-later
// What is true of a mesh, by brute force over exact numbers: the second opinion on the judge in verify/,
// which shares no line with it.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::corpus {

/// A vertex in a tetrahedron that does not name it: in its inside or on its boundary.
struct Touch {
  Index vertex, tet;
  auto operator<=>(const Touch&) const = default;
};

/// Positions in the arrays of the mesh. All lists ascend.
struct Truth {
  std::vector<Index> out_of_range, not_finite, repeating;  ///< tetrahedra that name no point, a point whose
                                                           ///< coordinates are not finite, a point twice
  // Of all other tetrahedra:
  std::vector<std::vector<Index>> duplicates;           ///< with the same four vertices
  std::vector<Index> negative, flat;                    ///< exactly; of those that were asked for
  std::vector<std::vector<Index>> thrice;               ///< three or more on the same three vertices
  std::vector<std::array<Index, 2>> one_sided;          ///< two that induce the same orientation on a face
  std::vector<std::array<Index, 2>> coinciding_faces;   ///< faces of one tetrahedron each in the same place,
                                                        ///< not of the same numbers, seen from opposite sides
  std::vector<std::array<Index, 2>> nonmanifold_edges;  ///< with more than two faces of one tetrahedron
  std::vector<Index> nonmanifold_vertices;              ///< whose such faces form more than one fan
  std::vector<std::array<Index, 2>> equal_points;       ///< in the same place, finite; each with the first
  std::vector<Index> unused;                            ///< points of no tetrahedron
  // Of pairs of which one was asked for, neither flat nor each other's duplicate:
  std::vector<std::array<Index, 2>> overlaps;   ///< with common inside
  std::vector<Touch> touches;                   ///< between tetrahedra without common inside
  std::vector<std::array<Index, 2>> crossings;  ///< likewise; an edge of the one crosses one of the other
  bool all = true;                              ///< false: there may be more pairs than `most_pairs` found

  /// The tetrahedra triangulate what they cover: each positive, two of them meeting in a common vertex, edge
  /// or face or not at all. Holds for the tetrahedra that were asked for.
  bool valid() const;
  /// Whether what the check of this id looks for is there; the ids are those of `tetproof-verify
  /// --list-checks`. Checks of what is near, and of cavities: always true, nothing here contradicts them.
  bool confirms(std::string_view id) const;
};

/// Looks at the tetrahedra `asked` and all pairs with one of them, and stops looking for pairs when
/// `most_pairs` were found (0: looks for none). Time: `asked` x all tetrahedra for their boxes, some 10
/// microseconds for each pair of boxes that meet.
Truth truth(const TetMesh& mesh, std::span<const Index> asked, std::size_t most_pairs = 64);
/// Of all tetrahedra.
Truth truth(const TetMesh& mesh);

/// The exact sign of (b-a) x (c-a) . (d-a).
int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                const Eigen::Vector3d& d);
/// Whether p is at most `limit` [length] from the line through a and b, exactly.
bool within_of_line(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                    double limit);
/// Whether p is at most `limit` [length] from the plane through a, b and c, exactly.
bool within_of_plane(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                     const Eigen::Vector3d& c, double limit);

}  // namespace tetproof::corpus
