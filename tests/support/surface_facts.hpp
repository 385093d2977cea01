// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests measure on a surface, by other means than the judge's.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::test {

struct SurfaceFacts {
  bool closed_and_oriented = true;  // every directed edge once, and once the other way
  bool one_fan_per_vertex = true;   // and every vertex used
  long euler = 0;
  int components = 0;
  long double volume = 0;  // signed
};

inline long double signed_volume(const TriangleSurface& surface) {
  long double volume = 0;
  const Eigen::Matrix<long double, 3, 1> origin = surface.vertices.at(0).cast<long double>();
  for (const auto& t : surface.triangles) {
    const Eigen::Matrix<long double, 3, 1> a = surface.vertices[t[0]].cast<long double>() - origin,
                                           b = surface.vertices[t[1]].cast<long double>() - origin,
                                           c = surface.vertices[t[2]].cast<long double>() - origin;
    volume += a.cross(b).dot(c) / 6;
  }
  return volume;
}

inline SurfaceFacts facts(const TriangleSurface& surface) {
  SurfaceFacts facts;
  const std::size_t nv = surface.vertices.size(), nt = surface.triangles.size();
  std::vector<std::array<Index, 2>> edges;
  for (const auto& t : surface.triangles)
    for (int c = 0; c < 3; ++c) edges.push_back({t[c], t[(c + 1) % 3]});
  std::sort(edges.begin(), edges.end());
  facts.closed_and_oriented = std::adjacent_find(edges.begin(), edges.end()) == edges.end();
  for (const auto& [a, b] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), std::array<Index, 2>{b, a}))
      facts.closed_and_oriented = false;

  // A vertex's triangles form one fan if walking from corner to corner around it returns after all of them.
  std::vector<Index> degree(nv, 0);
  std::vector<std::array<Index, 3>> spokes;  // vertex, next, previous
  for (const auto& t : surface.triangles)
    for (int c = 0; c < 3; ++c) {
      ++degree[t[c]];
      spokes.push_back({t[c], t[(c + 1) % 3], t[(c + 2) % 3]});
    }
  std::sort(spokes.begin(), spokes.end());
  for (std::size_t first = 0; first < spokes.size() && facts.closed_and_oriented;) {
    const Index v = spokes[first][0];
    Index at = spokes[first][1], steps = 0;
    do {
      at = (*std::lower_bound(spokes.begin(), spokes.end(), std::array<Index, 3>{v, at, 0}))[2];
      ++steps;
    } while (at != spokes[first][1]);
    if (steps != degree[v]) facts.one_fan_per_vertex = false;
    first += degree[v];
  }
  if (std::find(degree.begin(), degree.end(), 0) != degree.end()) facts.one_fan_per_vertex = false;

  facts.euler = static_cast<long>(nv) - static_cast<long>(edges.size() / 2) + static_cast<long>(nt);
  std::vector<Index> parent(nv);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](Index v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& [a, b] : edges) parent[root(a)] = root(b);
  for (std::size_t v = 0; v < nv; ++v) facts.components += parent[v] == static_cast<Index>(v);

  facts.volume = signed_volume(surface);
  return facts;
}

}  // namespace tetproof::test
