// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/shrink/editable_surface.hpp"

#include <algorithm>
#include <iterator>

#include "verify/triangles/intersections.hpp"
#include "verify/triangles/triangle_pairs.hpp"

namespace tetproof::corpus {
namespace {

using Triangle = std::array<Index, 3>;
constexpr Triangle gone_triangle{-1, -1, -1};

bool names(const Triangle& t, Index v) {
  return t[0] == v || t[1] == v || t[2] == v;
}

}  // namespace

TriangleSurface without_unused_vertices(const TriangleSurface& surface) {
  TriangleSurface result;
  std::vector<Index> number(surface.vertices.size(), -1);
  for (const Triangle& t : surface.triangles)
    for (const Index v : t) number[v] = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<Index>(result.vertices.size());
    result.vertices.push_back(surface.vertices[v]);
  }
  for (const auto& [a, b, c] : surface.triangles)
    result.triangles.push_back({number[a], number[b], number[c]});
  return result;
}

EditableSurface::EditableSurface(const TriangleSurface& surface)
    : vertices_(surface.vertices), triangles_(surface.triangles), at_(surface.vertices.size()) {
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (const Index v : triangles_[t]) at_[v].push_back(static_cast<Index>(t));
}

std::vector<std::array<Index, 2>> EditableSurface::edges() const {
  std::vector<std::array<Index, 2>> edges;
  for (const Triangle& t : triangles_)
    for (int c = 0; c < 3; ++c)
      if (t[c] < t[(c + 1) % 3]) edges.push_back({t[c], t[(c + 1) % 3]});
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<Index> EditableSurface::neighbours(Index v) const {
  std::vector<Index> result;
  for (const Index n : at_[v]) {
    const Triangle& t = triangles_[n];
    const int c = t[0] == v ? 0 : t[1] == v ? 1 : 2;
    result.push_back(t[(c + 1) % 3]);  // each neighbour is next in one triangle of the closed fan
  }
  std::sort(result.begin(), result.end());
  return result;
}

// The links of u and v have in common the link of the edge uv, and nothing else.
bool EditableSurface::link_condition(Index u, Index v) const {
  const std::vector<Index> of_u = neighbours(u), of_v = neighbours(v);
  if (!std::binary_search(of_u.begin(), of_u.end(), v)) return false;
  std::vector<Index> common;
  std::set_intersection(of_u.begin(), of_u.end(), of_v.begin(), of_v.end(), std::back_inserter(common));
  if (common.size() != 2) return false;
  const auto has = [&](Index w) {
    return std::any_of(at_[w].begin(), at_[w].end(), [&](Index t) {
      return names(triangles_[t], common[0]) && names(triangles_[t], common[1]);
    });
  };
  return !(has(u) && has(v));  // both: a tetrahedron
}

bool EditableSurface::embedded_after(const Collapse& collapse) const {
  const auto& [u, v, place] = collapse;
  std::vector<Eigen::Vector3d> points = vertices_;
  points[v] = place;
  std::vector<Triangle> changed;
  for (const Index w : {u, v})
    for (const Index n : at_[w]) {
      Triangle t = triangles_[n];
      if (names(t, u) && names(t, v)) continue;
      std::replace(t.begin(), t.end(), u, v);
      changed.push_back(t);
    }
  if (verify::degenerate_triangles(points, changed).count > 0) return false;
  Eigen::Vector3d low = points[v], high = points[v];
  for (const Triangle& t : changed)
    for (const Index w : t) low = low.cwiseMin(points[w]), high = high.cwiseMax(points[w]);
  // The other triangles did not meet each other before; so only those matter that come near the new ones.
  for (const Triangle& t : triangles_) {
    if (t == gone_triangle || names(t, u) || names(t, v)) continue;
    const Eigen::Vector3d &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    if ((a.cwiseMin(b).cwiseMin(c).array() <= high.array()).all() &&
        (a.cwiseMax(b).cwiseMax(c).array() >= low.array()).all())
      changed.push_back(t);
  }
  return verify::self_intersections(points, changed, {}, 1).count == 0;
}

bool EditableSurface::allows(const Collapse& collapse) const {
  return link_condition(collapse.gone, collapse.stays) && embedded_after(collapse);
}

void EditableSurface::apply(const Collapse& collapse) {
  const auto& [u, v, place] = collapse;
  vertices_[v] = place;
  for (const Index n : at_[u]) {
    Triangle& t = triangles_[n];
    if (!names(t, v)) {
      std::replace(t.begin(), t.end(), u, v);
      at_[v].push_back(n);
      continue;
    }
    for (const Index w : t)
      if (w != u) std::erase(at_[w], n);
    t = gone_triangle;
  }
  at_[u].clear();
}

TriangleSurface EditableSurface::surface() const {
  TriangleSurface all;
  all.vertices = vertices_;
  for (const Triangle& t : triangles_)
    if (t != gone_triangle) all.triangles.push_back(t);
  return without_unused_vertices(all);
}

}  // namespace tetproof::corpus
