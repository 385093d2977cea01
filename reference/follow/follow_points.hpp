// SPDX-License-Identifier: GPL-3.0-or-later
// Following a trace: when two implementations mean the same point, number or choice, and what is said when
// they do not. Not installed.
#pragma once

#include <map>
#include <string>

#include "reference/engine/adaptation/triangulation.hpp"
#include "reference/engine/adaptation/vertex_tree.hpp"
#include "reference/engine/first_grid/contacts.hpp"

namespace tetproof::reference {

inline constexpr double tie = 1e-12;        ///< relative: two choices as good as each other
inline constexpr double agree = 1e-9;       ///< relative: two computations of one number
inline constexpr double same_place = 1e-9;  ///< of the grid's diagonal: two computations of one point

/// The first decision that is not admissible, thrown to where the following ends.
struct Divergence {
  std::string what;
};

bool close(double a, double b);  ///< equal to `agree`

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
  double reach() const { return reach_; }  ///< closer than this is the same place [length]

  /// The number of a point that was named before, or of the first grid's point at this place. Throws
  /// Divergence.
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
