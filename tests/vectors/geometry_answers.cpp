// SPDX-License-Identifier: GPL-3.0-or-later
// Answers to the vectors about geometry: lattice, indicators, points of edges, closest points, quality,
// flips.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "answers.hpp"
#include "reference/engine/adaptation/improve.hpp"
#include "reference/engine/first_grid/lattice.hpp"
#include "reference/paper/page.hpp"

namespace tetproof::test {
namespace {

using Json = nlohmann::json;
using namespace reference;
using paper::lexicographically_less;
using paper::Point;
using paper::Rational;
using paper::Triangle;

Point point(const Json& p) {
  return {p[0].get<double>(), p[1].get<double>(), p[2].get<double>()};
}
Json json(const Point& p) {
  return {p.x(), p.y(), p.z()};
}
std::vector<Point> points(const Json& list) {
  std::vector<Point> all;
  for (const Json& p : list) all.push_back(point(p));
  return all;
}
TriangleSurface surface_of(const Json& input) {
  TriangleSurface surface;
  surface.vertices = points(input["vertices"]);
  surface.triangles = input["triangles"].get<std::vector<std::array<Index, 3>>>();
  return surface;
}

// --- eq. (2.1)

constexpr int least_cells = 4;  // that every side gets at least (reading D1): for mistakes made on purpose

Json lattice(const Json& input, const std::string& mistake) {
  TriangleSurface surface = surface_of(input);
  if (mistake == "stray-counts") {  // `make_lattice` asks the triangles only
    const auto vertices = static_cast<Index>(surface.vertices.size());
    for (Index v = 0; v < vertices; ++v) surface.triangles.push_back({v, v, v});
  }
  std::array<int, 3> cells{};
  for (std::size_t k = 0; k < input["cells"].size(); ++k) cells[k] = input["cells"][k];
  const double scale = input["box_scale"];
  if (cells[1] == 0 && (mistake == "cells-cut-off" || mistake == "half-even")) {
    Point low = surface.vertices[surface.triangles[0][0]], high = low;
    for (const auto& triangle : surface.triangles)
      for (const Index v : triangle)
        low = low.cwiseMin(surface.vertices[v]), high = high.cwiseMax(surface.vertices[v]);
    const double wanted = cells[0], longest = (high - low).maxCoeff();
    for (int x = 0; x < 3; ++x) {
      const double number = wanted * (high - low)[x] / longest;
      const double cut = mistake == "half-even" ? std::nearbyint(number) : std::floor(number);
      cells[x] = std::max(std::min(least_cells, static_cast<int>(wanted)), static_cast<int>(cut));
    }
  }
  Lattice made = make_lattice(surface, cells, scale);
  if (mistake == "about-origin")
    for (auto& planes : made.planes) {
      const double shift = (planes.front() + planes.back()) / 2 * (scale - 1);
      for (double& x : planes) x += shift;
    }
  const auto [nx, ny, nz] = made.cells;
  Json at = Json::array();
  for (const Json& v : input["at"]) {
    // A mistake may have made too few cells for this point.
    const bool there = v[0] <= nx && v[1] <= ny && v[2] <= nz;
    at.push_back(there ? json(made.point(v[0], v[1], v[2])) : Json());
  }
  return {{"cells", made.cells},
          {"box", {json(made.point(0, 0, 0)), json(made.point(nx, ny, nz))}},
          {"points", at}};
}

// --- exact indicators

Rational dot(const paper::ExactPoint& a, const paper::ExactPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
paper::ExactPoint difference(const Point& a, const Point& b) {
  const paper::ExactPoint p = paper::exact(a), q = paper::exact(b);
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
paper::ExactPoint cross(const paper::ExactPoint& a, const paper::ExactPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Whether p lies within the triangle, not on one of its edges.
bool strictly_on(const Triangle& t, const Point& p) {
  if (!paper::in_plane(p, t)) return false;
  const paper::ExactPoint normal = cross(difference(t[1], t[0]), difference(t[2], t[0]));
  for (int i = 0; i < 3; ++i)
    if (dot(cross(difference(t[(i + 1) % 3], t[i]), difference(p, t[i])), normal) <= 0) return false;
  return true;
}

// Whether the line along x meets the closed triangle before it comes to p: without the rule of reading D4.
bool line_meets(const Triangle& t, const Point& p) {
  const auto turn = [](const Point& a, const Point& b, const Point& c) {
    return paper::orientation({0, a.y(), a.z()}, {0, b.y(), b.z()}, {0, c.y(), c.z()}, {1, 0, 0});
  };
  const int facing = turn(t[0], t[1], t[2]);
  for (int i = 0; i < 3; ++i)
    if (facing == 0 || turn(t[i], t[(i + 1) % 3], p) * facing < 0) return false;
  return facing * paper::orientation(t[0], t[1], t[2], p) > 0;
}

Json indicators(const Json& input, const std::string& mistake) {
  const TriangleSurface surface = surface_of(input);
  const paper::Section2 page(surface, {});
  const auto& triangles = page.triangles_;
  const int sign = input["region"] == "inside" || mistake == "same-signs" ? 1 : -1;
  Json found = Json::array();
  for (const Point& p : points(input["points"])) {
    bool on = page.is_on_surface(p), inside = page.is_inside(p);
    if (mistake == "open-triangles")
      on = std::any_of(triangles.begin(), triangles.end(),
                       [&](const Triangle& t) { return strictly_on(t, p); });
    if (mistake == "tolerance") on = (page.closest_on_surface(p) - p).norm() < 1e-9;
    if (mistake == "counts-twice")
      inside = std::count_if(triangles.begin(), triangles.end(),
                             [&](const Triangle& t) { return line_meets(t, p); }) %
                   2 ==
               1;
    found.push_back(on ? 0 : inside ? sign : -sign);
  }
  return {{"indicators", found}};
}

// --- the points of an edge

Json edge_points(const Json& input, const std::string& mistake) {
  const TriangleSurface surface = surface_of(input);
  const paper::Section2 page(surface, {});
  const Point p = point(input["edge"][0]), q = point(input["edge"][1]);
  paper::EdgePoints met = page.intersect(p, q);
  Json at = Json::array();
  std::vector<Rational> where = met.inner;
  const bool each = mistake == "triangles-not-points";
  if (each || mistake == "no-union" || mistake == "ends-count") {
    std::set<Rational> different;
    if (each || mistake == "ends-count") where.clear();
    for (const auto& [part, triangle] : met.parts)
      for (const Rational& s : std::set<Rational>{part.first, part.second}) {
        if (s > 0 && s < 1 && each) where.push_back(s);
        if (s > 0 && s < 1 && mistake == "no-union") different.insert(s);
        if ((s == 0 || s == 1) && mistake == "ends-count") different.insert(s);
      }
    if (mistake == "ends-count") different.insert(met.inner.begin(), met.inner.end());
    if (!each) where.assign(different.begin(), different.end());
  }
  for (const Rational& s : where)
    at.push_back(
        json(mistake.empty() ? page.place_of_cut(p, q, met, s) : p + s.convert_to<double>() * (q - p)));
  return {{"count", where.size()}, {"points", at}};
}

// --- closest points

Json closest_point(const Json& input, const std::string& mistake) {
  const TriangleSurface surface = surface_of(input);
  const paper::Section2 page(surface, {});
  const Point p = point(input["point"]);
  Point found = page.closest_on_surface(p);
  std::vector<Point> others;
  if (mistake == "nearest-vertex") others = surface.vertices;
  for (const Triangle& t : page.triangles_) {
    const Point normal = (t[1] - t[0]).cross(t[2] - t[0]);
    if (mistake == "foot-in-plane")
      others.push_back(p - normal * (normal.dot(p - t[0]) / normal.squaredNorm()));
    if (mistake == "last-of-ties") others.push_back(paper::closest_point(t, p));
  }
  for (const Point& other : others) {
    const double now = (other - p).norm(), before = (found - p).norm();
    const bool tied = std::abs(now - before) <= 1e-12 * before;
    const bool first = &other == &others.front() && mistake != "last-of-ties";
    const bool later = mistake == "last-of-ties" && lexicographically_less(found, other);
    if (first ||
        (tied ? later || (mistake != "last-of-ties" && lexicographically_less(other, found)) : now < before))
      found = other;
  }
  return {{"point", json(found)}, {"distance", (found - p).norm()}};
}

// --- section 4

// tan(Omega/2) at the first vertex.
double first_solid_angle(const std::array<Point, 4>& t) {
  const Point a = t[1] - t[0], b = t[2] - t[0], c = t[3] - t[0];
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return std::abs(a.cross(b).dot(c)) / (la * lb * lc + a.dot(b) * lc + a.dot(c) * lb + b.dot(c) * la);
}

Json quality(const Json& input, const std::string& mistake) {
  std::array<Point, 4> t;
  for (int k = 0; k < 4; ++k) t[k] = point(input["points"][k]);
  const double tangent = mistake == "first-angle" ? first_solid_angle(t) : smallest_solid_angle(t);
  double ratio = aspect_ratio(t), plain = dimensionless_aspect_ratio(t);
  if (mistake == "smallest-face") {
    double area = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 4; ++k)
      area = std::min(area, (t[(k + 1) % 4] - t[k]).cross(t[(k + 2) % 4] - t[k]).norm() / 2);
    const double height = std::abs((t[1] - t[0]).cross(t[2] - t[0]).dot(t[3] - t[0])) / 2 / area;
    ratio = height / area, plain = height / std::sqrt(area);
  }
  return {{"tangent", tangent},
          {"solid_angle", solid_angle_of(tangent)},
          {"d_over_a", ratio},
          {"d_over_sqrt_a", plain}};
}

std::optional<Flip> mistaken_flip(const std::vector<Flip>& possible, const std::string& mistake) {
  std::optional<Flip> best;
  for (const Flip& flip : possible) {
    if (mistake == "quality-not-gain" && !(flip.gain() > 0)) continue;
    const auto value = [&](const Flip& f) { return mistake == "quality-not-gain" ? f.after : f.gain(); };
    if (!best || value(flip) > value(*best) ||
        (value(flip) == value(*best) && flip.vertices() < best->vertices()))
      best = flip;
  }
  return best;
}

Json flips(const Json& input, const std::string& mistake) {
  const std::vector<std::array<Index, 4>> tets = input["tetrahedra"];
  const std::vector<Point> at = points(input["points"]);
  const Triangulation grid({.points = at, .tets = tets}, std::vector<std::uint8_t>(at.size(), 0));
  std::vector<Index> set = input["set"];
  const bool angles = input["criterion"] == "solid-angle";
  const Criterion criterion = angles ? Criterion::solid_angle : Criterion::aspect_ratio,
                  other = angles ? Criterion::aspect_ratio : Criterion::solid_angle;
  if (mistake == "whole-grid")
    for (Index t = 0; t < static_cast<Index>(tets.size()); ++t)
      if (std::find(set.begin(), set.end(), t) == set.end()) set.push_back(t);
  std::optional<Flip> flip = best_flip(grid, set, criterion);
  if (mistake == "any-gain" || mistake == "quality-not-gain")
    flip = mistaken_flip(possible_flips(grid, set, criterion), mistake);
  if (mistake == "other-criterion") {
    const auto wrong = best_flip(grid, set, other);
    flip.reset();
    for (const Flip& same : possible_flips(grid, set, criterion))  // with the qualities that are asked for
      if (wrong && same.old == wrong->old) flip = same;
  }
  if (!flip) return {{"flip", nullptr}, {"tetrahedra", Json::array()}};
  const auto shown = [&](double q) { return angles ? solid_angle_of(q) : q; };
  return {{"flip",
           {{"kind", flip->two_to_three() ? "2-3" : "3-2"},
            {"face", flip->face},
            {"edge", flip->edge},
            {"quality", {shown(flip->before), shown(flip->after)}}}},
          {"tetrahedra", flip->fresh}};
}

}  // namespace

Json geometry_answer(const std::string& kind, const Json& input, const std::string& mistake) {
  if (kind == "lattice") return lattice(input, mistake);
  if (kind == "indicators") return indicators(input, mistake);
  if (kind == "edge_points") return edge_points(input, mistake);
  if (kind == "closest_point") return closest_point(input, mistake);
  if (kind == "quality") return quality(input, mistake);
  if (kind == "flips") return flips(input, mistake);
  throw std::logic_error("unknown kind " + kind);
}

}  // namespace tetproof::test
