// SPDX-License-Identifier: GPL-3.0-or-later
// Section 4: local improvement by exchanging the two and three tetrahedra of a convex hexahedron.
#pragma once

#include <vector>

#include "reference/engine/adaptation/weighted_grid.hpp"

namespace tetproof::reference {

/// What a flip must raise (reading D20).
enum class Criterion { none, solid_angle, aspect_ratio };

/// tan(Omega/2) of the smallest of a positive tetrahedron's four solid angles, after van Oosterom and
/// Strackee. They have one numerator, so the smallest has the largest denominator. Not above 0.28, that of
/// the regular tetrahedron.
double smallest_solid_angle(const std::array<Eigen::Vector3d, 4>& corners);
/// D/A = 3V/A_max^2 [1/length]: the smallest distance D of a vertex from the opposite face, which belongs to
/// the largest face A (reading E5).
double aspect_ratio(const std::array<Eigen::Vector3d, 4>& corners);
/// D/sqrt(A), without a unit, of the largest face.
double dimensionless_aspect_ratio(const std::array<Eigen::Vector3d, 4>& corners);
/// S = Omega/4pi of 0 .. 1 from tan(Omega/2).
double solid_angle_of(double tangent);

/// One way to exchange tetrahedra on five vertices: a face for an edge (2-3), or an edge for a face (3-2).
struct Flip {
  std::vector<Index> old;      ///< two or three tetrahedra
  std::vector<Corners> fresh;  ///< three or two, positive, by ascending sorted vertices; their vertices
                               ///< ascend but for the last two
  std::array<Index, 3> face;   ///< ascending
  std::array<Index, 2> edge;   ///< ascending
  double before, after;        ///< the smallest quality of the set: tan(Omega/2), or D/A

  double gain() const { return after - before; }
  bool two_to_three() const { return old.size() == 2; }
  std::array<Index, 5> vertices() const;  ///< ascending
};

/// Every flip within the tetrahedra `set` that has only positive tetrahedra after it (reading D22), whether
/// it helps or not; criterion as given. A set of four vertices has one quality, computed from the vertices in
/// ascending order.
std::vector<Flip> possible_flips(const Triangulation& grid, const std::vector<Index>& set,
                                 Criterion criterion);

/// The flip that raises the smallest quality of its set most, strictly; ties by the lowest vertices (reading
/// D22).
std::optional<Flip> best_flip(const Triangulation& grid, const std::vector<Index>& set, Criterion criterion);

/// The set O_i with a flip's tetrahedra exchanged.
std::vector<Index> updated_set(std::vector<Index> set, const Flip& flip, Index first_fresh);

}  // namespace tetproof::reference
