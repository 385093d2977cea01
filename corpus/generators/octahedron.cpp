// SPDX-License-Identifier: GPL-3.0-or-later
// The generator of octahedra with their vertices on the axes. If the centre is a lattice vertex and r is an
// integer number of cells, the edges run through lattice vertices. If r is half a cell more, the vertices lie
// on lattice edges.
#include "corpus/generators/generators.hpp"

namespace tetproof::corpus {
namespace {

TriangleSurface make(const Values& values) {
  const Eigen::Vector3d centre = values.vector("x", "y", "z"), r = values.vector("rx", "ry", "rz");
  if (centre.cwiseAbs().maxCoeff() > 1e6 * r.minCoeff())
    values.refuse("the centre is more than a million radii from the origin");
  if (r.maxCoeff() > 1e6 * r.minCoeff()) values.refuse("rx, ry, rz: expected within a factor of a million");
  TriangleSurface surface;
  for (int axis = 0; axis < 3; ++axis)
    for (const int sign : {1, -1}) {
      Eigen::Vector3d v = centre;
      v[axis] += sign * r[axis];
      surface.vertices.push_back(v);
    }
  for (Index octant = 0; octant < 8; ++octant) {
    const Index x = octant & 1, y = 2 + (octant >> 1 & 1), z = 4 + (octant >> 2);
    const bool mirrored = (x ^ (y & 1) ^ (z & 1)) != 0;
    surface.triangles.push_back(mirrored ? std::array<Index, 3>{x, z, y} : std::array<Index, 3>{x, y, z});
  }
  return surface;
}

std::optional<double> volume(const Values& values) {
  return 4.0 / 3.0 * values["rx"] * values["ry"] * values["rz"];
}

}  // namespace

Generator octahedron_generator() {
  return {.name = "octahedron",
          .meaning = "an octahedron with its vertices on the axes, 8 triangles",
          .parameters = {{"rx", 1, 1e-9, 1e9, "from the centre to the vertices along x"},
                         {"ry", 1, 1e-9, 1e9, "along y"},
                         {"rz", 1, 1e-9, 1e9, "along z"},
                         {"x", 0, -1e12, 1e12, "centre"},
                         {"y", 0, -1e12, 1e12, "centre"},
                         {"z", 0, -1e12, 1e12, "centre"}},
          .volume_text = "4/3 rx ry rz",
          .make = make,
          .volume = volume};
}

}  // namespace tetproof::corpus
