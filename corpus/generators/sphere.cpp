// SPDX-License-Identifier: GPL-3.0-or-later
// The generator of spheres: an octahedron whose faces are divided into f^2 triangles each, projected onto the
// sphere.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "corpus/generators/generators.hpp"
#include "corpus/generators/octahedral_grid.hpp"

namespace tetproof::corpus {
namespace {

TriangleSurface make(const Values& values) {
  const double r = values["r"];
  const Eigen::Vector3d centre = values.vector("x", "y", "z");
  if (centre.cwiseAbs().maxCoeff() > 1e6 * r)
    values.refuse("the centre is more than a million radii from the origin");
  return octahedral_surface(octahedral_frequency(values["n"]), [r, centre](const Eigen::Vector3d& direction) {
    return Eigen::Vector3d(centre + r * direction);
  });
}

std::optional<double> volume(const Values& values) {
  return 4.0 / 3.0 * std::numbers::pi * std::pow(values["r"], 3);
}

}  // namespace

Generator sphere_generator() {
  return {.name = "sphere",
          .meaning = "a sphere: a subdivided octahedron, 8 f^2 triangles with the f that comes nearest to n",
          .parameters = {{"r", 1, 1e-9, 1e9, "radius"},
                         {"n", 5000, 8, most_triangles, "approximate number of triangles", Kind::integer},
                         {"x", 0, -1e12, 1e12, "centre"},
                         {"y", 0, -1e12, 1e12, "centre"},
                         {"z", 0, -1e12, 1e12, "centre"}},
          .volume_text = "4/3 pi r^3",
          .make = make,
          .volume = volume};
}

}  // namespace tetproof::corpus
