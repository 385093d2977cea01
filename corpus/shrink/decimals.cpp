// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/shrink/decimals.hpp"

#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "corpus/fuzz/decimals.hpp"
#include "corpus/shrink/bring_near.hpp"
#include "io/bytes/scanner.hpp"

namespace tetproof::corpus {

int decimals_of(double x) {
  if (x == 0) return std::numeric_limits<int>::min();
  const Decimal shortest = shortest_decimal(x);
  return static_cast<int>(shortest.digits.size()) - 1 - shortest.exponent;
}

double rounded(double x, int decimals) {
  double unit = 0, value = 0;
  parse_real(fmt::format("1e{}", -decimals), unit);
  if (!(unit > 0) || !std::isfinite(unit)) return x;
  parse_real(fmt::format("{:.0f}e{}", std::round(x / unit), -decimals), value);
  return std::isfinite(value) ? value + 0.0 : x;  // -0 + 0 is 0
}

int coarsest_decimals(const TriangleSurface& surface) {
  const double size = size_of(surface);
  if (!(size > 0) || !std::isfinite(size)) return 0;
  return -shortest_decimal(to_significant_digits(size, 1)).exponent;
}

std::int64_t decimals_beyond(const TriangleSurface& surface, int coarsest) {
  std::int64_t sum = 0;
  for (const Eigen::Vector3d& p : surface.vertices)
    for (const double x : p) sum += std::max(decimals_of(x), coarsest) - coarsest;
  return sum;
}

int most_decimals(const TriangleSurface& surface, int coarsest) {
  int most = coarsest;
  for (const Eigen::Vector3d& p : surface.vertices)
    for (const double x : p) most = std::max(most, decimals_of(x));
  return most;
}

}  // namespace tetproof::corpus
