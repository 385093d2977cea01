// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the distances between a mesh's boundary and a surface, and checks them.
#include <fmt/core.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>

#include "verify/checks/root_causes.hpp"
#include "verify/checks/surface_comparison.hpp"
#include "verify/checks/surface_names.hpp"
#include "verify/distance/directed_distance.hpp"
#include "verify/triangles/chunks.hpp"
#include "verify/triangles/on_triangle.hpp"

namespace tetproof::verify {
namespace {

using Point = Eigen::Vector3d;

bool exactly_on(const Point& p, const TriangleSet& set, Index triangle) {
  const Triangle& v = set.triangles[static_cast<std::size_t>(triangle)];
  const std::array<Point, 3> corners{set.points[v[0]], set.points[v[1]], set.points[v[2]]};
  return p == corners[0] || p == corners[1] || p == corners[2] || on_triangle(p, corners);
}

// The vertices that are farther from the surface than allowed, the farthest first.
void find_off_vertices(const Comparison& c, DistanceEvidence& evidence) {
  const std::vector<Point>& points = c.judged_mesh.mesh.points;
  const TriangleTree& tree = *c.surface_tree;
  std::vector<std::pair<Index, Index>> vertices;  // a vertex and one of its faces
  {
    std::vector<std::uint8_t> seen(points.size(), 0);
    for (std::size_t f = 0; f < c.faces.size(); ++f)
      for (const Index v : c.faces[f])
        if (!seen[v]) seen[v] = 1, vertices.emplace_back(v, static_cast<Index>(f));
  }
  std::sort(vertices.begin(), vertices.end());
  const double allowed = c.allowed / tree.units().scale;
  // Far from the surface all its triangles are nearly as far, and the nearest takes long to find. A
  // thousandth of the distance is close enough to put the vertices in order; those that the report names are
  // measured again.
  constexpr double share = 1e-3;
  const auto at_least = [&](double distance) { return (distance - distance_slack) * tree.units().scale; };
  // A vertex that is undecided is collected with a negative distance.
  std::vector<OffVertex> found = collect_in_order<OffVertex>(
      vertices.size(), 1024, [&](std::size_t begin, std::size_t end, std::vector<OffVertex>& off) {
        keep(c.judged_mesh.options.deadline);
        for (std::size_t i = begin; i < end; ++i) {
          const auto& [v, face] = vertices[i];
          const Point p = tree.units().to(points[static_cast<std::size_t>(v)]);
          const Index guess = evidence.nearest_triangle.empty() ? -1 : evidence.nearest_triangle[face];
          const double enough = std::max(0.0, allowed - distance_slack);
          if (guess >= 0 && tree.frame(guess).squared_distance(p) <= enough * enough) continue;
          TriangleTree::Nearest nearest = tree.nearest_within(p, allowed + distance_slack, guess);
          if (nearest.triangle < 0) {
            nearest = tree.nearest(p, guess, -1, share);
            off.push_back({v, at_least(std::sqrt(nearest.squared) * (1 - share)), nearest.triangle});
            continue;
          }
          const double distance = std::sqrt(nearest.squared);
          if (distance + distance_slack <= allowed) continue;
          if (distance < 2 * distance_slack &&
              exactly_on(points[static_cast<std::size_t>(v)], tree.set(), nearest.triangle))
            continue;
          off.push_back({v, distance - distance_slack > allowed ? at_least(distance) : -1, nearest.triangle});
        }
      });
  evidence.undecided_vertices =
      std::any_of(found.begin(), found.end(), [](const OffVertex& o) { return o.distance < 0; });
  std::erase_if(found, [](const OffVertex& o) { return o.distance < 0; });
  const auto farther = [](const OffVertex& a, const OffVertex& b) { return a.distance > b.distance; };
  std::stable_sort(found.begin(), found.end(), farther);
  const std::size_t first = std::min(found.size(), most_findings);
  tbb::parallel_for(std::size_t{0}, first, [&](std::size_t i) {
    OffVertex& o = found[i];
    const Point p = tree.units().to(points[static_cast<std::size_t>(o.vertex)]);
    const TriangleTree::Nearest nearest = tree.nearest(p, o.nearest);
    o.nearest = nearest.triangle;
    o.distance = std::max(o.distance, at_least(std::sqrt(nearest.squared)));
  });
  std::stable_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(first), farther);
  evidence.off_vertices = std::move(found);
}

void check_vertices(const Comparison& c, const DistanceEvidence& evidence, Record& record) {
  CheckResult& result = record.result(Check::off_surface_vertex);
  const std::vector<OffVertex>& off = evidence.off_vertices;
  result.allowed = c.allowed;
  if (!off.empty()) result.measured = off[0].distance;
  if (evidence.undecided_vertices) result.verdict = Verdict::undecided;
  record[Check::off_surface_vertex] = {
      .count = off.size(),
      .finding = [off](std::size_t i) { return Finding{.vertices = {off[i].vertex}}; },
      .describe =
          [off, &points = c.judged_mesh.mesh.points, allowed = c.allowed, &numbering = c.judged.numbering](
              std::size_t i, Finding& finding) {
            finding.point = points[static_cast<std::size_t>(off[i].vertex)];
            finding.what = fmt::format("the vertex is {:.6g} from the surface, allowed {:.6g}; nearest {}",
                                       off[i].distance, allowed, triangle_name(numbering, off[i].nearest));
          }};
}

// The first of these vertices that the face has.
std::optional<Cause> vertex_of(const Triangle& face, const std::vector<OffVertex>& off) {
  for (std::size_t i = 0; i < off.size(); ++i)
    if (std::count(face.begin(), face.end(), off[i].vertex)) return Cause{Check::off_surface_vertex, i};
  return std::nullopt;
}

// Compares an interval with the allowed distance. True if the distance is larger.
bool is_larger(const DirectedDistance& distance, double allowed, CheckResult& result) {
  result.measured = distance.lower;
  result.allowed = allowed;
  if (distance.lower > allowed) return true;
  if (distance.upper > allowed) result.verdict = Verdict::undecided;
  return false;
}

std::optional<Point> place_of(const DirectedDistance& distance) {
  if (distance.lower > 0 && distance.triangle >= 0) return distance.point;
  return std::nullopt;
}

// A distance that is too large: at a face of the boundary, to which one of these vertices may belong.
Suspects too_far(const Comparison& c, const DirectedDistance& distance, Index face, std::string what,
                 const std::vector<OffVertex>& off) {
  Finding finding = c.at_face(face);
  finding.point = distance.point;
  finding.what = std::move(what);
  Suspects suspects = Suspects::complete({std::move(finding)});
  suspects.cause = [cause = vertex_of(c.faces[face], off)](std::size_t) { return cause; };
  return suspects;
}

}  // namespace

