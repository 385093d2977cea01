// SPDX-License-Identifier: GPL-3.0-or-later
// The generator of nested spheres: a body with a cavity, which may hold another body with a cavity, and so
// on.
#include <cmath>
#include <numbers>

#include "corpus/generators/generators.hpp"
#include "corpus/generators/octahedral_grid.hpp"

namespace tetproof::corpus {
namespace {

double radius(const Values& values, int shell) {
  const int count = static_cast<int>(values["count"]);
  const double outer = values["r"], inner = values["inner"];
  if (!(inner < outer)) values.refuse("inner: expected less than r");
  return shell == 0 ? outer : shell == count - 1 ? inner : outer + (inner - outer) * shell / (count - 1);
}

TriangleSurface make(const Values& values) {
  const Eigen::Vector3d centre = values.vector("x", "y", "z");
  const int count = static_cast<int>(values["count"]);
  const int f = octahedral_frequency(values["n"] / count);
  std::vector<double> radii;
  for (int shell = 0; shell < count; ++shell) radii.push_back(radius(values, shell));
  if (centre.cwiseAbs().maxCoeff() > 1e6 * radii.back())
    values.refuse("the centre is more than a million radii from the origin");
  // The triangles of a sphere lie inside it, so they must not reach the next inner sphere. Their distance
  // from the centre is at least cos(a) of the radius, where a is the angular circumradius of the largest
  // triangle, below 1.1 / f.
  const double least = f == 1 ? 1 / std::sqrt(3.0) : 1 - 0.605 / (f * static_cast<double>(f));
  for (int shell = 1; shell < count; ++shell)
    if (!(radii[shell] < least * radii[shell - 1]))
      values.refuse("the shells are too close for so few triangles: they would intersect");

  TriangleSurface surface;
  surface.evaluate = [radii, centre](const Eigen::Vector2d& uv) {
    const double shell = std::floor((uv[0] + 2) / 4);  // shell i has u in 4 i + [-1, 1]
    return Eigen::Vector3d(centre + radii.at(static_cast<std::size_t>(shell)) *
                                        octahedral_direction({uv[0] - 4 * shell, uv[1]}));
  };
  for (int shell = 0; shell < count; ++shell) {
    const TriangleSurface one = octahedral_surface(
        f, [&](const Eigen::Vector3d& d) { return Eigen::Vector3d(centre + radii[shell] * d); }, 4.0 * shell);
    const Index first = static_cast<Index>(surface.vertices.size());
    surface.vertices.insert(surface.vertices.end(), one.vertices.begin(), one.vertices.end());
    for (std::size_t t = 0; t < one.triangles.size(); ++t) {
      auto [a, b, c] = one.triangles[t];
      auto parameters = one.parameters[t];
      if (shell % 2 == 1) {  // a cavity: its normals point into it, out of the solid
        std::swap(b, c);
        std::swap(parameters[1], parameters[2]);
      }
      surface.triangles.push_back({first + a, first + b, first + c});
      surface.parameters.push_back(parameters);
    }
  }
  return surface;
}

std::optional<double> volume(const Values& values) {
  double sum = 0;
  for (int shell = 0; shell < static_cast<int>(values["count"]); ++shell)
    sum += (shell % 2 == 0 ? 1 : -1) * std::pow(radius(values, shell), 3);
  return 4.0 / 3.0 * std::numbers::pi * sum;
}

}  // namespace

Generator shells_generator() {
  return {.name = "shells",
          .meaning =
              "nested spheres with evenly spaced radii from r to inner: a body with a cavity (count=2), a "
              "body in it (3) ...",
          .parameters = {{"r", 1, 1e-9, 1e9, "outermost radius"},
                         {"inner", 0.5, 1e-9, 1e9, "innermost radius"},
                         {"count", 2, 2, 8, "number of spheres", Kind::integer},
                         {"n", 5000, 16, most_triangles,
                          "approximate number of triangles of all spheres together", Kind::integer},
                         {"x", 0, -1e12, 1e12, "centre"},
                         {"y", 0, -1e12, 1e12, "centre"},
                         {"z", 0, -1e12, 1e12, "centre"}},
          .volume_text = "4/3 pi times the alternating sum of the radii cubed",
          .make = make,
          .volume = volume};
}

}  // namespace tetproof::corpus
