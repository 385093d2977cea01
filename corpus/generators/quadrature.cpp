// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/generators/quadrature.hpp"

#include <cmath>
#include <numbers>

namespace tetproof::corpus {

GaussRule gauss_legendre(int n) {
  GaussRule rule;
  rule.nodes.resize(n);
  rule.weights.resize(n);
  for (int i = 0; i < (n + 1) / 2; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 1;
    // Newton's method on the Legendre polynomial P_n, which converges quadratically from this good start.
    for (int step = 0; step < 10; ++step) {
      double previous = 1, current = x;
      for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * current - (k - 1) * previous) / k;
        previous = current;
        current = next;
      }
      slope = n * (x * current - previous) / (x * x - 1);
      const double change = current / slope;
      x -= change;
      if (std::abs(change) < 1e-16) break;
    }
    if (2 * i + 1 == n) x = 0;
    rule.nodes[i] = (1 - x) / 2;
    rule.nodes[n - 1 - i] = (1 + x) / 2;
    rule.weights[i] = rule.weights[n - 1 - i] = 1 / ((1 - x * x) * slope * slope);
  }
  return rule;
}

}  // namespace tetproof::corpus
