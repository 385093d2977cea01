// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/adaptation/parametric.hpp"

#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version_macros.h>
#if CGAL_VERSION_MAJOR < 6
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#else
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#endif

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <span>
#include <stdexcept>

#include "reference/engine/adaptation/boundary_faces.hpp"
#include "reference/engine/adaptation/triangulation.hpp"
#include "reference/engine/first_grid/closest_point.hpp"
#include "reference/engine/first_grid/exact.hpp"

namespace tetproof::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
#if CGAL_VERSION_MAJOR < 6
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#else  // the same, renamed
using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Triangles::const_iterator>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#endif

Kernel::Point_3 cgal_point(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

// The barycentric coordinates of a point in the plane of the triangle.
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

  std::array<Eigen::Vector3d, 3> corners(std::size_t triangle) const {
    const auto& [a, b, c] = surface.triangles[triangle];
    return {surface.vertices[a], surface.vertices[b], surface.vertices[c]};
  }

  // The triangle with the smallest distance in doubles; of several the one whose sorted coordinates are
  // smallest (reading D12). The tree's own answer only bounds the distance.
  std::size_t closest_triangle(const Eigen::Vector3d& p) const {
    const auto squared_distance = [&](const std::array<Eigen::Vector3d, 3>& t) {
      return (closest_point(t, p) - p).squaredNorm();
    };
    const auto first = tree.closest_point_and_primitive(cgal_point(p)).second;
    std::size_t best = first - triangles.cbegin();
    double least = squared_distance(corners(best));
    const double reach = std::sqrt(least) + 1e-12 * (p.cwiseAbs().maxCoeff() + std::sqrt(least));
    std::vector<AabbTree::Primitive_id> near;
    tree.all_intersected_primitives(CGAL::Bbox_3(p.x() - reach, p.y() - reach, p.z() - reach, p.x() + reach,
                                                 p.y() + reach, p.z() + reach),
                                    std::back_inserter(near));
    for (const auto& primitive : near) {
      const std::size_t candidate = primitive - triangles.cbegin();
      const auto t = corners(candidate);
      const double now = squared_distance(t);
      const auto less = [&] {
        const auto a = sorted_corners(t), b = sorted_corners(corners(best));
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), lexicographically_less);
      };
      if (now < least || (now == least && less())) least = now, best = candidate;
    }
    return best;
  }
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
  const std::size_t triangle = tree_->closest_triangle(point);
  const auto corners = tree_->corners(triangle);
  const Eigen::Vector3d weights = barycentric(corners, closest_point(corners, point));
  const auto& [ua, ub, uc] = tree_->surface.parameters[triangle];
  const Eigen::Vector3d mapped = tree_->surface.evaluate(weights[0] * ua + weights[1] * ub + weights[2] * uc);
  return mapped.allFinite() ? mapped : point;
}

namespace {

// For each point, the tetrahedra or faces that have it as a vertex.
template <class Simplex>
class Stars {
 public:
  Stars(const std::vector<Simplex>& simplices, std::size_t points) : first_(points + 1, 0) {
    for (const Simplex& simplex : simplices)
      for (const Index p : simplex) ++first_[p + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    members_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t s = 0; s < simplices.size(); ++s)
      for (const Index p : simplices[s]) members_[next[p]++] = s;
  }
  std::span<const std::size_t> of(std::size_t point) const {
    return std::span(members_).subspan(first_[point], first_[point + 1] - first_[point]);
  }

 private:
  std::vector<std::size_t> first_, members_;
};

std::vector<std::array<Index, 3>> boundary_of(const Grid& grid) {
  const Triangulation triangulation(grid.mesh, grid.on_surface);
  std::vector<std::array<Index, 3>> boundary;
  for (Index t = 0; t < triangulation.numbers(); ++t)
    for (int f = 0; f < 4; ++f)
      if (triangulation.neighbour(t, f) < 0) {
        const auto& [i, j, k] = tet_faces[f];
        const Corners& tet = triangulation.corners(t);
        boundary.push_back({tet[i], tet[j], tet[k]});
      }
  return boundary;
}

}  // namespace

std::vector<MappedPoint> move_surface_points(Grid& grid, const TrueSurface& surface) {
  TetMesh& mesh = grid.mesh;
  const std::vector<std::array<Index, 3>> boundary = boundary_of(grid);
  const Stars tets(mesh.tets, mesh.points.size());
  const Stars faces(boundary, mesh.points.size());
  const auto face = [&](std::size_t f) {
    const auto& [a, b, c] = boundary[f];
    return BoundaryFace{boundary[f], {mesh.points[a], mesh.points[b], mesh.points[c]}};
  };
  double longest = 0;
  for (std::size_t f = 0; f < boundary.size(); ++f) {
    const auto corners = face(f).corners;
    longest = std::max(longest, (corners[1] - corners[0]).norm());
  }
  BoundaryFaces places(longest);
  for (std::size_t f = 0; f < boundary.size(); ++f) places.add(face(f));

  const auto positive = [&](std::size_t t) {
    const auto& [a, b, c, d] = mesh.tets[t];
    return orientation(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]) > 0;
  };
  const auto add = [&](std::size_t f) { places.add(face(f)); };
  const auto remove = [&](std::size_t f) { places.remove(face(f)); };
  const auto all = [](const BoundaryFace&) { return true; };
  std::vector<MappedPoint> mapped;
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    if (!grid.on_surface[p]) continue;
    const Eigen::Vector3d from = mesh.points[p], to = surface(from);
    if (to == from) continue;
    const auto around = tets.of(p);
    const auto star = faces.of(p);
    std::for_each(star.begin(), star.end(), remove);
    mesh.points[p] = to;
    bool moved = std::all_of(around.begin(), around.end(), positive);
    for (std::size_t f = 0; moved && f < star.size(); ++f) {
      moved = !places.meets(face(star[f]), all);
      for (std::size_t g = 0; moved && g < f; ++g) moved = !faces_meet(face(star[f]), face(star[g]));
    }
    if (!moved) mesh.points[p] = from;
    std::for_each(star.begin(), star.end(), add);
    mapped.push_back({static_cast<Index>(p), from, to, moved});
  }
  return mapped;
}

}  // namespace tetproof::reference
