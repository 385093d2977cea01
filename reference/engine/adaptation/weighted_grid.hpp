// SPDX-License-Identifier: GPL-3.0-or-later
// Step (vi), first half: the grid with its weights, and the split that eq. (3.5) chooses.
#pragma once

#include <functional>
#include <optional>
#include <queue>
#include <unordered_set>

#include "reference/engine/adaptation/boundary_faces.hpp"
#include "reference/engine/adaptation/table4.hpp"
#include "reference/engine/adaptation/weighting.hpp"

namespace tetproof::reference {

/// A sum of doubles with Neumaier's compensation: its error does not grow with the number of terms.
class CompensatedSum {
 public:
  void add(double x) {
    const double t = sum_ + x;
    lost_ += std::abs(sum_) >= std::abs(x) ? (sum_ - t) + x : (x - t) + sum_;
    sum_ = t;
  }
  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0, lost_ = 0;
};

/// Where a new surface point goes; without one, where Table 4 puts it.
using MapToSurface = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// A tetrahedron that eq. (3.5) may choose.
struct Candidate {
  Index tet;
  Split split;  ///< with its point on the parametric surface, if there is one and it fits (reading D12)
  bool moved = false;            ///< whether its point was moved there
  std::array<Weight, 4> pieces;  ///< the first `split.pieces`
  double change;                 ///< of the sum of errors: ((E'_1 + E'_2) + ...) - E_j
};

class WeightedGrid {
 public:
  /// Weighs every tetrahedron from its distance, eq. (3.2). `to_surface` may be empty.
  WeightedGrid(Triangulation grid, const Weighting& weighting, const std::vector<double>& distances,
               MapToSurface to_surface);

  const Triangulation& grid() const { return grid_; }
  const Weight& weight(Index tet) const { return weights_[tet]; }
  double sum() const { return sum_.value(); }
  double e_avg() const { return average_error(sum(), grid_.tets()); }  ///< eq. (3.4)

  /// Eq. (3.5) for one tetrahedron, literally.
  Candidate candidate(Index tet) const;
  /// The same for a split that Table 4 allows, its point as given.
  Candidate candidate(Index tet, const Split& split) const;
  double e_avg_after(const Candidate& c) const {
    return average_error_after_split(sum(), c.change, grid_.tets(), c.split.pieces);
  }
  /// The candidate with the smallest E'_avg, ties by the lowest number (reading D16): the same as asking all
  /// that were not refused, in log n.
  std::optional<Candidate> best();
  /// Whether all pieces are exactly positive (reading D18).
  bool is_positive(const Candidate& c) const;
  /// Whether its point was moved and would carry the boundary through itself (reading D12).
  bool crosses_boundary(const Candidate& c) const;
  /// The tetrahedron's point is not to be moved: it is weighed again with the point where Table 4 puts it.
  void leave_point(Index tet);
  /// Not to be asked again until it changes (reading D18).
  void refuse(Index tet);

  /// Splits the candidate's tetrahedron; the number of the first piece.
  Index apply(const Candidate& c);
  /// Exchanges tetrahedra (a flip); the number of the first new one.
  Index exchange(std::span<const Index> old, std::span<const Corners> fresh);

 private:
  struct Entry {
    double change;  // of a candidate, or a bound it is not below
    Index tet;
    bool exact;
    bool operator<(const Entry& o) const {  // std::priority_queue gives the largest first
      return change != o.change ? change > o.change : tet > o.tet;
    }
  };
  using Queue = std::priority_queue<Entry>;

  std::array<Eigen::Vector3d, 4> piece(const std::array<Eigen::Vector3d, 4>& corners, const Split& split,
                                       int k) const;
  bool pieces_positive(Index tet, const Split& split) const;
  Entry bound(Index tet, int& pieces) const;
  void enqueue(Index tet);
  void dequeue(Index tet);
  BoundaryFace face(Index tet, int f) const;

  Triangulation grid_;
  const Weighting& weighting_;
  MapToSurface to_surface_;
  std::optional<BoundaryFaces> boundary_;  // with a parametric surface only
  std::unordered_set<Index> left_;         // tetrahedra whose point is not to be moved
  std::vector<Weight> weights_;            // of each number
  CompensatedSum sum_;
  std::array<Queue, 3> queues_;                     // of splits into 2, 3, 4
  std::unordered_map<Index, Candidate> evaluated_;  // whose entry is exact
};

}  // namespace tetproof::reference
