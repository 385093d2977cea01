// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that the faces of the boundary look the same way as the surface near them.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verify/checks/surface_comparison.hpp"
#include "verify/triangles/chunks.hpp"

namespace tetproof::verify {
namespace {

using Point = Eigen::Vector3d;

// The normal of a triangle, of length 1; 0 if the triangle has no area. Scaled by a power of two first, so
// that no product under- or overflows.
Point normal(std::span<const Point> points, const Triangle& t) {
  // Halved, so that the difference of two finite doubles is finite.
  Point a = points[t[1]] / 2 - points[t[0]] / 2, b = points[t[2]] / 2 - points[t[0]] / 2;
  const double largest = std::max(a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>());
  if (!(largest > 0)) return Point::Zero();
  const int exponent = std::ilogb(largest);
  for (Point* side : {&a, &b})
    for (double& x : *side) x = std::scalbn(x, -exponent);
  return a.cross(b).stableNormalized();
}

double angle_between(const Point& m, const Point& n) {
  return std::atan2(m.cross(n).norm(), m.dot(n)) * 180 / std::numbers::pi;
}

}  // namespace

void check_normals(const Comparison& c, const DistanceEvidence& distances, Record& record) {
  if (!record.wants(Check::normals) || distances.nearest_triangle.empty()) return;
  const TriangleTree& tree = *c.surface_tree;
  const std::vector<Point>& points = c.judged_mesh.mesh.points;
  // Normals point out of the solid. Where the mesh is around the solid, they point into it, as its faces do.
  const int way = c.judged_mesh.options.region == Region::outside ? -1 : 1;
  const auto surface_normal = [&](Index t) {
    return Point(
        way * c.judged.weights[static_cast<std::size_t>(c.judged.component_of[static_cast<std::size_t>(t)])] *
        normal(c.surface.vertices, c.surface.triangles[static_cast<std::size_t>(t)]));
  };
  const double reach = c.allowed / tree.units().scale + distance_slack;
  struct Turned {
    Finding at;
    double angle;
  };
  std::vector<double> largest((c.faces.size() + 1023) / 1024, -1);
  const std::vector<Turned> turned = collect_in_order<Turned>(
      c.faces.size(), 1024, [&](std::size_t begin, std::size_t end, std::vector<Turned>& found) {
        for (std::size_t f = begin; f < end; ++f) {
          // No triangle is as near as allowed: no direction is wrong here; the distances see the face.
          if (distances.nearest_triangle[f] < 0) continue;
          const Point m = normal(points, c.faces[f]);
          const Point n = surface_normal(distances.nearest_triangle[f]);
          if (!(m.squaredNorm() > 0) || !(n.squaredNorm() > 0)) continue;
          const double angle = angle_between(m, n);
          largest[begin / 1024] = std::max(largest[begin / 1024], angle);
          if (angle <= 90) continue;
          const std::array<Point, 3> corners = c.mesh_tree->corners(static_cast<Index>(f));
          bool any = false;
          const bool all =
              tree.for_each_within((corners[0] + corners[1] + corners[2]) / 3, reach, [&](Index t) {
                const Point other = surface_normal(t);
                any = true;
                return m.dot(other) < -1e-14 * other.norm();
              });
          if (all && any) found.push_back({c.at_face(static_cast<Index>(f)), angle});
        }
      });
  CheckResult& result = record.result(Check::normals);
  if (const double most = largest.empty() ? -1 : *std::max_element(largest.begin(), largest.end()); most >= 0)
    result.measured = most;
  result.allowed = 90;
  record[Check::normals] = {
      .count = turned.size(),
      .finding = [turned](std::size_t i) { return turned[i].at; },
      .describe =
          [turned](std::size_t i, Finding& finding) {
            finding.what = fmt::format(
                "the face's normal is turned by {:.6g} degrees from that of the nearest triangle of the "
                "surface, and from that of every one as near as allowed by more than 90",
                turned[i].angle);
          }};
}

}  // namespace tetproof::verify
