// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a triangle into pieces until the distance of each piece to other triangles is known closely enough.
// Internal to the Hausdorff distance.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "verify/distance/triangle_tree.hpp"

namespace tetproof::verify {

inline constexpr int most_corners = 12;
/// Rounding puts the new corners of a cut off the line between the old ones by less than this [units].
inline constexpr double cut_slack = 4 * 0x1p-53;
inline constexpr int most_cuts = 400;

/// A convex polygon in a triangle of A. A piece made by `cuts` cuts may miss points that lie up to `cuts` *
/// cut_slack away from it; `slack` accounts for them.
struct Piece {
  Eigen::Matrix<double, 3, most_corners> corner = Eigen::Matrix<double, 3, most_corners>::Zero();
  int corners = 0;
  int cuts = 0;
  Index guess = -1;    ///< the triangle of B that bounds its distance
  bool asked = false;  ///< `guess` is the triangle nearest to its middle
  bool whole = false;  ///< it has no extent that could be halved
  int walks = 0;       ///< how often it went on to a neighbour without certainly getting smaller

  double slack() const { return distance_slack + cuts * cut_slack; }
  void add(const Eigen::Vector3d& p) { corner.col(corners++) = p; }
  Eigen::Vector3d middle() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i < corners; ++i) sum += corner.col(i);
    return sum / corners;
  }
};

/// An unfinished triangle of A.
struct PieceWork {
  Index triangle;
  std::vector<Piece> pieces;
  double upper = 0;  ///< an upper bound of the distance for all finished pieces
  double lower = 0;  ///< the largest distance found in the triangle, at `point`
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Index nearest = -1;          ///< the triangle of B nearest to `point`
  std::int64_t looked_at = 0;  ///< number of pieces
};

/// How closely a distance is wanted. All values but `relative` are in units.
struct Wanted {
  double error;     ///< the bound of a piece may be this much above the largest distance known
  double relative;  ///< or above it by this share of it
  double accepted;  ///< a bound that is always low enough

  /// The largest bound that a piece need not improve on, if `lower` is the largest distance known and the
  /// piece may miss points by `slack`. Every cut adds to a piece's slack, so no cut brings its bound below
  /// its distance and `slack`. Rounding leaves no more to gain once the bound is within twice that.
  double bound(double lower, double slack) const {
    return std::max(lower + std::max({error, relative * lower, 2 * slack}), accepted);
  }
  /// The share of the distance by which a search far from the triangles may miss the nearest one. Near them,
  /// 0: there only the nearest triangle helps to cut, and it is found quickly.
  double share(double lower) const {
    const double spare = std::max(error, relative * lower);
    return lower > spare ? spare / (8 * lower) : 0;
  }
};

/// Bounds the distance from pieces of triangles of A to the triangles B of a tree.
class PieceSearch {
 public:
  /// `lower` [units]: the largest distance known, beside those that a triangle finds in itself.
  PieceSearch(const TriangleTree& tree, double lower, const Wanted& wanted)
      : tree_(tree), lower_(lower), wanted_(wanted) {}

  /// Examines up to `budget` pieces.
  void run(PieceWork& work, std::int64_t budget) const;

 private:
  double known(const PieceWork& work) const { return std::max(lower_, work.lower); }
  using Places = std::array<TriangleFrame::Place, most_corners>;
  bool examine_over(PieceWork& work, const Piece& piece) const;
  bool over_prism(PieceWork& work, const Piece& piece, const Places& place, double goal, double margin) const;
  Index ask(PieceWork& work, const Eigen::Vector3d& p, Index guess) const;
  void examine(PieceWork& work, Piece piece) const;
  static void halve(PieceWork& work, const Piece& piece);

  const TriangleTree& tree_;
  double lower_;
  Wanted wanted_;
};

}  // namespace tetproof::verify
