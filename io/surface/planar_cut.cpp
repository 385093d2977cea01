// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/planar_cut.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>

#include "io/surface/constrained.hpp"

namespace tetproof::io {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::uint64_t key(std::int32_t from, std::int32_t to) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(from)) << 32 | static_cast<std::uint32_t>(to);
}

// The plane, seen along an axis so that the normal points to the eye.
struct View {
  Eigen::Index u, v;
  PlaneSlope slope;

  explicit View(const Vector3d& normal) {
    Eigen::Index w;
    normal.cwiseAbs().maxCoeff(&w);
    u = (w + 1) % 3, v = (w + 2) % 3;
    if (normal[w] < 0) std::swap(u, v);
    slope = {-normal[u] / normal[w], -normal[v] / normal[w]};
  }
  Vector2d operator()(const Vector3d& point) const { return {point[u], point[v]}; }
};

class Mesh {
 public:
  Mesh(std::vector<Triangle2> triangles, const std::vector<PlaneEdge>& edges)
      : triangles_(std::move(triangles)) {
    for (std::size_t t = 0; t < triangles_.size(); ++t) enter(t);
    for (const PlaneEdge& edge : edges) {
      count_[key(edge.ends[0], edge.ends[1])] += edge.count;
      count_[key(edge.ends[1], edge.ends[0])] += edge.count;
      run(net_, edge.ends[0], edge.ends[1], edge.net);
    }
  }

  void leave_outside(bool odd, const std::vector<std::size_t>& in_holes);
  bool has_sides_of_edges() const;
  void make_delaunay(const std::vector<Vector2d>& points, const PlaneSlope& slope);
  std::size_t find(const Vector2d& point, const std::vector<Vector2d>& points) const;
  const std::vector<Triangle2>& triangles() const { return triangles_; }

 private:
  using Net =
      std::unordered_map<std::uint64_t, std::int64_t>;  // by side, upwards: how much more up than down
  static void run(Net& net, std::int32_t from, std::int32_t to, std::int64_t more) {
    net[key(std::min(from, to), std::max(from, to))] += from < to ? more : -more;
  }

  void enter(std::size_t t) {
    for (std::size_t k = 0; k < 3; ++k)
      of_side_[key(triangles_[t][k], triangles_[t][(k + 1) % 3])] = static_cast<std::int32_t>(t);
  }
  std::int32_t behind(std::int32_t from, std::int32_t to) const {
    const auto found = of_side_.find(key(to, from));
    return found == of_side_.end() ? -1 : found->second;
  }
  std::int64_t count(std::int32_t from, std::int32_t to) const {
    const auto found = count_.find(key(from, to));
    return found == count_.end() ? 0 : found->second;
  }

  std::vector<Triangle2> triangles_;
  std::unordered_map<std::uint64_t, std::int32_t> of_side_;  // by directed side: its triangle
  std::unordered_map<std::uint64_t, std::int64_t> count_;    // by directed side: how many edges cover it
  Net net_;                                                  // of the edges
};

// Keeps what lies inside.
void Mesh::leave_outside(bool odd, const std::vector<std::size_t>& in_holes) {
  enum : signed char { unknown = -1, outside = 0, inside = 1 };
  std::vector<signed char> state(triangles_.size(), unknown);
  std::vector<std::size_t> reached;
  const auto reach = [&](std::size_t t, int what) {
    if (state[t] != unknown) return;
    state[t] = static_cast<signed char>(what);
    reached.push_back(t);
  };
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t from = triangles_[t][k], to = triangles_[t][(k + 1) % 3];
      if (behind(from, to) >= 0) continue;
      if (odd)
        reach(t, count(from, to) % 2 == 1 ? inside : outside);
      else if (count(from, to) == 0)
        reach(t, outside);
    }
  for (const std::size_t t : in_holes) reach(t, outside);
  while (!reached.empty()) {
    const std::size_t t = reached.back();
    reached.pop_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t from = triangles_[t][k], to = triangles_[t][(k + 1) % 3], next = behind(from, to);
      if (next < 0) continue;
      if (odd)
        reach(static_cast<std::size_t>(next), (state[t] + count(from, to)) % 2 == 1 ? inside : outside);
      else if (count(from, to) == 0)
        reach(static_cast<std::size_t>(next), outside);
    }
  }
  std::vector<Triangle2> kept;
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    if (state[t] != outside) kept.push_back(triangles_[t]);
  triangles_ = std::move(kept);
  of_side_.clear();
  for (std::size_t t = 0; t < triangles_.size(); ++t) enter(t);
}

// Whether the triangles run all sides as the edges do. If not, some of these run around a part the wrong way:
// the polygon crosses itself at one of its corners.
bool Mesh::has_sides_of_edges() const {
  Net left = net_;
  for (const Triangle2& t : triangles_)
    for (std::size_t k = 0; k < 3; ++k) run(left, t[k], t[(k + 1) % 3], -1);
  return std::all_of(left.begin(), left.end(), [](const auto& side) { return side.second == 0; });
}

