// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/solid_boundary.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "io/surface/constrained.hpp"
#include "io/surface/crossed_triangles.hpp"

namespace tetproof::io {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<Index, 3>;

// Sides of triangles, and which of them are in one cell. Side 2 t is the front of triangle t, 2 t + 1 its
// back.
class Sides {
 public:
  explicit Sides(std::size_t triangles) : parent_(2 * triangles) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::size_t cell(std::size_t side) {
    while (parent_[side] != side) side = parent_[side] = parent_[parent_[side]];
    return side;
  }
  void join(std::size_t a, std::size_t b) { parent_[cell(a)] = cell(b); }

 private:
  std::vector<std::size_t> parent_;
};

class Cells {
 public:
  Cells(const std::vector<Vector3d>& points, const std::vector<Triangle>& triangles)
      : points_(points), triangles_(triangles), sides_(triangles.size()), parts_(triangles.size()) {
    Vector3d low = p(triangles_[0][0]), high = low;
    for (const Triangle& t : triangles_)
      for (const Index i : t) low = low.cwiseMin(p(i)), high = high.cwiseMax(p(i));
    middle_ = low / 2 + high / 2;
    size_ = (high - low).stableNorm();
  }

  std::optional<SolidBoundary> boundary(std::span<const Vector3d> holes) {
    for (const Triangle& t : triangles_)
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] || on_a_line(p(t[0]), p(t[1]), p(t[2]))) return {};
    tree_.emplace(points_, triangles_);
    join_around_edges();
    if (!join_parts()) return {};
    std::vector<std::size_t> empty{outermost_};
    for (const Vector3d& hole : holes)
      if (const std::optional<std::size_t> side = side_around(hole)) empty.push_back(*side);
    return separate(empty);
  }

 private:
  // A triangle at an edge: where its third corner is, and whether it runs along the edge or against it.
  struct Wing {
    std::size_t triangle;
    Index tip;
    bool along;
    std::size_t facing_on() const { return 2 * triangle + (along ? 0 : 1); }    // to larger angles
    std::size_t facing_back() const { return 2 * triangle + (along ? 1 : 0); }  // to smaller ones
  };
  // A triangle that a segment crosses.
  struct Hit {
    double at;
    std::size_t near_side, far_side;
  };

  const Vector3d& p(Index i) const { return points_[static_cast<std::size_t>(i)]; }

  void join_around_edges();
  bool join_parts();
  std::optional<std::size_t> side_around(const Vector3d& place) const;
  bool hits(const Vector3d& from, const Vector3d& to, std::vector<Hit>& all) const;
  Vector3d far_point(int attempt) const;
  std::optional<SolidBoundary> separate(const std::vector<std::size_t>& empty);

  const std::vector<Vector3d>& points_;
  const std::vector<Triangle>& triangles_;
  Sides sides_;
  Sides parts_;                // by triangle, those that are connected by edges; the odd positions are unused
  std::size_t outermost_ = 0;  // a side
  Vector3d middle_;            // of the box around all
  double size_ = 0;            // the diagonal of that box
  std::optional<CrossedTriangles> tree_;
};

// Two triangles that follow each other around an edge have a cell between them.
void Cells::join_around_edges() {
  std::map<std::array<Index, 2>, std::vector<Wing>> edges;
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
      edges[{std::min(a, b), std::max(a, b)}].push_back({t, triangles_[t][(k + 2) % 3], a < b});
    }
  for (auto& [ends, wings] : edges) {
    const Vector3d &a = p(ends[0]), &b = p(ends[1]), &first = p(wings[0].tip);
    const auto quarter =
        [&](const Wing& wing) {  // 0: at the first, 1: less than half a turn on, 2: half, 3: more
          const int side = side_of_plane(a, b, first, p(wing.tip));
          return side > 0 ? 1 : side < 0 ? 3 : same_side_of_line(a, b, first, p(wing.tip)) ? 0 : 2;
        };
    std::vector<std::pair<int, Wing>> sorted;
    for (const Wing& wing : wings) sorted.emplace_back(quarter(wing), wing);
    std::stable_sort(sorted.begin(), sorted.end(), [&](const auto& one, const auto& other) {
      if (one.first != other.first) return one.first < other.first;
      return one.first % 2 == 1 && side_of_plane(a, b, p(one.second.tip), p(other.second.tip)) > 0;
    });
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const Wing &here = sorted[i].second, &next = sorted[(i + 1) % sorted.size()].second;
      sides_.join(here.facing_on(), next.facing_back());
      parts_.join(2 * here.triangle, 2 * next.triangle);
    }
  }
}

