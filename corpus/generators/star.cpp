// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/generators/star.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "corpus/generators/quadrature.hpp"
#include "corpus/generators/random.hpp"
#include "corpus/generators/turns.hpp"

namespace tetproof::corpus {

Star::Star(std::uint64_t seed, double r, double roughness, double waves) : r_(r), roughness_(roughness) {
  constexpr int modes = 12;
  Random random(seed);
  double sum = 0;
  for (int k = 0; k < modes; ++k) {
    Mode mode;
    do {
      for (int axis = 0; axis < 3; ++axis) mode.frequency[axis] = random.between(-1, 1);
    } while (mode.frequency.squaredNorm() > 1);
    mode.frequency *= waves;
    mode.phase = random.unit();
    mode.amplitude = random.between(0.5, 1);
    sum += mode.amplitude;
    modes_.push_back(mode);
  }
  for (Mode& mode : modes_) mode.amplitude /= sum;
}

double Star::radius(const Eigen::Vector3d& d) const {
  double bump = 0;
  for (const Mode& mode : modes_) {
    const Eigen::Vector3d& f = mode.frequency;
    bump += mode.amplitude * cos_sin_turns(f[0] * d[0] + f[1] * d[1] + f[2] * d[2] + mode.phase).cos;
  }
  return r_ * (1 + roughness_ * bump);
}

double Star::volume() const {
  // Gauss quadrature in z and the trapezoidal rule in the angle. Both converge faster than any power of the
  // step, because the integrand is analytic.
  const auto integral = [&](int n) {
    const GaussRule rule = gauss_legendre(n);
    Sum sum;
    for (int i = 0; i < n; ++i) {
      const double z = 2 * rule.nodes[i] - 1, ring = std::sqrt(1 - z * z);
      for (int j = 0; j < 2 * n; ++j) {
        const CosSin around = cos_sin_turns((j + 0.5) / (2 * n));
        const double radius = this->radius({ring * around.cos, ring * around.sin, z}) / r_;
        sum.add(rule.weights[i] * radius * radius * radius);
      }
    }
    // z has the range 2; the angle has the range 2 pi and 2 n steps
    return sum.value() * 2 * 2 * std::numbers::pi / (2 * n) / 3;
  };
  double coarse = integral(32);
  for (int n = 64; n <= 1024; n *= 2) {
    const double fine = integral(n);
    if (std::abs(fine - coarse) <= 1e-13 * fine) return fine * r_ * r_ * r_;
    coarse = fine;
  }
  throw std::logic_error("the volume of a random star-shaped body did not converge");
}

}  // namespace tetproof::corpus
