// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/fuzz/hull.hpp"

#include <algorithm>
#include <set>

#include "corpus/fuzz/exact_sides.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

using Face = std::array<Index, 3>;

// Whether three points lie on one line, exactly: then every fourth point is in a plane with them, so that
// three points off each other's planes decide.
bool on_a_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (turn({a[u], a[v]}, {b[u], b[v]}, {c[u], c[v]}) != 0) return false;
  }
  return true;
}

// Four points that do not lie in one plane, as a tetrahedron that is oriented outward.
std::vector<Face> first_faces(const std::vector<Eigen::Vector3d>& points) {
  const Index n = static_cast<Index>(points.size());
  const auto next = [n](Index from, auto good) {
    while (from < n && !good(from)) ++from;
    if (from == n) throw InputError("the points lie in one plane");
    return from;
  };
  if (n == 0) throw InputError("there are no points");
  const Index a = 0, b = next(1, [&](Index i) { return points[i] != points[a]; });
  Index c = next(b + 1, [&](Index i) { return !on_a_line(points[a], points[b], points[i]); });
  Index d = next(c + 1, [&](Index i) { return side(points[a], points[b], points[c], points[i]) != 0; });
  if (side(points[a], points[b], points[c], points[d]) < 0) std::swap(c, d);
  return {{a, c, b}, {a, b, d}, {b, c, d}, {a, d, c}};
}

}  // namespace

TriangleSurface convex_hull(const std::vector<Eigen::Vector3d>& points) {
  std::vector<Face> faces = first_faces(points);
  for (Index p = 0; p < static_cast<Index>(points.size()); ++p) {
    // The faces that the point lies strictly outside of are replaced by triangles from it to their rim. Faces
    // in a plane with the point stay: what they see of it is a triangle in their plane. No new triangle is
    // degenerate: a point on the line of an edge is not strictly outside of either of its faces.
    std::vector<Face> kept;
    std::set<std::array<Index, 2>> seen;
    for (const Face& f : faces) {
      if (side(points[f[0]], points[f[1]], points[f[2]], points[p]) <= 0) {
        kept.push_back(f);
        continue;
      }
      for (int k = 0; k < 3; ++k) seen.insert({f[k], f[(k + 1) % 3]});
    }
    for (const auto& [a, b] : seen)
      if (!seen.count({b, a})) kept.push_back({a, b, p});
    faces = std::move(kept);
  }
  TriangleSurface hull;
  std::vector<Index> number(points.size(), -1);
  for (Face& face : faces) {
    for (Index& corner : face) {
      if (number[corner] < 0) {
        number[corner] = static_cast<Index>(hull.vertices.size());
        hull.vertices.push_back(points[corner]);
      }
      corner = number[corner];
    }
    hull.triangles.push_back(face);
  }
  return hull;
}

}  // namespace tetproof::corpus
