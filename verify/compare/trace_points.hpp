// SPDX-License-Identifier: GPL-3.0-or-later
// The points of two traces, numbered alike.
#pragma once

#include <array>
#include <unordered_map>
#include <vector>

#include "verify/compare/point_index.hpp"

namespace tetproof::verify {

/// Which of two traces.
enum class Side { reference, other };

/// A trace writes a point bit for bit the same every time, so each trace's points are told apart by their
/// exact coordinates, however close they are. What is the same point in both is settled once, when a trace
/// names it for the first time: the point of an insertion is that of the other's same insertion, any other
/// the closest one within the tolerance.
class TracePoints {
 public:
  explicit TracePoints(double tolerance) : index_(tolerance) {}  ///< [length]; 0: equal coordinates only

  /// A point that is there. One that this trace has not named yet is the closest within the tolerance, of
  /// those that only the other one has named if there is one, else of those that both have, or else a new
  /// one. Throws InputError where hundreds of points crowd within a few tolerances of one that is named for
  /// the first time.
  int number(Side side, const Eigen::Vector3d& point);
  /// The new point of an insertion. `partner`: the number of the other's same insertion's; -1: it has not
  /// come there (yet).
  int insert(Side side, const Eigen::Vector3d& point, int partner);
  /// As the first trace to name it has it.
  const Eigen::Vector3d& at(int number) const { return index_.points()[number]; }

 private:
  using Key = std::array<double, 3>;
  static Key key(const Eigen::Vector3d& point) {
    return {point.x() + 0.0, point.y() + 0.0, point.z() + 0.0};  // no -0
  }
  struct Named {
    std::unordered_map<Key, int, ArrayHash> numbers;
    std::vector<bool> all;  // by number; beyond its end: not named
  };
  static void mark(Named& named, int number);

  PointIndex index_;
  std::array<Named, 2> named_;
};

}  // namespace tetproof::verify
