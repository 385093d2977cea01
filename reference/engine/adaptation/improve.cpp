// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/adaptation/improve.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/engine/first_grid/exact.hpp"

namespace tetproof::reference {
namespace {

// The denominator of tan(Omega/2) at `v`.
double denominator(const Eigen::Vector3d& v, const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                   const Eigen::Vector3d& r) {
  const Eigen::Vector3d a = p - v, b = q - v, c = r - v;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return la * lb * lc + a.dot(b) * lc + a.dot(c) * lb + b.dot(c) * la;
}

double six_volumes(const std::array<Eigen::Vector3d, 4>& t) {
  return std::abs((t[1] - t[0]).cross(t[2] - t[0]).dot(t[3] - t[0]));
}

double largest_face(const std::array<Eigen::Vector3d, 4>& t) {
  double largest = 0;
  for (const auto& [i, j, k] : tet_faces)
    largest = std::max(largest, (t[j] - t[i]).cross(t[k] - t[i]).norm() / 2);
  return largest;
}

Corners ascending(Corners tet) {
  std::sort(tet.begin(), tet.end());
  return tet;
}

double quality(const Triangulation& grid, const Corners& tet, Criterion criterion) {
  const auto& [a, b, c, d] = ascending(tet);
  const std::array corners{grid.point(a), grid.point(b), grid.point(c), grid.point(d)};
  return criterion == Criterion::aspect_ratio ? aspect_ratio(corners) : smallest_solid_angle(corners);
}

// The vertices as a positive tetrahedron: ascending, or with the last two exchanged. Nothing if they are
// coplanar.
std::optional<Corners> positive(const Triangulation& grid, Corners tet) {
  tet = ascending(tet);
  const int sign =
      orientation(grid.point(tet[0]), grid.point(tet[1]), grid.point(tet[2]), grid.point(tet[3]));
  if (sign == 0) return std::nullopt;
  if (sign < 0) std::swap(tet[2], tet[3]);
  return tet;
}

Index apex(const Corners& tet, const std::array<Index, 3>& face) {
  for (const Index v : tet)
    if (std::find(face.begin(), face.end(), v) == face.end()) return v;
  return -1;
}

bool contains(const std::vector<Index>& set, Index tet) {
  return std::find(set.begin(), set.end(), tet) != set.end();
}

// Whether the edge passes through the inside of the face: the face's three edges lie on the same side of it.
bool pierces(const Triangulation& grid, const std::array<Index, 3>& face, const std::array<Index, 2>& edge) {
  const auto sign = [&](Index p, Index q) {
    return orientation(grid.point(p), grid.point(q), grid.point(edge[0]), grid.point(edge[1]));
  };
  const int first = sign(face[0], face[1]);
  return first != 0 && sign(face[1], face[2]) == first && sign(face[2], face[0]) == first;
}

// Whether the ends of the edge lie strictly on different sides of the plane of the face.
bool separates(const Triangulation& grid, const std::array<Index, 3>& face,
               const std::array<Index, 2>& edge) {
  const auto side = [&](Index p) {
    return orientation(grid.point(face[0]), grid.point(face[1]), grid.point(face[2]), grid.point(p));
  };
  return side(edge[0]) * side(edge[1]) < 0;
}

// The flip, which must be possible, with its tetrahedra and qualities before and after.
Flip flip_of(const Triangulation& grid, std::vector<Index> old, const std::array<Index, 3>& face,
             const std::array<Index, 2>& edge, Criterion criterion) {
  Flip flip{.old = std::move(old), .fresh = {}, .face = face, .edge = edge};
  const auto& [a, b, c] = face;
  const auto& [d, e] = edge;
  const std::vector<Corners> around_edge{{a, b, d, e}, {a, c, d, e}, {b, c, d, e}};
  const std::vector<Corners> beside_face{{a, b, c, d}, {a, b, c, e}};
  std::vector<Corners> fresh = flip.old.size() == 2 ? around_edge : beside_face;
  for (Corners& tet : fresh) tet = ascending(tet);
  std::sort(fresh.begin(), fresh.end());
  const auto smallest = [&](const auto& tets) {
    double least = std::numeric_limits<double>::infinity();
    for (const Corners& tet : tets) least = std::min(least, quality(grid, tet, criterion));
    return least;
  };
  flip.after = smallest(fresh);
  flip.before = smallest(flip.old.size() == 2 ? beside_face : around_edge);
  for (const Corners& tet : fresh) flip.fresh.push_back(positive(grid, tet).value());
  return flip;
}

template <std::size_t N>
std::array<Index, N> sorted(std::array<Index, N> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

}  // namespace

double smallest_solid_angle(const std::array<Eigen::Vector3d, 4>& t) {
  return six_volumes(t) /
         std::max({denominator(t[0], t[1], t[2], t[3]), denominator(t[1], t[0], t[2], t[3]),
                   denominator(t[2], t[0], t[1], t[3]), denominator(t[3], t[0], t[1], t[2])});
}

double aspect_ratio(const std::array<Eigen::Vector3d, 4>& t) {
  const double area = largest_face(t);
  return six_volumes(t) / 2 / area / area;
}

double dimensionless_aspect_ratio(const std::array<Eigen::Vector3d, 4>& t) {
  return aspect_ratio(t) * std::sqrt(largest_face(t));
}

double solid_angle_of(double tangent) {
  return 2 * std::atan(tangent) / (4 * std::numbers::pi);
}

std::array<Index, 5> Flip::vertices() const {
  return sorted(std::array{face[0], face[1], face[2], edge[0], edge[1]});
}

std::vector<Flip> possible_flips(const Triangulation& grid, const std::vector<Index>& set,
                                 Criterion criterion) {
  std::vector<Flip> found;
  for (const Index t : set) {
    const Corners& tet = grid.corners(t);
    for (int f = 0; f < 4; ++f) {  // 2-3 across the face
      const Index n = grid.neighbour(t, f);
      if (n < t || !contains(set, n)) continue;
      const auto& [i, j, k] = tet_faces[f];
      const auto face = sorted(std::array{tet[i], tet[j], tet[k]});
      const auto edge = sorted(std::array{tet[f], apex(grid.corners(n), face)});
      if (pierces(grid, face, edge)) found.push_back(flip_of(grid, {t, n}, face, edge, criterion));
    }
    for (int i = 0; i < 4; ++i)  // 3-2 around the edge i j, found only from the lowest-numbered of the three
      for (int j = i + 1; j < 4; ++j) {
        std::array<int, 2> others{};
        for (int k = 0, at = 0; k < 4; ++k)
          if (k != i && k != j) others[at++] = k;
        const Index m = grid.neighbour(t, others[0]), n = grid.neighbour(t, others[1]);
        if (m < t || n < t || m == n || !contains(set, m) || !contains(set, n)) continue;
        const auto edge = sorted(std::array{tet[i], tet[j]});
        // m has the edge, others[1] and a third vertex; n has the edge, others[0] and a third vertex.
        const Index third = apex(grid.corners(m), {tet[i], tet[j], tet[others[1]]});
        if (third != apex(grid.corners(n), {tet[i], tet[j], tet[others[0]]})) continue;
        const auto& beside_m = grid.corners(m);
        const auto face_to_n = std::find(beside_m.begin(), beside_m.end(), tet[others[1]]) - beside_m.begin();
        if (grid.neighbour(m, static_cast<int>(face_to_n)) != n) continue;
        const auto face = sorted(std::array{tet[others[0]], tet[others[1]], third});
        if (separates(grid, face, edge)) found.push_back(flip_of(grid, {t, m, n}, face, edge, criterion));
      }
  }
  return found;
}

std::optional<Flip> best_flip(const Triangulation& grid, const std::vector<Index>& set, Criterion criterion) {
  std::optional<Flip> best;
  for (Flip& flip : possible_flips(grid, set, criterion)) {
    if (!(flip.gain() > 0)) continue;
    if (!best || flip.gain() > best->gain() ||
        (flip.gain() == best->gain() && flip.vertices() < best->vertices()))
      best = std::move(flip);
  }
  return best;
}

std::vector<Index> updated_set(std::vector<Index> set, const Flip& flip, Index first_fresh) {
  std::erase_if(set, [&](Index t) { return contains(flip.old, t); });
  for (std::size_t k = 0; k < flip.fresh.size(); ++k) set.push_back(first_fresh + static_cast<Index>(k));
  return set;
}

}  // namespace tetproof::reference
