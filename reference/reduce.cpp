// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/reduce.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "io/error.hpp"

namespace tetproof::reference {
namespace {

namespace simplification = CGAL::Surface_mesh_simplification;
namespace processing = CGAL::Polygon_mesh_processing;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

// Moves the surface to the origin and scales it to a size around 1, by a power of two, because the costs are
// polynomials of degree 6 in the coordinates.
struct Frame {
  Eigen::Vector3d centre;
  int exponent = 0;

  explicit Frame(const TriangleSurface& surface) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : surface.vertices) box.extend(p);
    centre = 0.5 * (box.min() + box.max());
    std::frexp((box.max() - box.min()).maxCoeff(), &exponent);
  }
  Point in(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d q = p - centre;
    return {std::ldexp(q.x(), -exponent), std::ldexp(q.y(), -exponent), std::ldexp(q.z(), -exponent)};
  }
  Eigen::Vector3d out(const Point& p) const {
    return centre + Eigen::Vector3d(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                                    std::ldexp(p.z(), exponent));
  }
};

Mesh mesh_of(const TriangleSurface& surface, const Frame& frame) {
  std::vector<std::array<std::size_t, 3>> polygons;
  for (const auto& t : surface.triangles) {
    std::array<std::size_t, 3> polygon;
    for (int i = 0; i < 3; ++i) {
      if (t[i] < 0 || t[i] >= static_cast<Index>(surface.vertices.size()))
        throw InputError(fmt::format("the surface cannot be reduced: it has no vertex {}", t[i]));
      polygon[i] = static_cast<std::size_t>(t[i]);
    }
    polygons.push_back(polygon);
  }
  if (!processing::is_polygon_soup_a_polygon_mesh(polygons))
    throw InputError("the surface cannot be reduced: it is not 2-manifold, or not consistently oriented");
  std::vector<Point> points;
  for (const Eigen::Vector3d& p : surface.vertices) points.push_back(frame.in(p));
  Mesh mesh;
  processing::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  if (!CGAL::is_closed(mesh)) throw InputError("the surface cannot be reduced: it is open");
  return mesh;
}

struct EnoughTriangles {
  std::size_t triangles;
  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile& profile, std::size_t, std::size_t) const {
    return profile.surface_mesh().number_of_faces() <= triangles;
  }
};

void collapse_edges(Mesh& mesh, std::size_t triangles) {
  const simplification::Bounded_normal_change_placement<simplification::LindstromTurk_placement<Mesh>>
      placement;
  simplification::edge_collapse(
      mesh, EnoughTriangles{triangles},
      CGAL::parameters::get_cost(simplification::LindstromTurk_cost<Mesh>()).get_placement(placement));
}

// Moves the vertices back to the place and size of the surface. A vertex that no collapse moved gets its old
// coordinates back, bit for bit.
Mesh moved_back(Mesh mesh, const TriangleSurface& before, const Frame& frame) {
  for (const auto v : mesh.vertices()) {
    const Eigen::Vector3d& old = before.vertices[v.idx()];
    const Eigen::Vector3d p = mesh.point(v) == frame.in(old) ? old : frame.out(mesh.point(v));
    mesh.point(v) = Point(p.x(), p.y(), p.z());
  }
  return mesh;
}

TriangleSurface surface_of(const Mesh& mesh, std::size_t vertices_before) {
  TriangleSurface surface;
  std::vector<Index> number(vertices_before, -1);
  for (const auto v : mesh.vertices()) {  // the remaining ones, ascending
    number[v.idx()] = static_cast<Index>(surface.vertices.size());
    const Point& p = mesh.point(v);
    surface.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : mesh.faces()) {
    std::array<Index, 3> corners;
    int i = 0;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) corners[i++] = number[v.idx()];
    surface.triangles.push_back(corners);
  }
  return surface;
}

}  // namespace

TriangleSurface reduce(const TriangleSurface& surface, int triangles) {
  if (triangles < 4)
    throw InputError(fmt::format("reduction: expected at least 4 triangles, found {}", triangles));
  const auto wanted = static_cast<std::size_t>(triangles);
  if (surface.triangles.size() <= wanted) return surface;

  for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    if (!surface.vertices[v].allFinite())
      throw InputError(fmt::format("the surface cannot be reduced: vertex {} is not finite", v));
  const Frame frame(surface);
  const Mesh whole = mesh_of(surface, frame);
  const auto reduced = [&](Mesh mesh, std::size_t most) {
    collapse_edges(mesh, most);
    return mesh;
  };
  const auto back = [&](const Mesh& mesh) { return moved_back(mesh, surface, frame); };

  Mesh direct = back(reduced(whole, wanted));
  if (!processing::does_self_intersect(direct)) return surface_of(direct, surface.vertices.size());
  // So few triangles make the surface intersect itself. Reduce it in small steps instead, and take the last
  // step that does not.
  std::optional<Mesh> last;
  Mesh step = whole;
  for (std::size_t most = surface.triangles.size(); most > wanted && step.number_of_faces() <= most;) {
    most = std::max(wanted, most - std::max<std::size_t>(2, most / 10));
    step = reduced(std::move(step), most);
    if (Mesh here = back(step); !processing::does_self_intersect(here)) last = std::move(here);
  }
  return last ? surface_of(*last, surface.vertices.size()) : surface;
}

}  // namespace tetproof::reference
