// SPDX-License-Identifier: GPL-3.0-or-later
// The grid of step (vi) with its weights, and the choice of the best split by eq. (3.5).
#pragma once

#include <functional>
#include <optional>
#include <queue>
#include <unordered_set>

#include "reference/engine/adaptation/boundary_faces.hpp"
#include "reference/engine/adaptation/table4.hpp"
#include "reference/engine/adaptation/weighting.hpp"

namespace tetproof::reference {

/// Maps the place of a new surface point to the parametric surface. Empty: the point stays where Table 4 puts
/// it.
using MapToSurface = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// A tetrahedron that eq. (3.5) may choose.
struct Candidate {
  Index tet;
  Split split;         ///< its point is moved to the parametric surface where reading D12 permits it
  bool moved = false;  ///< whether the point was moved
  std::array<Weight, 4> pieces;  ///< the first `split.pieces` are set
  double change;                 ///< of the sum of errors, ((E'_1 + E'_2) + ...) - E_j
};

/// The second triangulation with the weight of every tetrahedron, kept up to date through splits and flips.
class WeightedGrid {
 public:
  /// Computes the weight of every tetrahedron from its distance, eq. (3.2). `weighting` must outlive this
  /// object. `literal`: the E'_avg of every split is a mean over L+3 tetrahedra.
  WeightedGrid(Triangulation grid, const Weighting& weighting, const std::vector<double>& distances,
               MapToSurface to_surface, bool literal = false);

  const Triangulation& grid() const { return grid_; }
  const Weight& weight(Index tet) const { return weights_[tet]; }
  double sum() const { return sum_.value(); }
  double e_avg() const { return average_error(sum(), grid_.tets()); }  ///< eq. (3.4)

  /// The candidate of one tetrahedron, as eq. (3.5) defines it.
  Candidate candidate(Index tet) const;
  /// The same for a given split that Table 4 allows. Its point is not moved.
  Candidate candidate(Index tet, const Split& split) const;
  double e_avg_after(const Candidate& c) const { return e_avg_after(c.change, c.split.pieces); }
  /// The candidate with the smallest E'_avg, and of equal ones the lowest-numbered tetrahedron (reading D16).
  /// The result is the same as that of a search through all tetrahedra that are not refused, in logarithmic
  /// time.
  std::optional<Candidate> best();
  /// Whether all pieces are exactly positive (reading D18).
  bool is_positive(const Candidate& c) const;
  bool is_parametric() const { return static_cast<bool>(to_surface_); }
  /// Whether the candidate's point was moved and would make the boundary meet itself (reading D12).
  bool crosses_boundary(const Candidate& c) const;
  /// Says that the tetrahedron's new point must stay where Table 4 puts it. Its candidate is evaluated again.
  void leave_point(Index tet);
  /// Says that the tetrahedron must not be split until it changes (reading D18).
  void refuse(Index tet);

  /// Splits the candidate's tetrahedron. Returns the number of the first piece.
  Index apply(const Candidate& c);
  /// Exchanges tetrahedra, for a flip. Returns the number of the first new one.
  Index exchange(std::span<const Index> old, std::span<const Corners> fresh);

 private:
  struct Entry {
    double change;  // the candidate's change, or a lower bound of it
    Index tet;
    bool exact;                             // false: `change` is a lower bound
    bool operator<(const Entry& o) const {  // std::priority_queue gives the largest first
      return change != o.change ? change > o.change : tet > o.tet;
    }
  };
  using Queue = std::priority_queue<Entry>;

  double e_avg_after(double change, int pieces) const {
    return average_error_after_split(sum(), change, grid_.tets(), literal_ ? 4 : pieces);
  }
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
  bool literal_;
  std::optional<BoundaryFaces> boundary_;  // only with a parametric surface
  std::unordered_set<Index> left_;         // tetrahedra whose new point must not be moved
  std::vector<Weight> weights_;            // by the number of the tetrahedron
  CompensatedSum sum_;
  std::array<Queue, 3> queues_;                     // for splits into 2, 3 and 4 pieces
  std::unordered_map<Index, Candidate> evaluated_;  // the candidates whose entries are exact
};

}  // namespace tetproof::reference
