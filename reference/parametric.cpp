// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/parametric.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>
#include <stdexcept>

#include "reference/contacts.hpp"
#include "reference/exact.hpp"

namespace tetproof::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 cgal_point(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

// Barycentric coordinates of a point of the triangle's plane.
Eigen::Vector3d barycentric(const std::array<Eigen::Vector3d, 3>& t, const Eigen::Vector3d& p) {
  const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double area = normal.squaredNorm();
  const double b = (p - t[0]).cross(t[2] - t[0]).dot(normal) / area;
  const double c = (t[1] - t[0]).cross(p - t[0]).dot(normal) / area;
  return {1 - b - c, b, c};
}

}  // namespace

struct TrueSurface::Tree {
  const TriangleSurface& surface;
  Triangles triangles;
  AabbTree tree;
};

TrueSurface::TrueSurface(const TriangleSurface& surface) : tree_(new Tree{surface, {}, {}}) {
  if (!surface.evaluate || surface.parameters.size() != surface.triangles.size())
    throw std::logic_error("the surface has no parametric definition");
  for (const auto& [a, b, c] : surface.triangles)
    tree_->triangles.emplace_back(cgal_point(surface.vertices[a]), cgal_point(surface.vertices[b]),
                                  cgal_point(surface.vertices[c]));
  tree_->tree.insert(tree_->triangles.cbegin(), tree_->triangles.cend());
  tree_->tree.accelerate_distance_queries();
}

TrueSurface::~TrueSurface() = default;

Eigen::Vector3d TrueSurface::operator()(const Eigen::Vector3d& point) const {
  const auto primitive = tree_->tree.closest_point_and_primitive(cgal_point(point)).second;
  const auto triangle = primitive - tree_->triangles.cbegin();
  const auto& [a, b, c] = tree_->surface.triangles[triangle];
  const auto& x = tree_->surface.vertices;
  const std::array corners{x[a], x[b], x[c]};
  const Eigen::Vector3d weights = barycentric(corners, closest_point(corners, point));
  const auto& [ua, ub, uc] = tree_->surface.parameters[triangle];
  const Eigen::Vector3d mapped = tree_->surface.evaluate(weights[0] * ua + weights[1] * ub + weights[2] * uc);
  return mapped.allFinite() ? mapped : point;
}

std::vector<MappedPoint> move_surface_points(Grid& grid, const TrueSurface& surface) {
  TetMesh& mesh = grid.mesh;
  std::vector<std::uint32_t> first(mesh.points.size() + 1, 0);  // the tetrahedra around each point
  for (const auto& tet : mesh.tets)
    for (const Index p : tet) ++first[p + 1];
  for (std::size_t p = 1; p < first.size(); ++p) first[p] += first[p - 1];
  std::vector<Index> around(4 * mesh.tets.size());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const Index p : mesh.tets[t]) around[next[p]++] = static_cast<Index>(t);

  const auto positive = [&](Index t) {
    const auto& [a, b, c, d] = mesh.tets[t];
    return orientation(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]) > 0;
  };
  std::vector<MappedPoint> mapped;
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    if (!grid.on_surface[p]) continue;
    const Eigen::Vector3d from = mesh.points[p], to = surface(from);
    if (to == from) continue;
    mesh.points[p] = to;
    const bool moved = std::all_of(around.begin() + first[p], around.begin() + first[p + 1], positive);
    if (!moved) mesh.points[p] = from;
    mapped.push_back({static_cast<Index>(p), from, to, moved});
  }
  return mapped;
}

}  // namespace tetproof::reference