Comparison::Comparison(const JudgedMesh& mesh, const JudgedSurface& judged_surface,
                       const std::vector<int>& own)
    : judged_mesh(mesh),
      surface(judged_surface.surface()),
      judged(judged_surface.judgement()),
      allowed(mesh.options.fidelity * (judged.report.box_max - judged.report.box_min).stableNorm()) {
  const std::span<const Triangle> boundary = mesh.boundary.boundary_triangles();
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const Index sheet = mesh.boundary.sheets.of_triangle[i];
    if (sheet >= 0 && own[sheet]) continue;
    if (mesh.unjudged.at(boundary[i])) {
      ++at_unjudged;
      continue;
    }
    faces.push_back(boundary[i]);
    ids.push_back(mesh.boundary.faces[i]);
    sheets.push_back(sheet);
  }
  const std::array<TriangleSet, 2> sets{TriangleSet{mesh.mesh.points, faces},
                                        TriangleSet{surface.vertices, surface.triangles}};
  const Units units = units_of(sets);
  if (!units.usable) return;
  tbb::parallel_invoke([&] { mesh_tree.emplace(sets[0], units); },
                       [&] { surface_tree.emplace(sets[1], units); });
}

DistanceEvidence measure_distances(const Comparison& c, Record& record) {
  const bool vertices = record.wants(Check::off_surface_vertex),
             to_mesh = record.wants(Check::surface_to_mesh);
  const bool to_surface = record.wants(Check::mesh_to_surface) || record.wants(Check::normals) || vertices;
  DistanceEvidence evidence;
  if (!to_surface && !to_mesh) return evidence;
  const Options& options = c.judged_mesh.options;
  DistanceQuestion question{
      .options = {.error = options.fidelity > 0 ? c.allowed / 10 : 1e-4 * c.mesh_tree->units().diagonal,
                  .relative = options.coarse || options.decide_only ? 0 : 0.2,
                  .most_pieces = 2'000'000 + 30 * static_cast<std::int64_t>(c.mesh_tree->size() +
                                                                            c.surface_tree->size())},
      .allowed = c.allowed,
      .only_decide = options.coarse || options.decide_only,
      .stop_if_larger = options.decide_only,
      .far_share = 1e-3,
      .nearest_within = c.allowed,
      .deadline = options.deadline};
  Fidelity& fidelity = record.report.fidelity.emplace();
  fidelity.allowed = c.allowed;
  if (to_surface && !c.faces.empty()) {
    question.nearest = &evidence.nearest_triangle;
    evidence.to_surface = directed_distance(*c.mesh_tree, *c.surface_tree, question);
    fidelity.mesh_to_surface = evidence.to_surface->lower;
    fidelity.mesh_to_surface_at = place_of(*evidence.to_surface);
    fidelity.error_bound = evidence.to_surface->upper - evidence.to_surface->lower;
  }
  if (vertices) find_off_vertices(c, evidence);
  if (to_mesh && !c.faces.empty()) {
    std::vector<Index> nearest_face;  // nobody reads it, but with it the interval is narrower
    question.nearest = &nearest_face;
    evidence.to_mesh = directed_distance(*c.surface_tree, *c.mesh_tree, question);
    fidelity.surface_to_mesh = evidence.to_mesh->lower;
    fidelity.surface_to_mesh_at = place_of(*evidence.to_mesh);
    fidelity.error_bound = std::max(fidelity.error_bound, evidence.to_mesh->upper - evidence.to_mesh->lower);
  }
  return evidence;
}

