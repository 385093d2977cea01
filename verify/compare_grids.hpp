// SPDX-License-Identifier: GPL-3.0-or-later
// Compares two grids: equal up to numbering, or with points and tetrahedra that only one of them has.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::verify {

/// A grid and the file that it was read from.
struct NamedGrid {
  std::string file;
  TetMesh mesh;
  Numbering numbering;
};

/// One of two grids that are compared, and what only it has. Numbers are those of its file.
struct GridSide {
  std::string file;
  std::int64_t points = 0, tets = 0;            ///< in all
  std::int64_t points_only = 0, tets_only = 0;  ///< only here
  struct Point {
    std::int64_t number;
    Eigen::Vector3d at;
  };
  struct Tet {
    std::int64_t number;
    std::array<Point, 4> corners;  ///< `at` is NaN for a point that does not exist
  };
  /// Points and tetrahedra that are only here, in the order of the file; at most `GridComparison::shown`.
  std::vector<Point> first_points;
  std::vector<Tet> first_tets;
};

struct GridComparison {
  static constexpr std::size_t shown = 10;
  double tolerance = 0;            ///< [length]
  double largest_distance = 0;     ///< between matched points
  std::int64_t shared_places = 0;  ///< places where each grid has several points, which are not distinguished
  GridSide reference, other;

  bool equal() const {
    return reference.points_only + reference.tets_only + other.points_only + other.tets_only == 0;
  }
};

/// Matches each point of `other` with the closest point of `reference` within `tolerance` (in diagonals of
/// the box of the reference's tetrahedra), and tetrahedra by their four points in any order. A point or
/// tetrahedron that one grid has n times, the other must have n times. Takes linear time and the time of a
/// sort. InputError when too many points lie within the tolerance of each other.
GridComparison compare_grids(const NamedGrid& other, const NamedGrid& reference, double tolerance = 1e-9);

/// The comparison in words.
std::string comparison_text(const GridComparison&);
/// The comparison as JSON; corpus/vectors/TRACE.md describes the keys.
std::string comparison_json(const GridComparison&);

}  // namespace tetproof::verify
