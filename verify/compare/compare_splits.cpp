// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare/compare_splits.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "verify/compare/rounding.hpp"

namespace tetproof::verify {
namespace {

using namespace trace;

// The size [length] of the edge or face that holds the new point: its length, or the root of twice its area.
double measure(const Insertion& insertion) {
  const auto corner = [&](std::size_t i) { return insertion.tet[insertion.replaced[i]]; };
  if (insertion.replaced.size() == 2) return (corner(1) - corner(0)).norm();
  if (insertion.replaced.size() == 3)
    return std::sqrt((corner(1) - corner(0)).cross(corner(2) - corner(0)).norm());
  return 0;
}

}  // namespace

std::vector<Tet> pieces(const Insertion& insertion) {
  std::vector<Tet> all;
  for (const int i : insertion.replaced) {
    all.push_back(insertion.tet);
    all.back()[i] = insertion.point;
  }
  return all;
}

bool refused_by_rounding(const Split& split, const Magnitudes& sizes) {
  const std::vector<Tet> all = pieces(split.insertion);
  return std::any_of(all.begin(), all.end(),
                     [&](const Tet& piece) { return thinner_than_rounding(piece, sizes.length); });
}

bool equally_large(const Split& a, const Split& b, const Magnitudes& sizes) {
  const double one = measure(a.insertion), two = measure(b.insertion);
  return a.replaced.size() == b.replaced.size() &&
         std::abs(one - two) <= tie * std::max(one, two) + 1e-15 * sizes.length;
}

}  // namespace tetproof::verify
