// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/planting/plant_outcome.hpp"

#include <algorithm>
#include <bit>
#include <set>

namespace tetproof::corpus {
namespace {

bool same_bits(const Point& p, const Point& q) {
  for (int k = 0; k < 3; ++k)
    if (std::bit_cast<std::uint64_t>(p[k]) != std::bit_cast<std::uint64_t>(q[k])) return false;
  return true;
}

}  // namespace

Outcome outcome(const Site& s) {
  Outcome result;
  const TetMesh& before = s.parts.mesh;
  result.mesh.points = s.mesh.points;
  std::vector<std::uint8_t> moved(s.mesh.points.size(), 0);
  std::set<Index> vertices(s.vertices.begin(), s.vertices.end());
  for (std::size_t v = 0; v < s.mesh.points.size(); ++v)
    if (v >= before.points.size() || !same_bits(s.mesh.points[v], before.points[v]))
      moved[v] = 1, vertices.insert(static_cast<Index>(v));
  result.anything = !vertices.empty() || s.mesh.points.size() != before.points.size();
  std::set<Index> beside_removed;
  for (std::size_t t = 0; t < s.removed.size(); ++t)
    if (s.removed[t] && t < before.tets.size())
      for (const Index u : s.parts.neighbours[t])
        if (u >= 0) beside_removed.insert(u);
  for (std::size_t t = 0; t < s.mesh.tets.size(); ++t) {
    if (s.removed[t]) {
      result.anything = true;
      continue;
    }
    const auto now = static_cast<Index>(result.mesh.tets.size());
    result.mesh.tets.push_back(s.mesh.tets[t]);
    const bool changed =
        t >= before.tets.size() || s.mesh.tets[t] != before.tets[t] ||
        std::any_of(s.mesh.tets[t].begin(), s.mesh.tets[t].end(), [&](Index v) {
          return v >= 0 && v < static_cast<Index>(moved.size()) && moved[static_cast<std::size_t>(v)];
        });
    if (changed) result.changed.push_back(now), result.anything = true;
    if (!changed && !beside_removed.contains(static_cast<Index>(t))) continue;
    result.tets.push_back(now);
    result.origins.push_back(static_cast<Index>(t));
  }
  result.vertices.assign(vertices.begin(), vertices.end());
  return result;
}

std::vector<std::uint8_t> taken_by(const Site& s) {
  const Outcome first = outcome(s);
  std::vector<std::uint8_t> taken(s.parts.mesh.points.size(), 0);
  const auto take = [&](Index v) {
    if (v >= 0 && v < static_cast<Index>(taken.size())) taken[static_cast<std::size_t>(v)] = 1;
  };
  for (const Index v : first.vertices) take(v);
  for (const Index t : first.tets)
    for (const Index v : first.mesh.tets[static_cast<std::size_t>(t)]) take(v);
  for (std::size_t t = 0; t < s.parts.mesh.tets.size(); ++t)
    if (s.removed[t] || s.mesh.tets[t] != s.parts.mesh.tets[t])
      for (const Index v : s.parts.mesh.tets[t]) take(v);
  // The tetrahedra in the bounding box of the change count as concerned, too.
  Eigen::AlignedBox3d box;
  for (const Index t : first.tets)
    for (const Index v : first.mesh.tets[static_cast<std::size_t>(t)])
      if (v >= 0 && v < static_cast<Index>(first.mesh.points.size()) &&
          first.mesh.points[static_cast<std::size_t>(v)].allFinite())
        box.extend(first.mesh.points[static_cast<std::size_t>(v)]);
  for (const Tet& tet : s.parts.mesh.tets) {
    Eigen::AlignedBox3d own;
    for (const Index v : tet) own.extend(s.at(v));
    if (box.intersects(own))
      for (const Index v : tet) take(v);
  }
  for (int ring = 0; ring < 2; ++ring) {
    const std::vector<std::uint8_t> before = taken;
    for (const Tet& tet : s.parts.mesh.tets)
      if (std::any_of(tet.begin(), tet.end(),
                      [&](Index v) { return before[static_cast<std::size_t>(v)] != 0; }))
        for (const Index v : tet) take(v);
  }
  return taken;
}

bool apart(const TetMesh& mesh, const PlantedRoot& one, const PlantedRoot& other) {
  const auto box = [&](const PlantedRoot& root) {
    Eigen::AlignedBox3d all;
    const auto extend = [&](Index v) {
      if (v >= 0 && v < static_cast<Index>(mesh.points.size()) &&
          mesh.points[static_cast<std::size_t>(v)].allFinite())
        all.extend(mesh.points[static_cast<std::size_t>(v)]);
    };
    for (const Index t : root.tets)
      for (const Index v : mesh.tets[static_cast<std::size_t>(t)]) extend(v);
    for (const Index v : root.vertices) extend(v);
    return all;
  };
  return !box(one).intersects(box(other));
}

}  // namespace tetproof::corpus
