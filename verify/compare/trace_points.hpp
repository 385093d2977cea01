// SPDX-License-Identifier: GPL-3.0-or-later
// Common numbers for the points of two traces.
#pragma once

#include <array>
#include <unordered_map>
#include <vector>

#include "verify/compare/point_index.hpp"

namespace tetproof::verify {

/// Which of two traces.
enum class Side { reference, other };

/// A trace always writes a point with the same bits, so the points of one trace are told apart by their exact
/// coordinates, however close they are. Which points of the two traces are the same is decided once, when a
/// trace names a point for the first time. The point of an insertion is the same as that of the other trace's
/// same insertion. Any other point is matched with the closest one within the tolerance.
class TracePoints {
 public:
  /// [length]; 0: matches equal coordinates only.
  explicit TracePoints(double tolerance) : index_(tolerance) {}

  /// The number of an existing point. If this trace has not named it yet, it is the closest point within the
  /// tolerance: first among those that only the other trace has named, then among those that both have named.
  /// Otherwise it is a new point. Throws InputError if hundreds of points lie within a few tolerances of a
  /// point that is named for the first time.
  int number(Side side, const Eigen::Vector3d& point);
  /// The number of an insertion's new point. `partner`: the number that the other trace's same insertion gave
  /// its point; -1: there is no such insertion (yet).
  int insert(Side side, const Eigen::Vector3d& point, int partner);
  /// The coordinates, as the first trace that named the point has them.
  const Eigen::Vector3d& at(int number) const { return index_.points()[number]; }

 private:
  using Key = std::array<double, 3>;
  static Key key(const Eigen::Vector3d& point) {
    return {point.x() + 0.0, point.y() + 0.0, point.z() + 0.0};  // no -0
  }
  struct Named {
    std::unordered_map<Key, int, ArrayHash> numbers;
    std::vector<bool> all;  // by number; a number beyond its end is not named
  };
  static void mark(Named& named, int number);

  PointIndex index_;
  std::array<Named, 2> named_;
};

}  // namespace tetproof::verify
