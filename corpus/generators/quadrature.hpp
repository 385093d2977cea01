// SPDX-License-Identifier: GPL-3.0-or-later
// Gauss-Legendre quadrature, for volumes that have no closed form.
#pragma once

#include <vector>

namespace tetproof::corpus {

/// Nodes and weights on [0,1]. Up to rounding, n nodes are exact for polynomials of degree 2 n - 1
/// (Abramowitz and Stegun 25.4.29).
struct GaussRule {
  std::vector<double> nodes, weights;
};

GaussRule gauss_legendre(int n);

/// Kahan's compensated sum, so that thousands of terms lose no digits.
class Sum {
 public:
  void add(double x) {
    const double y = x - lost_, t = sum_ + y;
    lost_ = (t - sum_) - y;
    sum_ = t;
  }
  double value() const { return sum_; }

 private:
  double sum_ = 0, lost_ = 0;
};

}  // namespace tetproof::corpus
