// SPDX-License-Identifier: GPL-3.0-or-later
// Finds a point that sees a whole solid, and joins the solid's triangles to it.
#include "star_mesh.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "corpus/meshing/nesting.hpp"

namespace tetproof::test {

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Eigen::Vector3d;

const Vector3d& corner(const TriangleSurface& surface, const std::array<Index, 3>& triangle, std::size_t k) {
  return surface.vertices[static_cast<std::size_t>(triangle[k])];
}

Point exact(const Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

/// Goes away from the nearest plane, in steps that become smaller: towards the point that is deepest inside.
Vector3d deepest(const TriangleSurface& surface, const std::vector<std::array<Index, 3>>& triangles) {
  Vector3d low = corner(surface, triangles[0], 0), high = low;
  std::vector<Vector3d> normals;
  for (const auto& t : triangles) {
    const Vector3d &a = corner(surface, t, 0), &b = corner(surface, t, 1), &c = corner(surface, t, 2);
    normals.push_back((b - a).cross(c - a).stableNormalized());
    low = low.cwiseMin(a).cwiseMin(b).cwiseMin(c);
    high = high.cwiseMax(a).cwiseMax(b).cwiseMax(c);
  }
  Vector3d point = (low + high) / 2, best = point;
  double best_depth = -std::numeric_limits<double>::infinity();
  for (int round = 0; round < 2000; ++round) {
    double depth = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const double d = normals[i].dot(corner(surface, triangles[i], 0) - point);
      if (d < depth) {
        depth = d;
        nearest = i;
      }
    }
    if (depth > best_depth) {
      best_depth = depth;
      best = point;
    }
    point -= (high - low).norm() / (round + 3) * normals[nearest];
  }
  return best;
}

}  // namespace

TetMesh star_mesh(const TriangleSurface& surface, bool fill_cavities) {
  const corpus::Nesting parts = corpus::nesting(surface);
  TetMesh mesh;
  mesh.points = surface.vertices;
  for (int part = 0; part < parts.parts(); ++part) {
    if (parts.depth[static_cast<std::size_t>(part)] % 2 != 0) {
      if (fill_cavities) continue;
      throw NotStarShaped("the solid has a cavity");
    }
    std::vector<std::array<Index, 3>> triangles;
    for (std::size_t i = 0; i < surface.triangles.size(); ++i)
      if (parts.part_of_triangle[i] == part) triangles.push_back(surface.triangles[i]);
    const Vector3d apex = deepest(surface, triangles);
    const auto number = static_cast<Index>(mesh.points.size());
    mesh.points.push_back(apex);
    for (const auto& t : triangles) {
      // Seen from outside a triangle runs anticlockwise, so that from inside it runs clockwise.
      if (CGAL::orientation(exact(corner(surface, t, 0)), exact(corner(surface, t, 2)),
                            exact(corner(surface, t, 1)), exact(apex)) != CGAL::POSITIVE)
        throw NotStarShaped("no point was found that sees the whole solid");
      mesh.tets.push_back({t[0], t[2], t[1], number});
    }
  }
  return mesh;
}

}  // namespace tetproof::test
