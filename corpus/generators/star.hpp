// SPDX-License-Identifier: GPL-3.0-or-later
// A random smooth star-shaped body: a radius for each direction.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace tetproof::corpus {

/// radius(d) = r (1 + roughness * sum_k a_k cos(2 pi (f_k . d + phase_k))), sum |a_k| = 1, |f_k| <= waves; d
/// a unit vector. So the radius stays within r (1 - roughness) and r (1 + roughness). The same bits on every
/// machine.
class Star {
 public:
  Star(std::uint64_t seed, double r, double roughness, double waves);

  double radius(const Eigen::Vector3d& direction) const;
  /// The integral of radius^3 / 3 over all directions, converged to 1e-12 of it; std::logic_error if it does
  /// not.
  double volume() const;

 private:
  struct Mode {
    Eigen::Vector3d frequency;
    double phase, amplitude;
  };
  double r_, roughness_;
  std::vector<Mode> modes_;
};

}  // namespace tetproof::corpus
