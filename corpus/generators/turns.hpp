// SPDX-License-Identifier: GPL-3.0-or-later
// The sine and cosine of an angle in turns, with the same bits on every machine. The functions of the C
// library do not promise that.
#pragma once

#include <cmath>

namespace tetproof::corpus {

struct CosSin {
  double cos, sin;
};

/// cos(2 pi t) and sin(2 pi t), with an error of at most 2 units in the last place of 1. They are exact at
/// multiples of a quarter turn, and exactly even and odd. t and t + 1 give the same bits if t + 1 is exact.
inline CosSin cos_sin_turns(double t) {
  const double quarter = std::nearbyint(4 * t);  // ties go to even, so that t and -t are treated alike
  const double x = (t - quarter / 4) * 6.283185307179586;  // the difference is exact; |x| <= pi / 4
  const double y = x * x;
  // Taylor series. The first terms that are left out are below 1e-17 here.
  double c = 0, s = 0;
  for (int k = 8; k >= 1; --k) {
    c = -(1 + c) * y / ((2 * k - 1) * (2 * k));
    s = -(1 + s) * y / ((2 * k) * (2 * k + 1));
  }
  c = 1 + c;
  s = x + x * s;
  const double turned = std::fmod(quarter, 4);  // exact; has the sign of t
  if (turned == 1 || turned == -3) return {-s, c};
  if (turned == 2 || turned == -2) return {-c, -s};
  if (turned == 3 || turned == -1) return {s, -c};
  return {c, s};
}

}  // namespace tetproof::corpus
