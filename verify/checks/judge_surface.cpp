// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/surface.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <utility>

#include "io/bytes/words.hpp"
#include "verify/checks/surface_judgement.hpp"
#include "verify/checks/surface_names.hpp"
#include "verify/mesh/volumes.hpp"
#include "verify/triangles/edges.hpp"
#include "verify/triangles/intersections.hpp"
#include "verify/triangles/winding.hpp"

namespace tetproof::verify {
namespace {

std::string plural(std::integral auto n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

// A surface and its file's numbers.
struct Named {
  const TriangleSurface& surface;
  const SurfaceNumbering& numbering;

  std::string triangle(Index t) const { return triangle_place(surface, numbering, t); }
  // "17-243 from (0, 0, 0) to (0, 1, 0)"
  std::string edge(Side s) const {
    const Index a = std::min(from(surface.triangles, s), to(surface.triangles, s)),
                b = std::max(from(surface.triangles, s), to(surface.triangles, s));
    const std::string numbers =
        numbering.numbers_vertices ? fmt::format("{}-{} ", numbering.vertex(a), numbering.vertex(b)) : "";
    return fmt::format("{}from {} to {}", numbers, place_name(surface.vertices[a]),
                       place_name(surface.vertices[b]));
  }
};

std::string fault_of_numbers(const Named& named) {
  const TriangleSurface& surface = named.surface;
  const auto vertices = static_cast<Index>(surface.vertices.size());
  if (surface.triangles.empty()) return "the surface has no triangles";
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const Index v : surface.triangles[t]) {
      const bool exists = v >= 0 && v < vertices;
      if (exists && surface.vertices[v].allFinite()) continue;
      const std::string triangle = triangle_name(named.numbering, static_cast<Index>(t));
      if (!exists) return fmt::format("{} names vertex {}, expected one of 0..{}", triangle, v, vertices - 1);
      return fmt::format(
          "{} of {} is not finite: {}",
          named.numbering.numbers_vertices ? fmt::format("vertex {}", named.numbering.vertex(v)) : "a corner",
          triangle, place_name(surface.vertices[v]));
    }
  return "";
}

std::string fault_of_connections(const Named& named, const EdgeMatching& edges, const Sheets& sheets) {
  if (!edges.open.empty())
    return fmt::format("the surface is open: {} one triangle (first: {}, of {})",
                       plural(edges.open.size(), "edge has", "edges have"), named.edge(edges.open.front()),
                       triangle_name(named.numbering, edges.open.front() / 3));
  if (!edges.nonmanifold.empty())
    return fmt::format("the surface is not manifold: {} more than two triangles (first: {} has {})",
                       plural(edges.nonmanifold.size(), "edge has", "edges have"),
                       named.edge(edges.nonmanifold.front().front()), edges.nonmanifold.front().size());
  if (const std::vector<Index> vertices = repeated(sheets.vertices_of_fans); !vertices.empty())
    return fmt::format(
        "the surface is not manifold: {} more than one fan of triangles (first: {}at {})",
        plural(vertices.size(), "vertex has", "vertices have"),
        named.numbering.numbers_vertices ? fmt::format("{} ", named.numbering.vertex(vertices.front())) : "",
        place_name(named.surface.vertices[vertices.front()]));
  if (!edges.same_direction.empty()) {
    const auto& sides = edges.same_direction.front();
    return fmt::format(
        "the surface is not consistently oriented: {} run twice in the same direction (first: {}, by {} and "
        "{})",
        plural(edges.same_direction.size(), "edge is", "edges are"), named.edge(sides[0]),
        triangle_name(named.numbering, sides[0] / 3), triangle_name(named.numbering, sides[1] / 3));
  }
  return "";
}

std::string fault_of_triangles(const Named& named, const Degenerate& degenerate, const EdgeMatching& edges) {
  const TriangleSurface& surface = named.surface;
  if (degenerate.count > 0) {
    const auto first =
        std::find(degenerate.triangles.begin(), degenerate.triangles.end(), 1) - degenerate.triangles.begin();
    return fmt::format("{} no area (first: {})", plural(degenerate.count, "triangle has", "triangles have"),
                       named.triangle(static_cast<Index>(first)));
  }
  std::int64_t twice = 0;
  Index first = -1;
  for (Index t = 0; t < static_cast<Index>(surface.triangles.size()); ++t) {
    const Index other = edges.mate[3 * t] / 3;
    if (other < t || edges.mate[3 * t + 1] / 3 != other || edges.mate[3 * t + 2] / 3 != other) continue;
    if (twice++ == 0) first = t;
  }
  if (twice > 0)
    return fmt::format("{} twice (first: {} and {})",
                       plural(twice, "triangle is listed", "triangles are listed"), named.triangle(first),
                       triangle_name(named.numbering, edges.mate[3 * first] / 3));
  const Intersections meetings = self_intersections(surface.vertices, surface.triangles, {}, 1);
  if (meetings.count > 0)
    return fmt::format("the surface intersects itself: {}{} (first: {} and {})",
                       meetings.more ? "more than " : "",
                       plural(meetings.count, "pair of triangles meets", "pairs of triangles meet"),
                       named.triangle(meetings.pairs[0][0]), named.triangle(meetings.pairs[0][1]));
  return "";
}

std::string component_name(const Named& named, const SurfaceReport& report, std::size_t i) {
  const SurfaceComponent& c = report.components[i];
  return fmt::format("component {} ({} from {}, volume {:.6g})", i, io::counted(c.triangles, "triangles"),
                     named.triangle(c.first_triangle), c.volume);
}

// Judges the components: their volumes and depths, and whether their orientations agree on what is inside.
void judge_components(const TriangleSurface& surface, const Sheets& sheets, SurfaceJudgement& judgement) {
  SurfaceReport& report = judgement.report;
  const Named named{surface, judgement.numbering};
  const std::size_t n = sheets.sheets.size();
  judgement.component_of = sheets.of_triangle;
  const ExactVolumes& volumes =
      judgement.volumes.emplace(surface.vertices, surface.triangles, sheets.of_triangle, n);
  std::vector<int> depths(n, 0);
  if (n > 1) depths = nesting_depths(surface.vertices, surface.triangles, sheets);
  std::vector<int>& weights = judgement.weights;
  weights.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    weights[i] = depths[i] % 2 == 0 ? volumes.sign(i) : -volumes.sign(i);
    report.components.push_back({.triangles = sheets.sheets[i].triangles,
                                 .vertices = sheets.sheets[i].vertices,
                                 .first_triangle = sheets.sheets[i].first_triangle,
                                 .outward = volumes.sign(i) > 0,
                                 .depth = depths[i],
                                 .genus = sheets.sheets[i].genus(),
                                 .volume = volumes.volume(i)});
    report.genus += sheets.sheets[i].genus();
  }
  report.volume = volumes.weighted_sum(weights);

