// SPDX-License-Identifier: GPL-3.0-or-later
// A random smooth star-shaped body, which has one radius for each direction.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace tetproof::corpus {

/// For a unit vector d, radius(d) = r (1 + roughness * sum_k a_k cos(2 pi (f_k . d + phase_k))) with sum
/// |a_k| = 1 and |f_k| <= waves. So the radius is between r (1 - roughness) and r (1 + roughness). The bits
/// are the same on every machine.
class Star {
 public:
  Star(std::uint64_t seed, double r, double roughness, double waves);

  double radius(const Eigen::Vector3d& direction) const;
  /// The volume [length^3]: the integral of radius^3 / 3 over all directions, converged to a relative 1e-12.
  /// Throws std::logic_error if it does not converge.
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
