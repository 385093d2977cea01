// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/report/boundary_faces.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace tetproof::corpus {
namespace {

// The number of parts of groups that hang together by common members.
template <class Member>
std::int64_t parts(const std::vector<std::vector<Member>>& groups) {
  std::vector<std::size_t> parent(groups.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  std::map<Member, std::size_t> first;
  for (std::size_t i = 0; i < groups.size(); ++i)
    for (const Member& member : groups[i]) parent[root(first.emplace(member, i).first->second)] = root(i);
  std::int64_t roots = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) roots += parent[i] == i;
  return roots;
}

}  // namespace

BoundaryFaces::BoundaryFaces(const TetMesh& mesh) {
  const auto sorted = [](std::array<Index, 3> face) {
    std::sort(face.begin(), face.end());
    return face;
  };
  const auto face_of = [](const std::array<Index, 4>& tet, const std::array<int, 3>& corners) {
    return std::array{tet[static_cast<std::size_t>(corners[0])], tet[static_cast<std::size_t>(corners[1])],
                      tet[static_cast<std::size_t>(corners[2])]};
  };
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const auto& corners : tet_faces)
      tets_[sorted(face_of(mesh.tets[t], corners))].push_back(static_cast<Index>(t));
  for (const auto& tet : mesh.tets)
    for (const auto& corners : tet_faces) {
      const auto face = face_of(tet, corners), key = sorted(face);
      if (tets_.at(key).size() == 1 && key[0] >= 0 && key[2] < static_cast<Index>(mesh.points.size()) &&
          key[0] != key[1] && key[1] != key[2])
        boundary_.push_back(face);
    }
}

const std::vector<Index>& BoundaryFaces::tets(std::array<Index, 3> face) const {
  static const std::vector<Index> none;
  std::sort(face.begin(), face.end());
  const auto found = tets_.find(face);
  return found == tets_.end() ? none : found->second;
}

FaceCounts face_counts(std::span<const std::array<Index, 3>> triangles) {
  using Edge = std::pair<Index, Index>;
  std::set<Index> vertices;
  std::set<Edge> edges;
  std::vector<std::vector<Edge>> groups;
  for (const auto& t : triangles) {
    vertices.insert(t.begin(), t.end());
    groups.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) groups.back().push_back(std::minmax({t[k], t[(k + 1) % 3]}));
    edges.insert(groups.back().begin(), groups.back().end());
  }
  return {.components = parts(groups),
          .euler = static_cast<std::int64_t>(vertices.size() + triangles.size()) -
                   static_cast<std::int64_t>(edges.size())};
}

std::int64_t fans_at(std::span<const std::array<Index, 3>> triangles, Index vertex) {
  std::vector<std::vector<Index>> groups;
  for (const auto& t : triangles) {
    if (std::find(t.begin(), t.end(), vertex) == t.end()) continue;
    groups.emplace_back();
    for (const Index v : t)
      if (v != vertex) groups.back().push_back(v);
  }
  return parts(groups);
}

}  // namespace tetproof::corpus
