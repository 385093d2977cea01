// SPDX-License-Identifier: GPL-3.0-or-later
// What the comparison of two traces counts as the same.
#pragma once

#include <algorithm>
#include <cmath>

#include "io/trace.hpp"

namespace tetproof::verify {

struct Tolerance {
  double relative = 1e-9;
  double length = 0;  ///< `relative` times the diagonal of the reference's lattice

  bool same(const trace::Point& a, const trace::Point& b) const { return (a - b).norm() <= length; }
  /// Two numbers, with the size of what they were computed from.
  bool same(double a, double b, double scale = 0) const {
    return a == b || std::abs(a - b) <= relative * std::max({std::abs(a), std::abs(b), std::abs(scale)});
  }
};

}  // namespace tetproof::verify