// A point outside of all, in directions that no plane of a usual model has.
Vector3d Cells::far_point(int attempt) const {
  const double turn = 0.7 + 1.3 * attempt;
  return middle_ + 3 * size_ *
                       Vector3d(std::floor(1024 * std::cos(turn)) / 1024 + 0.011,
                                std::floor(1024 * std::sin(turn)) / 1024 + 0.013, 0.517 + 0.031 * attempt);
}

// The triangles that the segment crosses, in order. False: it meets an edge or a vertex, or two of them so
// close that their order is not sure.
bool Cells::hits(const Vector3d& from, const Vector3d& to, std::vector<Hit>& all) const {
  all.clear();
  if (!from.allFinite() || !to.allFinite() || from == to) return false;
  for (const std::size_t t : tree_->of(from, to)) {
    const Vector3d &a = p(triangles_[t][0]), &b = p(triangles_[t][1]), &c = p(triangles_[t][2]);
    const int start = side_of_plane(a, b, c, from), end = side_of_plane(a, b, c, to);
    const std::array<int, 3> around{side_of_plane(from, to, a, b), side_of_plane(from, to, b, c),
                                    side_of_plane(from, to, c, a)};
    const auto [least, most] = std::minmax_element(around.begin(), around.end());
    if (*least == 0 || *most == 0 || start == 0 || end == 0) return false;
    // In units of the size, so that the products neither overflow nor underflow.
    const Vector3d normal = ((b - a) / size_).cross((c - a) / size_);
    const double before = normal.dot((from - a) / size_), behind = normal.dot((to - a) / size_);
    all.push_back({before / (before - behind), 2 * t + (start > 0 ? 0 : 1), 2 * t + (start > 0 ? 1 : 0)});
  }
  if (std::any_of(all.begin(), all.end(), [](const Hit& hit) { return !std::isfinite(hit.at); }))
    return false;
  std::sort(all.begin(), all.end(), [](const Hit& one, const Hit& other) { return one.at < other.at; });
  for (std::size_t i = 1; i < all.size(); ++i)
    if (!(all[i].at - all[i - 1].at > 1e-9)) return false;
  return true;
}

constexpr int attempts = 24;

// Parts of the surface that touch no other one: what lies around each is found by a segment from far away.
bool Cells::join_parts() {
  std::map<std::size_t, std::size_t> parts;  // by part: its first triangle
  for (std::size_t t = 0; t < triangles_.size(); ++t) parts.try_emplace(parts_.cell(2 * t), t);
  std::optional<std::size_t> outermost;
  for (const auto& [part, triangle] : parts) {
    bool found = false;
    for (int attempt = 0; attempt < attempts && !found; ++attempt) {
      const Triangle& t = triangles_[triangle];
      const Vector3d from = far_point(attempt), middle = (p(t[0]) + p(t[1]) + p(t[2])) / 3;
      std::vector<Hit> all;
      if (!hits(from, from + 3 * (middle - from), all)) continue;
      const auto first = std::find_if(all.begin(), all.end(), [&, in = part](const Hit& hit) {
        return parts_.cell(hit.near_side / 2 * 2) == in;
      });
      if (first == all.end()) continue;
      found = true;
      if (first != all.begin())
        sides_.join(std::prev(first)->far_side, first->near_side);
      else if (outermost)
        sides_.join(*outermost, first->near_side);
      else
        outermost = first->near_side;
    }
    if (!found) return false;
  }
  if (outermost) outermost_ = *outermost;
  return outermost.has_value();
}