  std::array<std::vector<std::size_t>, 2> outward, inward;  // for even and for odd depths
  for (std::size_t i = 0; i < n; ++i)
    (report.components[i].outward ? outward : inward)[depths[i] % 2].push_back(i);
  for (const int parity : {0, 1}) {
    if (outward[parity].empty() || inward[parity].empty()) continue;
    const auto more = [](std::size_t count) {
      return count > 1 ? fmt::format(" and {} more", count - 1) : "";
    };
    report.fault = fmt::format("the surface is not consistently oriented: {}{} inward, but {}{} outward, {}",
                               component_name(named, report, inward[parity][0]),
                               more(inward[parity].size()) + (inward[parity].size() > 1 ? " are" : " is"),
                               component_name(named, report, outward[parity][0]),
                               more(outward[parity].size()) + (outward[parity].size() > 1 ? " are" : " is"),
                               parity == 0 ? "none of them in a cavity" : "all of them inside others");
    return;
  }
  if (!inward[0].empty())
    report.notes.push_back(
        "the surface is oriented inward; parity decides what is inside, so this changes nothing");
  if (const auto& nested = inward[0].empty() ? outward[1] : inward[1]; !nested.empty())
    report.notes.push_back(
        fmt::format("{} lies inside another and is oriented like it; parity decides what is inside, so it "
                    "bounds a cavity",
                    component_name(named, report, nested[0])));
}

// The area in squares of `unit`, a power of two. Where the triangles are not far smaller than the unit, no
// product under- or overflows.
double area_of(const TriangleSurface& surface, double unit) {
  double sum = 0;
  for (const Triangle& t : surface.triangles) {
    const Eigen::Vector3d a = surface.vertices[t[0]] / unit, b = surface.vertices[t[1]] / unit,
                          c = surface.vertices[t[2]] / unit;
    sum += (b - a).cross(c - a).norm() / 2;
  }
  return sum;
}

// The power of two below the longest side of the box; 1 for a box without extent.
int exponent_of(const SurfaceReport& report) {
  const double side = (report.box_max / 2 - report.box_min / 2).maxCoeff();
  return side > 0 ? std::min(std::ilogb(side) + 1, 1023) : 0;
}

}  // namespace

