// SPDX-License-Identifier: GPL-3.0-or-later
// A tetrahedral mesh as plain arrays, and the file's numbers of its points and tetrahedra.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
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

/// What a region of a mesh is called in its file.
struct RegionTag {
  /// "physical" (a group), "reference" (of Medit), "entity", "attribute" (of TetGen); empty: only a number.
  std::string kind;
  std::int64_t tag = 0;  ///< its number among those of its kind
  std::string name;      ///< of the physical group; empty: it has none
};

/// The region of each tetrahedron, as a position in `tags`. Both are empty if all are in one region.
struct TetRegions {
  std::vector<std::int64_t> of_tet;
  std::vector<RegionTag> tags;  ///< ascending: physical groups, entities, attributes, each by their numbers
};

/// A number that stands more than once in a file: which of its bearers a point or tetrahedron is.
struct RepeatedNumber {
  Index at = 0;          ///< position of the point or tetrahedron
  std::int32_t nth = 1;  ///< it is the nth with its number in the file's order, from 1
};

/// The file's numbers of the points and tetrahedra, for messages. Empty vectors: numbered from `first`.
struct Numbering {
  std::vector<std::int64_t> points;  ///< number of each point
  std::vector<std::int64_t> tets;    ///< number of each tetrahedron
  /// Index -1-k in a tetrahedron stands for the number unknown[k], which no point has.
  std::vector<std::int64_t> unknown;
  std::int64_t first = 0;
  /// Points and tetrahedra whose numbers others have too, ascending.
  std::vector<RepeatedNumber> repeated_points{}, repeated_tets{};

  std::int64_t point(Index i) const {
    if (i < 0) return -1 - i < static_cast<Index>(unknown.size()) ? unknown[-1 - i] : i;
    return i < static_cast<Index>(points.size()) ? points[i] : i + first;
  }
  std::int64_t tet(Index i) const {
    return i >= 0 && i < static_cast<Index>(tets.size()) ? tets[i] : i + first;
  }
  /// Which of several points (tetrahedra) with its number it is, from 1; 0: no other has its number.
  std::int32_t nth_point(Index i) const { return nth(repeated_points, i); }
  std::int32_t nth_tet(Index i) const { return nth(repeated_tets, i); }

 private:
  static std::int32_t nth(const std::vector<RepeatedNumber>& repeated, Index i) {
    const auto found = std::lower_bound(repeated.begin(), repeated.end(), i,
                                        [](const RepeatedNumber& r, Index at) { return r.at < at; });
    return found != repeated.end() && found->at == i ? found->nth : 0;
  }
};

}  // namespace tetproof
