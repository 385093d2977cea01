// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/surface.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "verify/edges.hpp"

namespace tetproof::verify {
namespace {

std::string plural(std::int64_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string edge_name(std::span<const Triangle> triangles, Side s) {
  return fmt::format("{}-{}", std::min(from(triangles, s), to(triangles, s)),
                     std::max(from(triangles, s), to(triangles, s)));
}

std::string fault_of_numbers(const TriangleSurface& surface) {
  const auto vertices = static_cast<Index>(surface.vertices.size());
  if (surface.triangles.empty()) return "the surface has no triangles";
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const Index v : surface.triangles[t]) {
      if (v < 0 || v >= vertices)
        return fmt::format("triangle {} names vertex {}, expected one of 0..{}", t, v, vertices - 1);
      if (!surface.vertices[v].allFinite())
        return fmt::format("vertex {} of triangle {} is not finite: ({}, {}, {})", v, t,
                           surface.vertices[v].x(), surface.vertices[v].y(), surface.vertices[v].z());
    }
  return "";
}

std::string fault_of_edges(const TriangleSurface& surface, const EdgeMatching& edges) {
  const std::span<const Triangle> triangles = surface.triangles;
  if (!edges.open.empty())
    return fmt::format("the surface is open: {} one triangle (first: {})",
                       plural(static_cast<std::int64_t>(edges.open.size()), "edge has", "edges have"),
                       edge_name(triangles, edges.open.front()));
  if (!edges.nonmanifold.empty())
    return fmt::format("the surface is not manifold: {} more than two triangles (first: {} has {})",
                       plural(static_cast<std::int64_t>(edges.nonmanifold.size()), "edge has", "edges have"),
                       edge_name(triangles, edges.nonmanifold.front().front()),
                       edges.nonmanifold.front().size());
  return "";
}

}  // namespace

std::int64_t SurfaceReport::cavities() const {
  return std::count_if(components.begin(), components.end(),
                       [](const SurfaceComponent& c) { return c.depth % 2 == 1; });
}

SurfaceReport judge_surface(const TriangleSurface& surface) {
  SurfaceReport report;
  report.vertices = static_cast<std::int64_t>(surface.vertices.size());
  report.triangles = static_cast<std::int64_t>(surface.triangles.size());
  report.fault = fault_of_numbers(surface);
  if (!report.fault.empty()) return report;
  const EdgeMatching edges = match_edges(surface.triangles, surface.vertices.size());
  report.fault = fault_of_edges(surface, edges);
  if (!report.fault.empty()) return report;
  const Sheets sheets = find_sheets(surface.triangles, edges.mate);
  for (const Sheet& sheet : sheets.sheets)
    report.components.push_back({.triangles = sheet.triangles,
                                 .vertices = sheet.vertices,
                                 .first_triangle = sheet.first_triangle,
                                 .genus = sheet.genus()});
  return report;
}

}  // namespace tetproof::verify