void check_distances(const Comparison& c, const DistanceEvidence& evidence, Record& record) {
  if (record.wants(Check::off_surface_vertex)) check_vertices(c, evidence, record);
  if (const auto& d = evidence.to_surface; d && record.wants(Check::mesh_to_surface) &&
                                           is_larger(*d, c.allowed, record.result(Check::mesh_to_surface)))
    record[Check::mesh_to_surface] =
        too_far(c, *d, d->triangle,
                fmt::format("the face is {:.6g} from the surface here, at most {:.6g} anywhere, allowed "
                            "{:.6g}; nearest {}",
                            d->lower, d->upper, c.allowed, triangle_name(c.judged.numbering, d->nearest)),
                evidence.off_vertices);
  if (!record.wants(Check::surface_to_mesh)) return;
  CheckResult& result = record.result(Check::surface_to_mesh);
  if (c.faces.empty()) {
    result.allowed = c.allowed;
    record[Check::surface_to_mesh] =
        Suspects::complete({{.what = "no face of the mesh's boundary is the surface's"}});
  } else if (const auto& d = evidence.to_mesh; is_larger(*d, c.allowed, result)) {
    record[Check::surface_to_mesh] =
        too_far(c, *d, d->nearest,
                fmt::format("the surface's {} is {:.6g} from the mesh's boundary here, at most "
                            "{:.6g} anywhere, allowed {:.6g}; the face is the nearest",
                            triangle_name(c.judged.numbering, d->triangle), d->lower, d->upper, c.allowed),
                evidence.off_vertices);
  }
}

}  // namespace tetproof::verify
