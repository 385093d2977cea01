// SPDX-License-Identifier: GPL-3.0-or-later
// A tetrahedral mesh as plain arrays, and the file's numbers of its points and tetrahedra.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace tetproof {

using Index = std::int32_t;  ///< position in an array of points, triangles or tetrahedra

/// A tetrahedral mesh. A positive tetrahedron {a, b, c, d} has (b-a) x (c-a) . (d-a) > 0.
///
/// There are no promises: a file may name points that do not exist (any index outside [0, points.size())),
/// hold NaN, or repeat itself. `verify` finds out.
struct TetMesh {
  std::vector<Eigen::Vector3d> points;     ///< coordinates [length]
  std::vector<std::array<Index, 4>> tets;  ///< four positions in `points` each
};

/// The faces of a tetrahedron, as corner positions; face f is opposite to corner f. Seen from outside a
/// positive tetrahedron each runs anticlockwise.
inline constexpr std::array<std::array<int, 3>, 4> tet_faces{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// The file's numbers of the points and tetrahedra, for messages. Empty vectors: numbered from `first`.
struct Numbering {
  std::vector<std::int64_t> points;  ///< number of each point
  std::vector<std::int64_t> tets;    ///< number of each tetrahedron
  /// Index -1-k in a tetrahedron stands for the number unknown[k], which no point has.
  std::vector<std::int64_t> unknown;
  std::int64_t first = 0;

  std::int64_t point(Index i) const {
    if (i < 0) return -1 - i < static_cast<Index>(unknown.size()) ? unknown[-1 - i] : i;
    return i < static_cast<Index>(points.size()) ? points[i] : i + first;
  }
  std::int64_t tet(Index i) const {
    return i >= 0 && i < static_cast<Index>(tets.size()) ? tets[i] : i + first;
  }
};

}  // namespace tetproof