// A side of the cell that has the place; nothing if it is the outermost one, or not to be decided.
std::optional<std::size_t> Cells::side_around(const Vector3d& place) const {
  std::vector<Hit> all;
  for (int attempt = 0; attempt < attempts; ++attempt)
    if (hits(far_point(attempt), place, all))
      return all.empty() ? std::nullopt : std::optional(all.back().far_side);
  return {};
}

std::optional<SolidBoundary> Cells::separate(const std::vector<std::size_t>& empty) {
  std::vector<bool> empty_cells(2 * triangles_.size());
  for (const std::size_t side : empty) empty_cells[sides_.cell(side)] = true;
  const auto is_empty = [&](std::size_t side) { return empty_cells[sides_.cell(side)]; };
  SolidBoundary boundary;
  std::map<std::array<Index, 2>, int> open;  // by edge: how often it is run upwards rather than downwards
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const bool front = is_empty(2 * t), back = is_empty(2 * t + 1);
    if (front == back) continue;
    Triangle triangle = triangles_[t];
    if (back) std::swap(triangle[1], triangle[2]);
    boundary.turned += back;
    boundary.triangles.push_back(triangle);
    boundary.from.push_back(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = triangle[k], b = triangle[(k + 1) % 3];
      open[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  if (boundary.triangles.empty()) return {};
  for (const auto& [edge, more] : open)
    if (more != 0) return {};
  return boundary;
}

bool all_finite(const std::vector<Vector3d>& points, const std::vector<Triangle>& triangles) {
  return std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](Index i) { return points[static_cast<std::size_t>(i)].allFinite(); });
  });
}

struct DirectedSides {
  std::vector<std::array<Index, 2>> all, reversed;  // sorted

  explicit DirectedSides(const std::vector<Triangle>& triangles) {
    for (const Triangle& t : triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = t[k], b = t[(k + 1) % 3];
        all.push_back({a, b}), reversed.push_back({b, a});
      }
    std::sort(all.begin(), all.end());
    std::sort(reversed.begin(), reversed.end());
  }
  // Whether each is run as often one way as the other.
  bool balanced() const { return all == reversed; }
  bool repeated() const { return std::adjacent_find(all.begin(), all.end()) != all.end(); }
};

// Whether the triangles are the surface of one solid already, in one piece and wound outwards, as in most
// files.
bool is_one_solid(const std::vector<Vector3d>& points, const std::vector<Triangle>& triangles) {
  std::vector<std::size_t> parent(points.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  double volume = 0, size = 0;
  const Vector3d& origin = points[static_cast<std::size_t>(triangles[0][0])];
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      parent[root(static_cast<std::size_t>(t[k]))] = root(static_cast<std::size_t>(t[(k + 1) % 3]));
    const auto p = [&](std::size_t k) -> Vector3d { return points[static_cast<std::size_t>(t[k])] - origin; };
    const double part = p(0).dot(p(1).cross(p(2)));
    volume += part, size += std::abs(part);
  }
  if (!(volume > 1e-6 * size)) return false;
  const std::size_t first = root(static_cast<std::size_t>(triangles[0][0]));
  for (const Triangle& t : triangles)
    if (root(static_cast<std::size_t>(t[0])) != first) return false;
  const DirectedSides sides(triangles);
  return sides.balanced() && !sides.repeated();
}

}  // namespace

std::optional<SolidBoundary> solid_boundary(const std::vector<Vector3d>& points,
                                            const std::vector<Triangle>& triangles,
                                            std::span<const Vector3d> holes) {
  if (triangles.empty() || !all_finite(points, triangles)) return {};
  if (holes.empty() && is_one_solid(points, triangles)) return {};
  return Cells(points, triangles).boundary(holes);
}

bool are_solid_boundary(const std::vector<Vector3d>& points, const std::vector<Triangle>& triangles,
                        std::span<const Vector3d> holes) {
  if (triangles.empty() || !all_finite(points, triangles)) return false;
  if (holes.empty() && is_one_solid(points, triangles)) return true;
  if (!DirectedSides(triangles).balanced()) return false;
  const std::optional<SolidBoundary> boundary = Cells(points, triangles).boundary(holes);
  return boundary && boundary->turned == 0 && boundary->triangles.size() == triangles.size();
}

}  // namespace tetproof::io