std::int64_t SurfaceReport::cavities() const {
  return std::count_if(components.begin(), components.end(),
                       [](const SurfaceComponent& c) { return c.depth % 2 == 1; });
}

SurfaceReport judge_surface(const TriangleSurface& surface, SurfaceNumbering numbering) {
  return judge(surface, std::move(numbering)).report;
}

JudgedSurface::JudgedSurface(const TriangleSurface& surface, SurfaceNumbering numbering)
    : surface_(&surface),
      judgement_(std::make_shared<SurfaceJudgement>(judge(surface, std::move(numbering)))) {}

const SurfaceReport& JudgedSurface::report() const {
  return judgement_->report;
}

SurfaceJudgement judge(const TriangleSurface& surface, SurfaceNumbering numbering) {
  SurfaceJudgement judgement;
  judgement.numbering = std::move(numbering);
  const Named named{surface, judgement.numbering};
  SurfaceReport& report = judgement.report;
  report.vertices = static_cast<std::int64_t>(surface.vertices.size());
  report.triangles = static_cast<std::int64_t>(surface.triangles.size());
  report.fault = fault_of_numbers(named);
  if (!report.fault.empty()) return judgement;

  report.box_min = report.box_max = surface.vertices[surface.triangles[0][0]];
  for (const Triangle& t : surface.triangles)
    for (const Index v : t) {
      report.box_min = report.box_min.cwiseMin(surface.vertices[v]);
      report.box_max = report.box_max.cwiseMax(surface.vertices[v]);
    }
  judgement.exponent = exponent_of(report);
  judgement.area = area_of(surface, std::ldexp(1.0, judgement.exponent));
  report.area = std::ldexp(judgement.area, 2 * judgement.exponent);

  // A triangle that names a vertex twice has no sides to match. The others are tested for closedness without
  // it.
  std::vector<std::uint8_t> excluded;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    if (a != b && b != c && c != a) continue;
    if (excluded.empty()) excluded.assign(surface.triangles.size(), 0);
    excluded[t] = 1;
  }
  const EdgeMatching edges = match_edges(surface.triangles, surface.vertices.size(), excluded);
  const Sheets sheets = find_sheets(surface.triangles, edges.mate, excluded);
  report.fault = fault_of_connections(named, edges, sheets);
  if (report.fault.empty())
    report.fault =
        fault_of_triangles(named, degenerate_triangles(surface.vertices, surface.triangles), edges);
  if (report.fault.empty()) judge_components(surface, sheets, judgement);
  return judgement;
}

}  // namespace tetproof::verify