// Lawson's flips. A diagonal that is no given edge is exchanged if the fourth point lies in the circle, or on
// it and the smallest of the four positions is not on the diagonal: as if each point were lifted by a small
// height, the smaller its position the less. So no order of flips leads to another end.
void Mesh::make_delaunay(const std::vector<Vector2d>& points, const PlaneSlope& slope) {
  std::vector<std::array<std::int32_t, 2>> sides;
  for (const Triangle2& t : triangles_)
    for (std::size_t k = 0; k < 3; ++k)
      if (t[k] < t[(k + 1) % 3]) sides.push_back({t[k], t[(k + 1) % 3]});
  while (!sides.empty()) {
    const std::int32_t a = sides.back()[0], b = sides.back()[1];  // clang 14 lets no lambda use bindings
    sides.pop_back();
    const std::int32_t left = behind(b, a), right = behind(a, b);
    if (left < 0 || right < 0 || count(a, b) > 0) continue;
    const auto opposite = [&](std::int32_t t) {
      for (const std::int32_t corner : triangles_[static_cast<std::size_t>(t)])
        if (corner != a && corner != b) return corner;
      return a;
    };
    const std::int32_t c = opposite(left), d = opposite(right);  // a b c and b a d run anticlockwise
    const auto p = [&](std::int32_t i) -> const Vector2d& { return points[static_cast<std::size_t>(i)]; };
    const int in = side_of_circle(slope, p(a), p(b), p(c), p(d));
    if (in < 0 || (in == 0 && std::min(a, b) < std::min(c, d))) continue;
    of_side_.erase(key(a, b)), of_side_.erase(key(b, a));
    triangles_[static_cast<std::size_t>(left)] = {a, d, c};
    triangles_[static_cast<std::size_t>(right)] = {d, b, c};
    enter(static_cast<std::size_t>(left)), enter(static_cast<std::size_t>(right));
    for (const auto& side : {std::array{a, d}, std::array{d, b}, std::array{b, c}, std::array{c, a}})
      sides.push_back({std::min(side[0], side[1]), std::max(side[0], side[1])});
  }
}

// The triangle that has the point inside or on its boundary; the number of triangles: none.
std::size_t Mesh::find(const Vector2d& point, const std::vector<Vector2d>& points) const {
  const auto p = [&](std::int32_t i) -> const Vector2d& { return points[static_cast<std::size_t>(i)]; };
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const auto& [a, b, c] = triangles_[t];
    if (turn(p(a), p(b), point) >= 0 && turn(p(b), p(c), point) >= 0 && turn(p(c), p(a), point) >= 0)
      return t;
  }
  return triangles_.size();
}

// The points of a facet in ascending order, and its edges between them.
struct Plane {
  std::vector<Index> at;  // positions of the points
  std::vector<Vector2d> points;
  std::vector<PlaneEdge> edges;

  Plane(const PlanarFacet& facet, const std::vector<Vector3d>& all, const View& view) {
    for (const auto& polygon : facet.polygons) at.insert(at.end(), polygon.begin(), polygon.end());
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    for (const Index i : at) points.push_back(view(all[static_cast<std::size_t>(i)]));
    std::map<std::array<std::int32_t, 2>, PlaneEdge> all_edges;
    for (const auto& polygon : facet.polygons) {
      const std::size_t n = polygon.size();
      for (std::size_t k = n == 2 ? 1 : 0; k < n; ++k) {
        const std::int32_t from = local(polygon[k]), to = local(polygon[(k + 1) % n]);
        if (from == to) continue;
        const std::array ends{std::min(from, to), std::max(from, to)};
        PlaneEdge& edge = all_edges.try_emplace(ends, PlaneEdge{ends, 0, 0}).first->second;
        ++edge.count, edge.net += from < to ? 1 : -1;
      }
    }
    for (const auto& [ends, edge] : all_edges) edges.push_back(edge);
  }

  std::int32_t local(Index i) const {
    return static_cast<std::int32_t>(std::lower_bound(at.begin(), at.end(), i) - at.begin());
  }
  bool has_equal_points() const {
    std::vector<std::pair<double, double>> sorted;
    for (const Vector2d& p : points) sorted.emplace_back(p[0], p[1]);
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
  }
};

// Whether a polygon runs a side twice in the same direction. A bridge to a hole is run once in each.
bool runs_a_side_twice(std::span<const Index> polygon) {
  std::vector<std::array<Index, 2>> sides;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    sides.push_back({polygon[k], polygon[(k + 1) % polygon.size()]});
  std::sort(sides.begin(), sides.end());
  return std::adjacent_find(sides.begin(), sides.end()) != sides.end();
}

}  // namespace

std::string cut_planar(const PlanarFacet& facet, const std::vector<Vector3d>& points, const Vector3d& normal,
                       std::vector<std::array<Index, 3>>& triangles) {
  if (facet.odd && runs_a_side_twice(facet.polygons[0])) return "winds more than once around";
  const View view(normal);
  const Plane plane(facet, points, view);
  if (plane.has_equal_points()) return "has two corners at one place, seen along its normal";
  std::optional<PlaneTriangulation> whole = constrained_triangulation(plane.points, plane.edges);
  if (!whole) return "crosses itself";
  Mesh mesh(std::move(whole->triangles), whole->edges);
  std::vector<std::size_t> in_holes;
  for (const Vector3d& hole : facet.holes)
    if (!hole.allFinite())
      continue;
    else if (const std::size_t t = mesh.find(view(hole), plane.points); t < mesh.triangles().size())
      in_holes.push_back(t);
  mesh.leave_outside(facet.odd, in_holes);
  if (facet.odd && !mesh.has_sides_of_edges()) return "crosses itself";
  mesh.make_delaunay(plane.points, view.slope);
  std::vector<std::array<Index, 3>> cut;
  for (Triangle2 t : mesh.triangles()) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    const auto at = [&](std::size_t k) { return plane.at[static_cast<std::size_t>(t[k])]; };
    cut.push_back({at(0), at(1), at(2)});
  }
  if (cut.empty() && facet.odd) return "surrounds nothing";
  std::sort(cut.begin(), cut.end());
  triangles.insert(triangles.end(), cut.begin(), cut.end());
  return {};
}

}  // namespace tetproof::io
