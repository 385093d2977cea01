// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of random surfaces around an axis: cylinders, spheres of slices, bipyramids, necks, pits, tori.
//
// A plane through the axis cuts each of these in a polygon (of the torus: two) that does not cross itself.
// Between the planes through neighbouring corners the surface is made of flat pieces, so that it is embedded.
// The corners' coordinates are off by 2^-52, and the least distances that the ranges permit exceed that a
// thousand times.
#include "corpus/fuzz/kind.hpp"
#include "corpus/fuzz/revolved.hpp"
#include "corpus/generators/turns.hpp"

namespace tetproof::corpus {
namespace {

FuzzParameter sides(double most, double high) {
  return {"n", Draw::integer, 3, most, 3, high, 3, "corners around the axis"};
}

Shape cylinder(const Numbers& values) {
  const double h = values["h"];
  const bool hub = values["hub"] == 1;
  const End bottom{hub ? std::optional(0.0) : std::nullopt}, top{hub ? std::optional(h) : std::nullopt};
  const int m = values.integer("m");
  std::vector<Ring> rings;
  for (int k = 0; k <= m; ++k) rings.push_back({1, h * k / m});
  return one_body(revolved(rings, values.integer("n"), bottom, top));
}

Shape uv_sphere(const Numbers& values) {
  const int m = values.integer("m");
  std::vector<Ring> rings;
  for (int k = 1; k < m; ++k) {
    const CosSin at = cos_sin_turns(static_cast<double>(m - k) / (2 * m));
    rings.push_back({at.sin, at.cos});
  }
  return one_body(revolved(rings, values.integer("n"), {-1.0}, {1.0}));
}

Shape bipyramid(const Numbers& values) {
  const double h = values["h"];
  return one_body(revolved({{1, 0}}, values.integer("n"), {-h}, {h}));
}

Shape hourglass(const Numbers& values) {
  const double h = values["h"];
  return one_body(revolved({{1, 0}, {values["e"], h / 2}, {1, h}}, values.integer("n"), {}, {}));
}

Shape pit(const Numbers& values) {
  const double h = values["h"];
  return one_body(revolved({{1, 0}, {1, h}}, values.integer("n"), {}, {h * values["gap"]}));
}

Shape torus(const Numbers& values) {
  const int n = values.integer("n"), m = values.integer("m");
  const double r = values["r"];
  TriangleSurface surface;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const CosSin around = cos_sin_turns(static_cast<double>(i) / n),
                   tube = cos_sin_turns(static_cast<double>(j) / m);
      const double ring = 1 + r * tube.cos;
      surface.vertices.emplace_back(ring * around.cos, ring * around.sin, r * tube.sin);
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const Index a = i * m + j, b = (i + 1) % n * m + j, c = (i + 1) % n * m + (j + 1) % m,
                  d = i * m + (j + 1) % m;
      surface.triangles.push_back({a, b, c});
      surface.triangles.push_back({a, c, d});
    }
  return one_body(std::move(surface), 1);
}

}  // namespace

std::vector<FuzzKind> revolved_kinds() {
  return {
      {"cylinder",
       "a prism with n sides and m storeys; its caps are fans",
       "vertices of high degree, needles, coplanar fans",
       {sides(5000, 60),
        {"h", Draw::length, 1e-9, 1e6, 1e-4, 1e2, 1, "height; the radius is 1"},
        {"m", Draw::integer, 1, 100, 1, 3, 1, "storeys"},
        {"hub", Draw::integer, 0, 1, 0, 1, 0, "the fans' tips: 0: a corner of the rim, 1: the centre"}},
       cylinder},
      {"uv-sphere",
       "a sphere of n slices and m stacks",
       "poles of high degree, cospherical rings, coplanar quadrilaterals",
       {sides(1000, 20), {"m", Draw::integer, 2, 500, 2, 10, 2, "stacks"}},
       uv_sphere},
      {"bipyramid",
       "two pyramids of height h over a regular polygon of n corners",
       "two vertices of high degree; flat or like a needle",
       {sides(5000, 50), {"h", Draw::length, 1e-9, 1e6, 1e-4, 1e3, 1, "height of each; the radius is 1"}},
       bipyramid},
      {"hourglass",
       "two frustums joined at a neck of radius e",
       "a neck that is nearly closed, edges a hair apart",
       {sides(1000, 30),
        {"e", Draw::length, 1e-9, 1, 1e-6, 0.9, 0.5, "radius of the neck; at the ends it is 1"},
        {"h", Draw::length, 1e-3, 1e3, 0.1, 10, 1, "height"}},
       hourglass},
      {"pit",
       "a prism of n sides with a pit in its top, down to `gap` of its height",
       "a tip a hair above a face that it does not meet in a vertex",
       {sides(1000, 30),
        {"gap", Draw::length, 1e-9, 0.9, 1e-6, 0.5, 0.5, "height of the pit's tip, of h"},
        {"h", Draw::length, 1e-3, 1e3, 0.1, 10, 1, "height"}},
       pit},
      {"torus",
       "a torus of n sections of m corners",
       "a hole, or nearly none; coplanar rings",
       {sides(1000, 12),
        {"m", Draw::integer, 3, 1000, 3, 8, 3, "corners of a section"},
        {"r", Draw::share, 1e-3, 0.9999, 0.05, 0.99, 0.5,
         "radius of the tube; that of its centre line is 1"}},
       torus},
  };
}

}  // namespace tetproof::corpus
