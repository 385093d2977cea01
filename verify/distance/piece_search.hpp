// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of a triangle whose distance to other triangles is not known closely enough. Internal to the
// Hausdorff distance.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "verify/distance/triangle_tree.hpp"

namespace tetproof::verify {

/// A convex polygon in a triangle of A. A cut puts new corners off the line between the old ones by less than
/// 4 2^-53, so that a piece of `cuts` cuts leaves out what is that often as far from it.
inline constexpr int most_corners = 12;
inline constexpr double cut_slack = 4 * 0x1p-53;
inline constexpr int most_cuts = 200;

struct Piece {
  Eigen::Matrix<double, 3, most_corners> corner = Eigen::Matrix<double, 3, most_corners>::Zero();
  int corners = 0;
  int cuts = 0;
  Index guess = -1;    ///< a triangle of B to judge it by
  bool asked = false;  ///< `guess` is nearest to its middle
  int walks = 0;       ///< how often it was handed to a neighbour without getting smaller for sure

  double slack() const { return distance_slack + cuts * cut_slack; }
  void add(const Eigen::Vector3d& p) { corner.col(corners++) = p; }
  Eigen::Vector3d middle() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i < corners; ++i) sum += corner.col(i);
    return sum / corners;
  }
};

/// One triangle of A that is not done.
struct PieceWork {
  Index triangle;
  std::vector<Piece> pieces;
  double upper = 0;  ///< of the pieces that are done
  double lower = 0;  ///< found in it, at `point`
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Index nearest = -1;
  std::int64_t looked_at = 0;
};

/// Looks at the pieces of triangles of A with the triangles B of a tree.
class PieceSearch {
 public:
  /// A piece is done when it is within `error` of the largest distance found, `lower` or the triangle's own,
  /// or within `accepted`. All in units.
  PieceSearch(const TriangleTree& tree, double lower, double error, double accepted)
      : tree_(tree), lower_(lower), error_(error), accepted_(accepted) {}

  /// Looks at up to `budget` pieces.
  void run(PieceWork& work, std::int64_t budget) const;

 private:
  double target(const PieceWork& work) const {
    return std::max(std::max(lower_, work.lower) + error_, accepted_);
  }
  using Places = std::array<TriangleFrame::Place, most_corners>;
  bool examine_over(PieceWork& work, const Piece& piece) const;
  bool over_prism(PieceWork& work, const Piece& piece, const Places& place, double goal, double margin) const;
  Index ask(PieceWork& work, const Eigen::Vector3d& p, Index guess) const;
  void examine(PieceWork& work, Piece piece) const;
  static void halve(PieceWork& work, const Piece& piece);

  const TriangleTree& tree_;
  double lower_, error_, accepted_;
};

}  // namespace tetproof::verify
