// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/constrained.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>
#include <utility>

namespace tetproof::io {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Data =
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<std::int32_t, Kernel>,
                                         CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data, CGAL::No_constraint_intersection_tag>;
using Exact = CGAL::Exact_rational;

Point point(const Eigen::Vector2d& p) {
  return {p[0], p[1]};
}

Kernel::Point_3 point(const Eigen::Vector3d& p) {
  return {p[0], p[1], p[2]};
}

// Follows an edge over the points that lie on it.
void add_pieces(const Triangulation& triangulation, Triangulation::Vertex_handle from,
                Triangulation::Vertex_handle to, const PlaneEdge& edge, std::vector<PlaneEdge>& pieces) {
  while (from != to) {
    auto next = to;
    auto around = triangulation.incident_vertices(from);
    const auto first = around;
    do {
      const Triangulation::Vertex_handle vertex = around;
      if (!triangulation.is_infinite(vertex) && vertex != to &&
          CGAL::collinear(from->point(), vertex->point(), to->point()) &&
          CGAL::collinear_are_strictly_ordered_along_line(from->point(), vertex->point(), to->point()))
        next = vertex;
    } while (++around != first);
    pieces.push_back({{from->info(), next->info()}, edge.count, edge.net});
    from = next;
  }
}

// The determinant of the three points' coordinates and heights, and a bound of its terms.
template <class Number>
Number circle_determinant(const PlaneSlope& slope, const std::array<std::array<Number, 2>, 3>& p,
                          bool magnitudes) {
  const Number su(slope.u), sv(slope.v);
  const auto magnitude = [&](const Number& x) -> Number { return magnitudes && x < 0 ? Number(-x) : x; };
  std::array<Number, 3> height;
  for (std::size_t i = 0; i < 3; ++i) {
    const Number &u = p[i][0], &v = p[i][1];
    height[i] = u * u + v * v + magnitude(su * su * u * u) + magnitude(2 * su * sv * u * v) + sv * sv * v * v;
  }
  const auto minor = [&](std::size_t i, std::size_t j) -> Number {
    return magnitude(p[i][0] * p[j][1]) + magnitude(-p[j][0] * p[i][1]);
  };
  return magnitude(height[0]) * minor(1, 2) + magnitude(height[1]) * minor(2, 0) +
         magnitude(height[2]) * minor(0, 1);
}

}  // namespace

std::optional<PlaneTriangulation> constrained_triangulation(const std::vector<Eigen::Vector2d>& points,
                                                            const std::vector<PlaneEdge>& edges) {
  Triangulation triangulation;
  std::vector<std::pair<Point, std::int32_t>> all;
  for (const Eigen::Vector2d& p : points) all.emplace_back(point(p), static_cast<std::int32_t>(all.size()));
  triangulation.insert(all.begin(), all.end());
  std::vector<Triangulation::Vertex_handle> vertex(points.size());
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v)
    vertex[static_cast<std::size_t>(v->info())] = v;
  const auto ends = [&](const PlaneEdge& edge) {
    return std::pair(vertex[static_cast<std::size_t>(edge.ends[0])],
                     vertex[static_cast<std::size_t>(edge.ends[1])]);
  };
  try {
    for (const PlaneEdge& edge : edges) triangulation.insert_constraint(ends(edge).first, ends(edge).second);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return {};
  }
  PlaneTriangulation result;
  if (triangulation.dimension() < 2) return result;
  for (const PlaneEdge& edge : edges)
    add_pieces(triangulation, ends(edge).first, ends(edge).second, edge, result.edges);
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
    result.triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return result;
}

int side_of_circle(const PlaneSlope& slope, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                   const Eigen::Vector2d& c, const Eigen::Vector2d& d) {
  const std::array<std::array<double, 2>, 3> p{
      {{a[0] - d[0], a[1] - d[1]}, {b[0] - d[0], b[1] - d[1]}, {c[0] - d[0], c[1] - d[1]}}};
  const double determinant = circle_determinant(slope, p, false), terms = circle_determinant(slope, p, true);
  // Each term has at most 12 roundings, differences included: 2e-15 of it. Products that underflow are below
  // 1e-290.
  if (std::isfinite(terms) && terms > 1e-200 && std::abs(determinant) > 1e-14 * terms)
    return determinant > 0 ? 1 : -1;
  std::array<std::array<Exact, 2>, 3> exact;
  const std::array<const Eigen::Vector2d*, 3> corners{&a, &b, &c};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      exact[i][k] = Exact((*corners[i])[axis]) - Exact(d[axis]);
    }
  return static_cast<int>(CGAL::sign(circle_determinant(slope, exact, false)));
}

int turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return static_cast<int>(CGAL::orientation(point(a), point(b), point(c)));
}

int side_of_plane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                  const Eigen::Vector3d& d) {
  return static_cast<int>(CGAL::orientation(point(a), point(b), point(c), point(d)));
}

bool same_side_of_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                       const Eigen::Vector3d& d) {
  return CGAL::coplanar_orientation(point(a), point(b), point(c), point(d)) == CGAL::POSITIVE;
}

bool on_a_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return CGAL::collinear(point(a), point(b), point(c));
}

int compare_lengths(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                    const Eigen::Vector3d& d) {
  return static_cast<int>(
      Kernel().compare_squared_distance_3_object()(point(a), point(b), point(c), point(d)));
}

}  // namespace tetproof::io
