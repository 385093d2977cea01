// SPDX-License-Identifier: GPL-3.0-or-later
// Table 4, by counting the tetrahedra at every face and every edge.
#include <algorithm>

#include "tests/second/section3.hpp"

namespace tetproof::second {
namespace {

using Tet = std::array<int, 4>;

template <std::size_t N>
std::array<int, N> sorted(std::array<int, N> v) {
  std::sort(v.begin(), v.end());
  return v;
}

// All faces, all edges of a tetrahedron, as positions in it.
constexpr std::array<std::array<int, 3>, 4> face_positions{{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
constexpr std::array<std::array<int, 2>, 6> edge_positions{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

}  // namespace

void Adaptation::count(const Tet& v, int change) {
  for (const auto& [a, b, c] : face_positions) faces_[sorted(std::array{v[a], v[b], v[c]})] += change;
  for (const auto& [a, b] : edge_positions) edges_[sorted(std::array{v[a], v[b]})] += change;
}

// Table 4 and what its split does to the sum of the errors.
Split Adaptation::split_of(const Tet& v, double error) const {
  const Mistake mistake = settings_.mistake;
  std::vector<int> on_surface;
  for (int i = 0; i < 4; ++i)
    if (surface_points_.count(v[i])) on_surface.push_back(i);
  const auto face_shared = [&](const std::array<int, 3>& f) {
    return faces_.at(sorted(std::array{v[f[0]], v[f[1]], v[f[2]]})) > 1;
  };
  const auto edge_shared = [&](const std::array<int, 2>& e) {
    return edges_.at(sorted(std::array{v[e[0]], v[e[1]]})) > 1;
  };
  const auto length = [&](const std::array<int, 2>& e) {
    return (points_[v[e[1]]] - points_[v[e[0]]]).norm();
  };
  const auto area = [&](const std::array<int, 3>& f) {
    return (points_[v[f[1]]] - points_[v[f[0]]]).cross(points_[v[f[2]]] - points_[v[f[0]]]).norm() / 2;
  };

  Split split{.row = std::to_string(on_surface.size()), .replaced = {0, 1, 2, 3}};
  std::vector<std::array<int, 3>> free_faces;
  for (const auto& f : face_positions)
    if (!face_shared(f)) free_faces.push_back(f);
  const auto use = [&](const auto& simplex) { split.replaced.assign(simplex.begin(), simplex.end()); };

  if (on_surface.size() == 2) {
    const std::array<int, 2> edge{on_surface[0], on_surface[1]};
    split.row = edge_shared(edge) ? "2a" : "2b";
    if (split.row == "2b") use(edge);
  } else if (on_surface.size() == 3) {
    const std::array<int, 3> face{on_surface[0], on_surface[1], on_surface[2]};
    split.row = face_shared(face) || mistake == Mistake::row_3b_as_3a ? "3a" : "3b";
    if (split.row == "3b") use(face);
  } else if (on_surface.size() == 4) {
    split.row = std::string("4") + "abcde"[free_faces.size()];
    if (split.row == "4b") use(free_faces[0]);
    if (free_faces.size() >= 2) {
      std::vector<std::array<int, 2>> free_edges;
      for (const auto& e : edge_positions) {
        const auto has_edge = [&](const std::array<int, 3>& f) {
          return std::count(f.begin(), f.end(), e[0]) && std::count(f.begin(), f.end(), e[1]);
        };
        const bool common = std::count_if(free_faces.begin(), free_faces.end(), has_edge) == 2;
        if (!edge_shared(e) && (free_faces.size() > 2 || common)) free_edges.push_back(e);
      }
      if (mistake == Mistake::row_4c_on_face && split.row == "4c") free_edges.clear();
      const auto names = [&](const auto& simplex) {  // the vertices' numbers, by which ties are settled
        std::vector<int> numbers;
        for (const int i : simplex) numbers.push_back(v[i]);
        std::sort(numbers.begin(), numbers.end());
        return numbers;
      };
      const auto largest = [&](const auto& simplices, const auto& size) {
        return *std::min_element(simplices.begin(), simplices.end(), [&](const auto& a, const auto& b) {
          return std::pair(-size(a), names(a)) < std::pair(-size(b), names(b));
        });
      };
      if (!free_edges.empty())
        use(largest(free_edges, length));
      else
        use(largest(free_faces, area));
    }
  }

  split.on_surface = split.replaced.size() < 4 && mistake != Mistake::forgotten_surface_point;
  split.point = Point(0, 0, 0);
  for (const int i : split.replaced) split.point += points_[v[i]];
  split.point /= static_cast<double>(split.replaced.size());
  if (mistake == Mistake::skewed_centroid && split.replaced.size() == 3)
    split.point = (split.point * 3 + points_[v[split.replaced[0]]]) / 4;

  for (const int i : split.replaced) {
    Corners piece = corners(v);
    piece[i] = split.point;
    split.change += weigh(surface_, piece, law_, mistake).error;
  }
  split.change -= error;
  return split;
}

}  // namespace tetproof::second
