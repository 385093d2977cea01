// SPDX-License-Identifier: GPL-3.0-or-later
// The last paragraph of section 2: surface points are mapped onto a parametric surface (reading D12).
#pragma once

#include "reference/paper/section4.hpp"

namespace tetproof::reference::paper {

/// A face of the grid's boundary: the numbers of its points, and the points.
struct Face {
  std::array<int, 3> names;
  Triangle corners;
};

/// Whether two faces have more in common than the vertices whose numbers they share. Exact.
inline bool faces_meet(const Face& f, const Face& g) {
  if (apart(f.corners, g.corners)) return false;
  Triangle p = f.corners, q = g.corners;  // the common vertices are moved to the front of both
  std::array<int, 3> names = g.names;
  int common = 0;
  for (int i = 0; i < 3; ++i)
    if (const auto at = std::find(names.begin() + common, names.end(), f.names[i]); at != names.end()) {
      std::swap(p[common], p[i]);
      std::swap(q[common], q[at - names.begin()]);
      std::swap(names[common++], *at);
    }
  // With an edge in common, only if they are folded flat: on one side of it, as a point off the plane sees.
  if (common == 2) {
    int sides = 0;
    for (int x = 0; x < 3 && in_plane(q[2], p) && sides == 0; ++x) {
      Point off = p[0];
      off[x] += std::max(1.0, std::abs(off[x]));
      sides = orientation(p[0], p[1], p[2], off) * orientation(p[0], p[1], q[2], off);
    }
    return sides > 0;
  }
  // An edge of one meets the other; with a vertex in common, the edge opposite to it.
  for (int i = 0; i < 3; ++i)
    if (common != 1 || i == 1)
      if (common_part(p[i], p[(i + 1) % 3], q) || common_part(q[i], q[(i + 1) % 3], p)) return true;
  return common == 3;
}

class Parametric : public Improvement {
 public:
  using Improvement::Improvement;

  bool is_parametric() const { return options_.parametric && surface_.evaluate; }

  /// The point of the parametric surface for a point on or near the triangles: barycentric coordinates in the
  /// closest triangle (of several, the one whose sorted coordinates are smallest) give (u,v).
  Point on_parametric_surface(const Point& p) const {
    std::size_t closest = 0;
    double least = HUGE_VAL;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const double now = (closest_point(triangles_[t], p) - p).squaredNorm();
      if (now < least ||
          (now == least && lexicographically_less(sorted(triangles_[t]), sorted(triangles_[closest]))))
        least = now, closest = t;
    }
    const auto& [a, b, c] = triangles_[closest];
    const Point at = closest_point(triangles_[closest], p), normal = (b - a).cross(c - a);
    const double area = normal.squaredNorm();
    const double of_b = (at - a).cross(c - a).dot(normal) / area,
                 of_c = (b - a).cross(at - a).dot(normal) / area;
    const auto& [u_a, u_b, u_c] = surface_.parameters[closest];
    const Point mapped = surface_.evaluate((1 - of_b - of_c) * u_a + of_b * u_b + of_c * u_c);
    return mapped.allFinite() ? mapped : p;
  }

  std::vector<Face> boundary() const {
    std::vector<Face> faces;
    for (const auto& [p, tets] : shares_)
      if (p.size() == 3 && tets == 1)
        faces.push_back({{p[0], p[1], p[2]}, {points_[p[0]], points_[p[1]], points_[p[2]]}});
    return faces;
  }

  /// Moves the surface points of the first grid, one after the other.
  void map_grid() {
    for (const int p : surface_points_) {
      const Point from = points_[p], to = on_parametric_surface(from);
      if (to == from) continue;
      points_[p] = to;
      const auto has_p = [p](const auto& names) { return std::count(names.begin(), names.end(), p) > 0; };
      bool moves = std::all_of(tets_.begin(), tets_.end(), [&](const auto& tet) {
        return !has_p(tet.second.v) || positive(corners(tet.second.v));
      });
      const std::vector<Face> faces = boundary();
      for (const Face& f : faces)
        for (const Face& g : faces) moves = moves && !(has_p(f.names) && &f != &g && faces_meet(f, g));
      if (!moves) points_[p] = from;
      ++(moves ? mapped_ : not_mapped_);
      record(trace::Mapped{.from = from, .to = points_[p]});
    }
  }

  /// Whether the new point of a split would make the boundary meet itself.
  bool crosses_boundary(const Tet& v, const Split& split) const {
    std::vector<Face> stay, fresh;  // the other faces of the boundary; the parts of those that hold the point
    for (const Face& face : boundary()) {
      const auto is_replaced = [&](int p) {
        return std::any_of(split.replaced.begin(), split.replaced.end(), [&](int i) { return v[i] == p; });
      };
      const auto& names = face.names;
      const auto held = static_cast<std::size_t>(std::count_if(names.begin(), names.end(), is_replaced));
      const bool own =
          std::all_of(names.begin(), names.end(), [&](int p) { return std::count(v.begin(), v.end(), p); });
      if (!own || held != split.replaced.size()) stay.push_back(face);
      for (int i = 0; i < 3 && own && held == split.replaced.size(); ++i)
        if (is_replaced(names[i])) {
          fresh.push_back(face);
          fresh.back().names[i] = static_cast<int>(points_.size());
          fresh.back().corners[i] = split.point;
        }
    }
    for (const Face& f : fresh)
      for (const auto* others : {&stay, &fresh})
        for (const Face& g : *others)
          if (&f != &g && faces_meet(f, g)) return true;
    return false;
  }

  std::int64_t mapped_ = 0, not_mapped_ = 0;
};

}  // namespace tetproof::reference::paper
