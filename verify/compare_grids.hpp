// SPDX-License-Identifier: GPL-3.0-or-later
// Compares two grids: they are equal up to numbering, or each lists what only it has.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/tet_mesh.hpp"

namespace tetproof::verify {

/// A grid with its file's name and numbering.
struct NamedGrid {
  std::string file;
  TetMesh mesh;
  Numbering numbering;
  std::vector<Loss> not_compared{};  ///< what the file has and `mesh` does not
};

/// What only one of two grids has. Numbers of points and tetrahedra are those of its file.
struct GridSide {
  std::string file;
  std::int64_t points = 0, tets = 0;            ///< total numbers
  std::int64_t points_only = 0, tets_only = 0;  ///< numbers of those that only this grid has
  struct Point {
    std::int64_t number;
    Eigen::Vector3d at;
  };
  struct Tet {
    std::int64_t number;
    std::array<Point, 4> corners;  ///< `at` is NaN if the point does not exist
  };
  /// The first of the points that only this grid has, in the file's order, at most `GridComparison::shown`.
  std::vector<Point> first_points;
  std::vector<Tet> first_tets;     ///< likewise for the tetrahedra
  std::vector<Loss> not_compared;  ///< elements of the file that are no tetrahedra, or were not read
};

struct GridComparison {
  static constexpr std::size_t shown = 10;
  double tolerance = 0;            ///< [length]
  double largest_distance = 0;     ///< between matched points [length]
  std::int64_t shared_places = 0;  ///< places where both grids have several points, which are not told apart
  GridSide reference, other;

  bool equal() const {
    return reference.points_only + reference.tets_only + other.points_only + other.tets_only == 0;
  }
  /// All elements of both grids were compared.
  bool complete() const;
};

/// Matches each point of `other` with the closest point of `reference` within `tolerance`, and tetrahedra by
/// their four points in any order. `tolerance` is in diagonals of the box of the reference's tetrahedra. What
/// occurs n times in one grid must occur n times in the other. Takes linear time plus a sort. Throws
/// InputError if too many points are closer together than the tolerance.
GridComparison compare_grids(const NamedGrid& other, const NamedGrid& reference, double tolerance = 1e-9);

/// The result as text for people.
std::string comparison_text(const GridComparison&);
/// The result as JSON. corpus/vectors/TRACE.md describes the keys.
std::string comparison_json(const GridComparison&);

}  // namespace tetproof::verify
