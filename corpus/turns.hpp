// SPDX-License-Identifier: GPL-3.0-or-later
// Sine and cosine of an angle in turns, the same bits on every machine, which the C library's do not promise.
#pragma once

#include <cmath>

namespace tetproof::corpus {

struct CosSin {
  double cos, sin;
};

/// cos(2 pi t) and sin(2 pi t), within 2 units in the last place of 1; exact at multiples of a quarter turn,
/// and exactly periodic: t and t + 1 give the same bits where t + 1 is exact.
inline CosSin cos_sin_turns(double t) {
  t -= std::floor(t);
  const double quarter = std::floor(4 * t + 0.5);
  const double x = (t - quarter / 4) * 6.283185307179586;  // the difference is exact; |x| <= pi / 4
  const double y = x * x;
  // Taylor: the first terms left out are below 1e-19 here.
  double c = 0, s = 0;
  for (int k = 8; k >= 1; --k) {
    c = -(1 + c) * y / ((2 * k - 1) * (2 * k));
    s = -(1 + s) * y / ((2 * k) * (2 * k + 1));
  }
  c = 1 + c;
  s = x + x * s;
  switch (static_cast<int>(quarter) & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

}  // namespace tetproof::corpus
