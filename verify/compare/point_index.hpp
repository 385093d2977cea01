// SPDX-License-Identifier: GPL-3.0-or-later
// Finds points by their coordinates within a tolerance.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace tetproof::verify {

/// Hashes arrays of numbers, for maps whose keys are arrays.
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

/// Finds the closest point within the tolerance. The points are stored in a hashed grid of cells that are a
/// few tolerances wide, so a look-up takes constant time. Throws InputError if it meets hundreds of points in
/// one cell: matching within the tolerance is then meaningless.
class PointIndex {
 public:
  explicit PointIndex(double tolerance);  ///< [length]; 0: finds equal coordinates only

  /// The number of the point with exactly these coordinates (-0 equals 0). Adds the point if it is new.
  int add(const Eigen::Vector3d& point);
  /// Adds a point, even if there is one with the same coordinates, and returns its number.
  int append(const Eigen::Vector3d& point);
  /// The closest point within the tolerance; -1 if there is none. Of several equally close points, the one
  /// that was added first. Never finds a point that is not finite.
  int find(const Eigen::Vector3d& point) const { return find(point, {}); }
  /// Likewise, but ignores the points whose numbers are marked in `taken`. Numbers beyond its end are not
  /// marked.
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
  std::vector<int> before_;  // for each point, the previous point of the same cell; -1: none
  std::unordered_map<Cell, Last, ArrayHash> cells_;
};

}  // namespace tetproof::verify
