// SPDX-License-Identifier: GPL-3.0-or-later
// The sphere: an octahedron whose faces are cut into f^2 triangles each, blown up; 8 f^2 triangles.
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
  return {"sphere",
          "a sphere: an octahedron blown up, 8 f^2 triangles with the f that comes nearest to n",
          {{"r", 1, 1e-9, 1e9, "radius"},
           {"n", 5000, 8, most_triangles, "triangles, about", Kind::integer},
           {"x", 0, -1e12, 1e12, "centre"},
           {"y", 0, -1e12, 1e12, "centre"},
           {"z", 0, -1e12, 1e12, "centre"}},
          "4/3 pi r^3",
          make,
          volume};
}

}  // namespace tetproof::corpus
