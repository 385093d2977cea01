// SPDX-License-Identifier: GPL-3.0-or-later
// Two grids: equal up to numbering, or what only one of them has.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/tet_mesh.hpp"

namespace tetproof::verify {

/// A grid as a file holds it.
struct NamedGrid {
  std::string file;
  TetMesh mesh;
  Numbering numbering;
  std::vector<Loss> not_compared{};  ///< what the file has and `mesh` does not
};

/// What only one of two grids has; numbers are those of its file.
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
  std::vector<Point>
      first_points;  ///< of those only here, at most `GridComparison::shown`, by their order in the file
  std::vector<Tet> first_tets;
  std::vector<Loss> not_compared;
};

struct GridComparison {
  static constexpr std::size_t shown = 10;
  double tolerance = 0;            ///< [length]
  double largest_distance = 0;     ///< between matched points
  std::int64_t shared_places = 0;  ///< places with several points in each, which are not told apart
  GridSide reference, other;

  bool equal() const {
    return reference.points_only + reference.tets_only + other.points_only + other.tets_only == 0;
  }
  /// All elements of both grids were compared.
  bool complete() const;
};

/// Matches each point of `other` with the closest one of `reference` within `tolerance` (in diagonals of the
/// box of the reference's tetrahedra), and tetrahedra by their four points in whatever order. What stands n
/// times in one must stand n times in the other. Linear time but for a sort; throws InputError when points
/// crowd within the tolerance.
GridComparison compare_grids(const NamedGrid& other, const NamedGrid& reference, double tolerance = 1e-9);

/// For people.
std::string comparison_text(const GridComparison&);
/// As JSON; corpus/vectors/TRACE.md describes the keys.
std::string comparison_json(const GridComparison&);

}  // namespace tetproof::verify
