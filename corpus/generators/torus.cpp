// SPDX-License-Identifier: GPL-3.0-or-later
// The generator of tori around the z axis: a grid of planar trapezoids, each cut into two triangles.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "corpus/generators/generators.hpp"
#include "corpus/generators/turns.hpp"

namespace tetproof::corpus {
namespace {

TriangleSurface make(const Values& values) {
  const double R = values["R"], r = values["r"];
  const Eigen::Vector3d centre = values.vector("x", "y", "z");
  if (!(r <= 0.999 * R)) values.refuse("r: expected at most 0.999 R; beyond it the torus has no hole");
  if (!(r >= 1e-3 * R)) values.refuse("r: expected at least 0.001 R");
  if (centre.cwiseAbs().maxCoeff() > 1e6 * r)
    values.refuse("the centre is more than a million r from the origin");

  TriangleSurface surface;
  // u: turns around the axis; v: turns around the tube, from the outermost circle upwards.
  surface.evaluate = [R, r, centre](const Eigen::Vector2d& uv) {
    const CosSin u = cos_sin_turns(uv[0]), v = cos_sin_turns(uv[1]);
    const double ring = R + r * v.cos;
    return Eigen::Vector3d(centre + Eigen::Vector3d(ring * u.cos, ring * u.sin, r * v.sin));
  };

  const double pairs = values["n"] / 2;
  const int nv = std::max(3, static_cast<int>(std::lround(std::sqrt(pairs * r / R))));
  const int nu = std::max(3, static_cast<int>(std::lround(pairs / nv)));
  const auto uv = [&](int i, int j) {
    return Eigen::Vector2d(static_cast<double>(i) / nu, static_cast<double>(j) / nv);
  };
  const auto vertex = [&](int i, int j) { return static_cast<Index>((i % nu) * nv + j % nv); };
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) surface.vertices.push_back(surface.evaluate(uv(i, j)));
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const Index a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      surface.triangles.push_back({a, b, c});
      surface.triangles.push_back({a, c, d});
      surface.parameters.push_back({uv(i, j), uv(i + 1, j), uv(i + 1, j + 1)});
      surface.parameters.push_back({uv(i, j), uv(i + 1, j + 1), uv(i, j + 1)});
    }
  return surface;
}

std::optional<double> volume(const Values& values) {
  const double R = values["R"], r = values["r"];
  return 2 * std::numbers::pi * std::numbers::pi * R * r * r;
}

}  // namespace

Generator torus_generator() {
  return {.name = "torus",
          .meaning =
              "a torus around the z axis: a grid of nu x nv quadrilaterals, nu / nv about R / r, 2 nu nv "
              "triangles",
          .parameters = {{"R", 1, 1e-9, 1e9, "radius of the tube's centre line"},
                         {"r", 0.4, 1e-12, 1e9, "radius of the tube, 0.001 R to 0.999 R"},
                         {"n", 5000, 18, most_triangles, "approximate number of triangles", Kind::integer},
                         {"x", 0, -1e12, 1e12, "centre"},
                         {"y", 0, -1e12, 1e12, "centre"},
                         {"z", 0, -1e12, 1e12, "centre"}},
          .volume_text = "2 pi^2 R r^2",
          .make = make,
          .volume = volume};
}

}  // namespace tetproof::corpus
