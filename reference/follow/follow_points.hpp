// SPDX-License-Identifier: GPL-3.0-or-later
// Agreement between a trace and our run: when two points, two numbers or two choices count as the same. Not
// installed.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "reference/engine/adaptation/triangulation.hpp"
#include "reference/engine/adaptation/vertex_tree.hpp"
#include "reference/engine/first_grid/closest_point.hpp"

namespace tetproof::reference {

inline constexpr double tie = 1e-12;   ///< relative difference of two choices that are equally good
inline constexpr double agree = 1e-9;  ///< relative difference of two computations of the same number
/// Distance of two computations of the same point, as a fraction of the grid's diagonal.
inline constexpr double same_place = 1e-9;

/// Thrown at the first decision that is not admissible; ends the following.
struct Divergence {
  std::string what;
  std::int64_t line = 0;  ///< of the trace; 0: the line of the record read last
};

bool close(double a, double b);  ///< whether two numbers are equal up to `agree`

std::string text(const Eigen::Vector3d& p);
template <std::size_t N>
std::string text(const std::array<Eigen::Vector3d, N>& points) {
  std::string all;
  for (const auto& p : points) {
    if (!all.empty()) all += ' ';
    all += text(p);
  }
  return all;
}

Corners sorted(Corners tet);

/// The points of a trace as points of our grid.
class TracePoints {
 public:
  explicit TracePoints(const TetMesh& first_grid);
  double reach() const { return reach_; }  ///< two points closer than this are the same [length]

  /// The number of a point that the trace has named before, or of the first grid's point at this place.
  /// Throws Divergence if there is none.
  Index find(const Eigen::Vector3d& p);
  void add(const Eigen::Vector3d& p, Index number) { known_.insert_or_assign(p, number); }

  struct Lexicographic {
    bool operator()(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
      return lexicographically_less(a, b);
    }
  };
  const std::map<Eigen::Vector3d, Index, Lexicographic>& known() const { return known_; }

 private:
  VertexTree tree_;
  std::map<Eigen::Vector3d, Index, Lexicographic> known_;
  double reach_;
};

}  // namespace tetproof::reference
