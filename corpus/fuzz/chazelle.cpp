// SPDX-License-Identifier: GPL-3.0-or-later
// Chazelle's polyhedron: a box with notches from above and from below that nearly meet along z = xy
// (B. Chazelle, Convex partitions of polyhedra, SIAM J. Comput. 13 (1984), 488-507).
#include <algorithm>

#include "corpus/fuzz/kind.hpp"
#include "corpus/fuzz/polygon.hpp"

namespace tetproof::corpus {
namespace {

// The domain is [-1, n]^2. Notch j of the top runs along x: its bottom is the line y = j, z = jx + e, its
// rims are y = j - w and y = j + w at z = Z. Notch i of the underside runs along y: its bottom is the line x
// = i, z = iy - e, its rims are x = i - w and x = i + w at z = -Z.
//
// Why the surface is embedded: top and underside are graphs over the domain, and z = xy lies between them.
// Each wall of a notch of the top is two triangles whose four corners have z > xy, and so has their common
// diagonal from (-1, j) to (n, j + w): at the share s of the way, z - xy = (1 - s) e + s (Z - jn - wn) + s w
// (n + 1)(1 - s), where Z > n^2. For fixed y both the wall and xy are linear in x between the diagonal and
// the ends, so that z > xy on all of the wall. The underside is the same with x and y exchanged, mirrored.
// The four sides are cut exactly.
Shape chazelle(const Numbers& values) {
  const int n = values.integer("n");
  const double e = values["e"], w = values["w"], Z = static_cast<double>(n) * n + 1;
  Collector all;
  // The profile of one side of the domain: from (-1, Z) to (n, Z), with the bottoms of the notches at the
  // given slope. The side lies at x = slope (top) or y = slope (underside).
  const auto profile = [&](double slope) {
    std::vector<Eigen::Vector2d> line{{-1, Z}};
    for (int j = 0; j < n; ++j) {
      line.emplace_back(j - w, Z);
      line.emplace_back(j, j * slope + e);
      line.emplace_back(j + w, Z);
    }
    line.emplace_back(n, Z);
    return line;
  };
  const std::vector<Eigen::Vector2d> low = profile(-1), high = profile(n);
  // Along the underside z = -(height of the top's profile for -slope): z = i y - e at y = slope.
  const std::vector<Eigen::Vector2d> low_under = profile(1), high_under = profile(-n);
  const auto triangle = [&](bool turned, Eigen::Vector3d a, Eigen::Vector3d b, Eigen::Vector3d c) {
    turned ? all.triangle(a, c, b) : all.triangle(a, b, c);
  };
  for (std::size_t k = 0; k + 1 < low.size(); ++k) {
    const auto top = [&](double x, const Eigen::Vector2d& p) { return Eigen::Vector3d(x, p[0], p[1]); };
    all.triangle(top(-1, low[k]), top(n, high[k]), top(n, high[k + 1]));
    all.triangle(top(-1, low[k]), top(n, high[k + 1]), top(-1, low[k + 1]));
    const auto under = [&](double y, const Eigen::Vector2d& p) { return Eigen::Vector3d(p[0], y, -p[1]); };
    all.triangle(under(-1, low_under[k]), under(n, high_under[k]), under(n, high_under[k + 1]));
    all.triangle(under(-1, low_under[k]), under(n, high_under[k + 1]), under(-1, low_under[k + 1]));
  }
  // The sides x = -1 and x = n have the top's profile and a straight lower edge, y = -1 and y = n the other
  // way round. `place` maps (along, up) to the point.
  const auto side = [&](std::vector<Eigen::Vector2d> line, bool turned, auto place) {
    std::reverse(line.begin(), line.end());
    std::vector<Eigen::Vector2d> outline{{-1, -Z}, {n, -Z}};
    outline.insert(outline.end(), line.begin(), line.end());
    for (const auto& [a, b, c] : cut_polygon(outline))
      triangle(turned, place(outline[a]), place(outline[b]), place(outline[c]));
  };
  side(high, false, [&](const Eigen::Vector2d& p) { return Eigen::Vector3d(n, p[0], p[1]); });
  side(low, true, [&](const Eigen::Vector2d& p) { return Eigen::Vector3d(-1, p[0], p[1]); });
  side(high_under, false, [&](const Eigen::Vector2d& p) { return Eigen::Vector3d(p[0], n, -p[1]); });
  side(low_under, true, [&](const Eigen::Vector2d& p) { return Eigen::Vector3d(p[0], -1, -p[1]); });
  return one_body(all.take());
}

}  // namespace

std::vector<FuzzKind> chazelle_kinds() {
  return {
      {"chazelle",
       "Chazelle's polyhedron: a box with n notches from above and n from below, nearly meeting along z = xy",
       "every mesh of it needs many points inside; long edges a hair apart",
       {{"n", Draw::integer, 1, 60, 1, 8, 1, "notches from each side"},
        {"e", Draw::length, 1e-9, 0.5, 1e-5, 0.5, 0.5, "from the notches' bottoms to z = xy"},
        {"w", Draw::share, 1e-3, 0.499, 0.01, 0.49, 0.25, "half the width of a notch at its rim"}},
       chazelle}};
}

}  // namespace tetproof::corpus
