// SPDX-License-Identifier: GPL-3.0-or-later
// The distances between a mesh's boundary and a surface, and between their normals.
#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verify/checks/surface_comparison.hpp"
#include "verify/distance/directed_distance.hpp"
#include "verify/triangles/chunks.hpp"
#include "verify/triangles/on_triangle.hpp"

namespace tetproof::verify {
namespace {

using Point = Eigen::Vector3d;

CheckResult& result_of(Judgement& j, Check check) {
  return j.report.checks[static_cast<std::size_t>(check)];
}

Suspects one(Finding finding, std::optional<Cause> cause = {}) {
  return {.count = 1,
          .finding = [finding](std::size_t) { return finding; },
          .describe = [](std::size_t, Finding&) {},
          .cause = [cause](std::size_t) { return cause; }};
}

bool exactly_on(const Point& p, const TriangleSet& set, Index triangle) {
  const Triangle& v = set.triangles[static_cast<std::size_t>(triangle)];
  const std::array<Point, 3> corners{set.points[v[0]], set.points[v[1]], set.points[v[2]]};
  return p == corners[0] || p == corners[1] || p == corners[2] || on_triangle(p, corners);
}

struct OffVertex {
  Index vertex;
  double distance;  // [length], at least
  Index nearest;
};

// The vertices of the faces that are farther from the surface than allowed, the farthest first; `undecided`:
// some are inside the rounding error.
std::vector<OffVertex> off_vertices(const Judgement& j, const Comparison& c, bool& undecided) {
  const TriangleTree& tree = *c.surface_tree;
  std::vector<std::pair<Index, Index>> vertices;  // and a face
  {
    std::vector<std::uint8_t> seen(j.mesh.points.size(), 0);
    for (std::size_t f = 0; f < c.faces.size(); ++f)
      for (const Index v : c.faces[f])
        if (!seen[v]) seen[v] = 1, vertices.emplace_back(v, static_cast<Index>(f));
  }
  std::sort(vertices.begin(), vertices.end());
  const double allowed = c.allowed / tree.units().scale;
  // An undecided one is collected with a negative distance.
  std::vector<OffVertex> found = collect_in_order<OffVertex>(
      vertices.size(), 1024, [&](std::size_t begin, std::size_t end, std::vector<OffVertex>& off) {
        for (std::size_t i = begin; i < end; ++i) {
          const auto& [v, face] = vertices[i];
          const Point& p = j.mesh.points[static_cast<std::size_t>(v)];
          const Index guess = c.nearest_triangle.empty() ? -1 : c.nearest_triangle[face];
          const TriangleTree::Nearest nearest =
              tree.nearest(tree.units().to(p), guess, std::max(0.0, allowed - distance_slack));
          const double distance = std::sqrt(nearest.squared);
          if (distance + distance_slack <= allowed) continue;
          if (distance < 2 * distance_slack && exactly_on(p, tree.set(), nearest.triangle)) continue;
          const bool sure = distance - distance_slack > allowed;
          off.push_back({v, sure ? (distance - distance_slack) * tree.units().scale : -1, nearest.triangle});
        }
      });
  undecided = std::any_of(found.begin(), found.end(), [](const OffVertex& o) { return o.distance < 0; });
  std::erase_if(found, [](const OffVertex& o) { return o.distance < 0; });
  std::stable_sort(found.begin(), found.end(),
                   [](const OffVertex& a, const OffVertex& b) { return a.distance > b.distance; });
  return found;
}

void check_vertices(Judgement& j, const Comparison& c, const std::vector<OffVertex>& off, bool undecided) {
  CheckResult& result = result_of(j, Check::off_surface_vertex);
  result.allowed = c.allowed;
  if (!off.empty()) result.measured = off[0].distance;
  if (undecided) result.verdict = Verdict::undecided;
  const auto& points = j.mesh.points;
  j[Check::off_surface_vertex] = {
      off.size(), [off](std::size_t i) { return Finding{.vertices = {off[i].vertex}}; },
      [off, &points, allowed = c.allowed](std::size_t i, Finding& finding) {
        finding.point = points[static_cast<std::size_t>(off[i].vertex)];
        finding.what =
            fmt::format("the vertex is {:.6g} from the surface, allowed {:.6g}; nearest triangle {}",
                        off[i].distance, allowed, off[i].nearest);
      }};
}

// The first of those vertices that the face has.
std::optional<Cause> vertex_of(const Triangle& face, const std::vector<OffVertex>& off) {
  for (std::size_t i = 0; i < off.size(); ++i)
    if (std::count(face.begin(), face.end(), off[i].vertex)) return Cause{Check::off_surface_vertex, i};
  return std::nullopt;
}

// What an interval says about the allowed distance. True if it is larger.
bool judge_distance(Judgement& j, Check check, const DirectedDistance& distance, double allowed) {
  CheckResult& result = result_of(j, check);
  result.measured = distance.lower;
  result.allowed = allowed;
  if (distance.lower > allowed) return true;
  if (distance.upper > allowed) result.verdict = Verdict::undecided;
  return false;
}

double angle_between(const Point& m, const Point& n) {
  return std::atan2(m.cross(n).norm(), m.dot(n)) * 180 / std::numbers::pi;
}

Point normal(std::span<const Point> points, const Triangle& t) {
  return (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
}

}  // namespace

Comparison::Comparison(const Judgement& j, const TriangleSurface& surface_, const SurfaceJudgement& judged_,
                       const std::vector<int>& own)
    : surface(surface_),
      judged(judged_),
      allowed(j.options.fidelity * (judged_.report.box_max - judged_.report.box_min).stableNorm()) {
  const std::span<const Triangle> boundary = j.boundary.boundary_triangles();
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const Index sheet = j.boundary.sheets.of_triangle[i];
    if (sheet >= 0 && own[sheet]) continue;
    faces.push_back(boundary[i]);
    ids.push_back(j.boundary.faces[i]);
    sheets.push_back(sheet);
  }
  const std::array<TriangleSet, 2> sets{TriangleSet{j.mesh.points, faces},
                                        TriangleSet{surface.vertices, surface.triangles}};
  const Units units = units_of(sets);
  if (!units.usable) return;
  mesh_tree.emplace(sets[0], units);
  surface_tree.emplace(sets[1], units);
}

void check_distances(Judgement& j, Comparison& c) {
  if (!j.wants(Check::off_surface_vertex) && !j.wants(Check::mesh_to_surface) &&
      !j.wants(Check::surface_to_mesh) && !j.wants(Check::normals))
    return;
  const bool coarse = j.options.coarse;
  DistanceQuestion question{
      .options = {.error = j.options.fidelity > 0 ? c.allowed / 10 : 1e-4 * c.mesh_tree->units().diagonal,
                  .relative = coarse ? 0 : 0.2,
                  .most_pieces = 2'000'000 + 30 * static_cast<std::int64_t>(c.mesh_tree->size() +
                                                                            c.surface_tree->size())},
      .allowed = c.allowed,
      .only_decide = coarse};
  Fidelity& fidelity = j.report.fidelity.emplace();
  fidelity.allowed = c.allowed;
  double widest = 0;
  const bool to_surface =
      j.wants(Check::mesh_to_surface) || j.wants(Check::normals) || j.wants(Check::off_surface_vertex);
  if (to_surface && !c.faces.empty()) {
    question.nearest = &c.nearest_triangle;
    c.to_surface = directed_distance(*c.mesh_tree, *c.surface_tree, question);
    fidelity.mesh_to_surface = c.to_surface->lower;
    widest = std::max(widest, c.to_surface->upper - c.to_surface->lower);
  }
  std::vector<OffVertex> off;
  if (j.wants(Check::off_surface_vertex)) {
    bool undecided = false;
    off = off_vertices(j, c, undecided);
    check_vertices(j, c, off, undecided);
    for (const OffVertex& o : off) c.off_vertices.push_back(o.vertex);
  }
  if (j.wants(Check::mesh_to_surface) && c.to_surface &&
      judge_distance(j, Check::mesh_to_surface, *c.to_surface, c.allowed)) {
    Finding finding = c.at_face(c.to_surface->triangle);
    finding.point = c.to_surface->point;
    finding.what = fmt::format(
        "the face is {:.6g} from the surface here, at most {:.6g} anywhere, allowed {:.6g}; nearest triangle "
        "{}",
        c.to_surface->lower, c.to_surface->upper, c.allowed, c.to_surface->nearest);
    j[Check::mesh_to_surface] = one(finding, vertex_of(c.faces[c.to_surface->triangle], off));
  }
  if (j.wants(Check::surface_to_mesh)) {
    if (c.faces.empty()) {
      result_of(j, Check::surface_to_mesh).allowed = c.allowed;
      j[Check::surface_to_mesh] = one({.what = "no face of the mesh's boundary is the surface's"});
    } else {
      question.nearest = &c.nearest_face;
      c.to_mesh = directed_distance(*c.surface_tree, *c.mesh_tree, question);
      fidelity.surface_to_mesh = c.to_mesh->lower;
      widest = std::max(widest, c.to_mesh->upper - c.to_mesh->lower);
      if (judge_distance(j, Check::surface_to_mesh, *c.to_mesh, c.allowed)) {
        Finding finding = c.at_face(c.to_mesh->nearest);
        finding.point = c.to_mesh->point;
        finding.what = fmt::format(
            "the surface's triangle {} is {:.6g} from the mesh's boundary here, at most {:.6g} anywhere, "
            "allowed "
            "{:.6g}; the face is the nearest",
            c.to_mesh->triangle, c.to_mesh->lower, c.to_mesh->upper, c.allowed);
        j[Check::surface_to_mesh] = one(finding, vertex_of(c.faces[c.to_mesh->nearest], off));
      }
    }
  }
  fidelity.error_bound = widest;
}

void check_normals(Judgement& j, const Comparison& c) {
  if (c.nearest_triangle.empty() || j.options.coarse) return;
  const TriangleTree& tree = *c.surface_tree;
  // Out of the solid, or, as the mesh's own faces are, into it where the mesh is around the solid.
  const int way = j.options.region == Region::outside ? -1 : 1;
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
          const Point m = normal(j.mesh.points, c.faces[f]);
          const Point n = surface_normal(c.nearest_triangle[f]);
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
                return m.dot(other) < -1e-14 * m.norm() * other.norm();
              });
          if (all && any) found.push_back({c.at_face(static_cast<Index>(f)), angle});
        }
      });
  CheckResult& result = result_of(j, Check::normals);
  if (const double most = largest.empty() ? -1 : *std::max_element(largest.begin(), largest.end()); most >= 0)
    result.measured = most;
  result.allowed = 90;
  const std::size_t count = turned.size();
  j[Check::normals] = {
      count, [turned](std::size_t i) { return turned[i].at; },
      [turned](std::size_t i, Finding& finding) {
        finding.what = fmt::format(
            "the face's normal is turned by {:.6g} degrees from that of the nearest triangle of the "
            "surface, and from that of every one as near as allowed by more than 90",
            turned[i].angle);
      }};
}

}  // namespace tetproof::verify
