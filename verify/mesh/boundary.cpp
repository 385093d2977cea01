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
  std::vector<std::array<Index, 2>> links;

  // Follows the path from `third` to its other end; -1 if there is no such path.
  Index other_end(Index third) const {
    Index here = third;
    std::size_t last = links.size();
    for (std::size_t steps = 0; steps <= links.size(); ++steps) {
      std::size_t way = links.size(), ways = 0;
      for (std::size_t i = 0; i < links.size(); ++i)
        if (i != last && (links[i][0] == here || links[i][1] == here)) way = i, ++ways;
      if (ways == 0) return here == third ? -1 : here;
      if (ways > 1) return -1;
      here = links[way][0] == here ? links[way][1] : links[way][0];
      last = way;
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
        found->second.links.push_back({tet[k], tet[l]});
      }
  }
  const auto third = [&](Side s) {
    return triangles[static_cast<std::size_t>(s / 3)][static_cast<std::size_t>((s + 2) % 3)];
  };
  for (const std::vector<Side>& sides : edges.nonmanifold) {
    const Wedges& wedges = around[std::minmax({from(triangles, sides[0]), to(triangles, sides[0])})];
    for (const Side s : sides) {
      const Index end = wedges.other_end(third(s));
      for (const Side other : sides)
        if (other != s && third(other) == end && wedges.other_end(end) == third(s)) mate[s] = other;
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
