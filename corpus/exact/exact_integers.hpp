// SPDX-License-Identifier: GPL-3.0-or-later
// Doubles as integer multiples of a common power of two, so that sums and products are exact. Internal.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace tetproof::corpus {

/// An integer of any size. Up to 1024 bits need no allocation.
using Integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<1024, 0, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked,
                                           std::allocator<boost::multiprecision::limb_type>>,
    boost::multiprecision::et_off>;
using IntegerPoint = std::array<Integer, 3>;

/// The exponent of the lowest bit that is set in any of these coordinates, which must be finite.
inline int last_bit(std::span<const Eigen::Vector3d> points) {
  int least = std::numeric_limits<int>::max();
  for (const Eigen::Vector3d& p : points)
    for (int k = 0; k < 3; ++k) {
      if (p[k] == 0) continue;
      int exponent = 0;
      auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(p[k], &exponent), 53));
      exponent -= 53;
      while (digits % 2 == 0) digits /= 2, ++exponent;
      least = std::min(least, exponent);
    }
  return least == std::numeric_limits<int>::max() ? 0 : least;
}

// g++ 14 takes the limbs of Boost's shift for more than there are.
#pragma GCC diagnostic push
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wstringop-overflow"
#pragma GCC diagnostic ignored "-Warray-bounds"
#endif
/// x in units of 2^unit. It must be a multiple of 2^unit.
inline Integer integer(double x, int unit) {
  if (x == 0) return 0;
  int exponent = 0;
  auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  exponent -= 53;
  while (digits % 2 == 0) digits /= 2, ++exponent;
  return Integer(digits) << (exponent - unit);
}
#pragma GCC diagnostic pop

inline IntegerPoint integers(const Eigen::Vector3d& p, int unit) {
  return {integer(p[0], unit), integer(p[1], unit), integer(p[2], unit)};
}

inline IntegerPoint operator-(const IntegerPoint& p, const IntegerPoint& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
inline Integer dot(const IntegerPoint& p, const IntegerPoint& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
inline IntegerPoint cross(const IntegerPoint& p, const IntegerPoint& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

}  // namespace tetproof::corpus
