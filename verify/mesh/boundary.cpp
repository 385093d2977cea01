// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/mesh/boundary.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace tetproof::verify {
namespace {

// The tetrahedra around one non-manifold edge, as a graph. Its nodes are the third vertices of the faces at
// the edge; each tetrahedron links two of them. The connected components are the wedges. If all faces of a
// wedge match, it is a path between two boundary faces.
struct Wedges {
  std::vector<std::pair<Index, Index>> links;  // each in both directions; ascending when `other_end` is asked

  void add(Index a, Index b) { links.emplace_back(a, b), links.emplace_back(b, a); }

  // Follows the path from `third` to its other end; -1 if there is no such path.
  Index other_end(Index third) const {
    Index before = -1, here = third;
    for (std::size_t steps = 0; steps <= links.size(); ++steps) {
      const auto first = std::lower_bound(links.begin(), links.end(), std::pair(here, Index{-1}));
      const auto last = std::lower_bound(first, links.end(), std::pair(here + 1, Index{-1}));
      const auto ways = last - first;
      if (before >= 0 && ways == 1) return here;
      if (ways != (before >= 0 ? 2 : 1) || (ways == 2 && first[0] == first[1])) return -1;
      const Index next = first->second != before ? first->second : first[1].second;
      before = std::exchange(here, next);
    }
    return -1;
  }
};

// At each non-manifold edge, pairs the two boundary faces that bound the same wedge.
void pair_wedges(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                 std::span<const Triangle> triangles, const EdgeMatching& edges, std::vector<Side>& mate) {
  std::map<std::pair<Index, Index>, Wedges> around;
  std::vector<std::uint8_t> is_end(mesh.points.size(), 0);
  for (const std::vector<Side>& sides : edges.nonmanifold) {
    const auto ends = std::minmax({from(triangles, sides[0]), to(triangles, sides[0])});
    around[ends];
    is_end[ends.first] = is_end[ends.second] = 1;
  }
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (!excluded.empty() && excluded[t]) continue;
    const std::array<Index, 4>& tet = mesh.tets[t];
    if (is_end[tet[0]] + is_end[tet[1]] + is_end[tet[2]] + is_end[tet[3]] < 2) continue;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) {
        if (!is_end[tet[i]] || !is_end[tet[j]]) continue;
        const auto found = around.find(std::minmax({tet[i], tet[j]}));
        if (found == around.end()) continue;
        const int k = i != 0 && j != 0 ? 0 : i != 1 && j != 1 ? 1 : 2, l = 6 - i - j - k;
        found->second.add(tet[k], tet[l]);
      }
  }
  const auto third = [&](Side s) {
    return triangles[static_cast<std::size_t>(s / 3)][static_cast<std::size_t>((s + 2) % 3)];
  };
  for (const std::vector<Side>& sides : edges.nonmanifold) {
    Wedges& wedges = around[std::minmax({from(triangles, sides[0]), to(triangles, sides[0])})];
    std::sort(wedges.links.begin(), wedges.links.end());
    std::vector<std::pair<Index, Side>> by_third;
    for (const Side s : sides) by_third.emplace_back(third(s), s);
    std::sort(by_third.begin(), by_third.end());
    for (const auto& [v, s] : by_third) {
      const Index end = wedges.other_end(v);
      const auto other = std::lower_bound(by_third.begin(), by_third.end(), std::pair(end, Side{0}));
      if (end >= 0 && other != by_third.end() && other->first == end) mate[s] = other->second;
    }
  }
}

}  // namespace

Boundary find_boundary(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                       const FaceMatching& matching) {
  Boundary result;
  result.faces = matching.boundary;
  for (const FaceId face : result.faces) result.triangles.push_back(vertices_of(mesh, face));
  for (const FaceGroups* groups : {&matching.thrice, &matching.same_side})
    for (const FaceId face : groups->faces) result.triangles.push_back(vertices_of(mesh, face));

  const std::span<const Triangle> triangles = result.boundary_triangles();
  result.edges = match_edges(triangles, mesh.points.size());
  result.groups = find_sheets(triangles, result.edges.mate);
  if (result.edges.nonmanifold.empty()) {
    result.sheets = result.groups;
  } else {
    std::vector<Side> mate = result.edges.mate;
    pair_wedges(mesh, excluded, triangles, result.edges, mate);
    result.sheets = find_sheets(triangles, mate);
  }
  for (const Sheet& sheet : result.sheets.sheets) result.closed = result.closed && sheet.open_sides == 0;

  std::vector<Index> ends;
  for (const std::vector<Side>& sides : result.edges.nonmanifold) {
    ends.push_back(from(triangles, sides[0]));
    ends.push_back(to(triangles, sides[0]));
  }
  std::sort(ends.begin(), ends.end());
  const std::vector<Index> several = repeated(result.groups.vertices_of_fans);
  std::set_difference(several.begin(), several.end(), ends.begin(), ends.end(),
                      std::back_inserter(result.pinched));
  return result;
}

}  // namespace tetproof::verify
