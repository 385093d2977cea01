// SPDX-License-Identifier: GPL-3.0-or-later
// Points named by their coordinates, within a tolerance: what two files call the same point.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace tetproof::verify {

/// Hash of a few numbers, for maps whose keys are arrays.
struct ArrayHash {
  template <class Array>
  std::size_t operator()(const Array& values) const {
    std::uint64_t hash = 0x9e3779b97f4a7c15;
    for (const auto& value : values) {
      hash ^= std::hash<typename Array::value_type>{}(value);
      hash *= 0xff51afd7ed558ccd;
      hash ^= hash >> 32;
    }
    return hash;
  }
};

/// Finds the closest of the points it holds, if that is within the tolerance. Points lie in a hashed grid of
/// cells some tolerances wide, so that a look-up takes constant time; throws InputError when it meets
/// hundreds of points in one cell, where matching within the tolerance would mean nothing.
class PointIndex {
 public:
  explicit PointIndex(double tolerance);  ///< [length]; 0: equal coordinates only

  /// The number of the point with just these coordinates, which is added if it is new. -0 is 0.
  int add(const Eigen::Vector3d& point);
  /// The number of a new point, even where there is one already.
  int append(const Eigen::Vector3d& point);
  /// The closest point within the tolerance, of several equally close the one added first; -1 for none. Never
  /// finds a point that is not finite.
  int find(const Eigen::Vector3d& point) const { return find(point, {}); }
  /// Likewise, but not those whose numbers are marked in `taken` (beyond its end: unmarked).
  int find(const Eigen::Vector3d& point, const std::vector<bool>& taken) const;

  const std::vector<Eigen::Vector3d>& points() const { return points_; }

 private:
  using Cell = std::array<double, 3>;
  struct Last {
    int point = -1, count = 0;
  };
  Cell cell(const Eigen::Vector3d& point) const;
  void check_crowd(const Last& last, const Eigen::Vector3d& point) const;

  double tolerance_, width_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<int> before_;  // the point that came into the same cell before
  std::unordered_map<Cell, Last, ArrayHash> cells_;
};

}  // namespace tetproof::verify
