// SPDX-License-Identifier: GPL-3.0-or-later
// The generator of random star-shaped surfaces.
#include "corpus/generators/generators.hpp"
#include "corpus/generators/octahedral_grid.hpp"
#include "corpus/generators/star.hpp"

namespace tetproof::corpus {
namespace {

Star star(const Values& values) {
  return {static_cast<std::uint64_t>(values["seed"]), values["r"], values["roughness"], values["waves"]};
}

TriangleSurface make(const Values& values) {
  const Eigen::Vector3d centre = values.vector("x", "y", "z");
  const double r = values["r"];
  if (centre.cwiseAbs().maxCoeff() > 1e6 * r)
    values.refuse("the centre is more than a million radii from the origin");
  // Seen from the centre, the triangles are those of the octahedral grid, so no two of them can intersect.
  return octahedral_surface(octahedral_frequency(values["n"]),
                            [star = star(values), centre](const Eigen::Vector3d& direction) {
                              return Eigen::Vector3d(centre + star.radius(direction) * direction);
                            });
}

std::optional<double> volume(const Values& values) {
  return star(values).volume();
}

}  // namespace

Generator random_generator() {
  return {.name = "random",
          .meaning = "a random smooth star-shaped body, 8 f^2 triangles with the f that comes nearest to n",
          .parameters = {{"seed", 1, 0, 9007199254740992, "seed of the random numbers", Kind::integer},
                         {"n", 5000, 8, most_triangles, "approximate number of triangles", Kind::integer},
                         {"r", 1, 1e-9, 1e9, "mean radius"},
                         {"roughness", 0.5, 0, 0.9, "the largest change of the radius, as a fraction of r"},
                         {"waves", 1.5, 0, 4, "the highest frequency of the bumps, in waves along a radius"},
                         {"x", 0, -1e12, 1e12, "centre"},
                         {"y", 0, -1e12, 1e12, "centre"},
                         {"z", 0, -1e12, 1e12, "centre"}},
          .volume_text = "by quadrature, converged to 1e-12",
          .make = make,
          .volume = volume};
}

}  // namespace tetproof::corpus
