// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/checks/conformity.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "verify/checks/gaps.hpp"

namespace tetproof::verify {
namespace {

std::vector<HangingNode> hanging_nodes(const Interface& interface, const FacesAtVertices& at,
                                       const Gaps& gaps) {
  std::map<Index, HangingNode> nodes;
  for (const Contact& c : interface.contacts()) {
    if (gaps.free(c.triangle)) continue;
    const Index gap = gaps.of_face[static_cast<std::size_t>(c.triangle)];
    std::vector<Index> opposite;
    for (const Index g : at[c.vertex])
      if (gaps.of_face[static_cast<std::size_t>(g)] == gap && interface.opposite(c.triangle, g))
        opposite.push_back(g);
    if (opposite.empty()) continue;
    HangingNode& node = nodes.try_emplace(c.vertex, HangingNode{c.vertex, {}, {}}).first->second;
    node.carriers.push_back(c.triangle);
    node.opposite.insert(node.opposite.end(), opposite.begin(), opposite.end());
  }
  std::vector<HangingNode> result;
  for (auto& [v, node] : nodes) {
    std::sort(node.opposite.begin(), node.opposite.end());
    node.opposite.erase(std::unique(node.opposite.begin(), node.opposite.end()), node.opposite.end());
    result.push_back(std::move(node));
  }
  return result;
}

// The four faces on the vertices of two faces with a common edge, if there are exactly four.
std::optional<CrossedDiagonals> crossed(const Interface& interface, const FacesAtVertices& at,
                                        const Gaps& gaps, Index s, Index t) {
  CrossedDiagonals quad{};
  std::array<Index, 6> all{};
  std::copy(interface.triangle(s).begin(), interface.triangle(s).end(), all.begin());
  std::copy(interface.triangle(t).begin(), interface.triangle(t).end(), all.begin() + 3);
  std::sort(all.begin(), all.end());
  if (std::unique(all.begin(), all.end()) - all.begin() != 4) return std::nullopt;
  std::copy(all.begin(), all.begin() + 4, quad.vertices.begin());
  std::vector<Index> faces;
  for (const Index v : quad.vertices)
    for (const Index f : at[v]) {
      const Triangle& other = interface.triangle(f);
      if (gaps.free(f) && std::all_of(other.begin(), other.end(), [&](Index w) {
            return std::binary_search(quad.vertices.begin(), quad.vertices.end(), w);
          }))
        faces.push_back(f);
    }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  if (faces.size() != 4 || !interface.closes(faces)) return std::nullopt;
  // The outside of a tetrahedron that is cut into four and lies inside the mesh is none: nothing of the
  // tetrahedron reaches beyond its faces.
  if (std::none_of(faces.begin(), faces.end(), [&](Index f) {
        return std::any_of(faces.begin(), faces.end(), [&](Index g) { return interface.beyond(f, g); });
      }))
    return std::nullopt;
  // If one of the four vertices lies on a face of the others, it is a hanging node.
  for (const Index f : faces)
    for (const Contact& c : interface.nodes_on(f))
      if (std::binary_search(quad.vertices.begin(), quad.vertices.end(), c.vertex)) return std::nullopt;
  std::copy(faces.begin(), faces.end(), quad.faces.begin());
  return quad;
}

}  // namespace

Conformity find_conformity(const TetMesh& mesh, const Boundary& boundary, const FacesAtVertices& at,
                           const Intersections& found, const Near& near, const std::vector<Index>& covered) {
  Conformity result;
  result.contacts = found.contacts;
  const Interface interface(mesh, boundary, near, found.contacts);
  Gaps gaps{std::vector<Index>(boundary.faces.size(), -1)};

  // Crossed diagonals come first: where everything is tiny, hanging nodes may seem to lie on two of their
  // faces.
  const auto add_crossed = [&](Index s, Index t) {
    if (!gaps.free(s) || !gaps.free(t)) return;
    const auto quad = crossed(interface, at, gaps, s, t);
    if (!quad) return;
    result.crossed.push_back(*quad);
    gaps.add(quad->faces);
  };
  for (const auto& [s, t] : found.folds)
    if (interface.opposite(s, t)) add_crossed(s, t);
  for (const Index s : covered)
    for (Side side = 3 * s; side < 3 * s + 3; ++side)
      if (const Side mate = boundary.edges.mate[static_cast<std::size_t>(side)];
          mate != no_side && interface.overlap_between(s, mate / 3))
        add_crossed(s, mate / 3);
  std::sort(result.crossed.begin(), result.crossed.end(),
            [](const CrossedDiagonals& a, const CrossedDiagonals& b) { return a.vertices < b.vertices; });
  const Index crossed_gaps = gaps.count;

  find_covered_faces(interface, at, gaps);
  find_interfaces(interface, at, gaps);
  result.hanging = hanging_nodes(interface, at, gaps);

  result.cause_of_gap.assign(static_cast<std::size_t>(gaps.count),
                             Cause{Check::hanging_node, ~std::size_t{0}});
  for (std::size_t i = 0; i < result.crossed.size(); ++i)
    result.cause_of_gap[static_cast<std::size_t>(
        gaps.of_face[static_cast<std::size_t>(result.crossed[i].faces[0])])] = {Check::crossed_diagonal, i};
  for (std::size_t i = result.hanging.size(); i-- > 0;)
    for (const Index f : result.hanging[i].carriers)
      if (const Index gap = gaps.of_face[static_cast<std::size_t>(f)]; gap >= crossed_gaps)
        result.cause_of_gap[static_cast<std::size_t>(gap)] = {Check::hanging_node, i};
  if (gaps.count > 0) result.gap_of_face = std::move(gaps.of_face);
  return result;
}

std::optional<Cause> Conformity::cause_of_face(Index face) const {
  if (gap_of_face.empty() || gap_of_face[static_cast<std::size_t>(face)] < 0) return std::nullopt;
  return cause_of_gap[static_cast<std::size_t>(gap_of_face[static_cast<std::size_t>(face)])];
}

std::optional<Cause> Conformity::cause_of_pair(const Boundary& boundary, Index s, Index t) const {
  for (const auto& [one, other] : {std::pair{s, t}, {t, s}})
    for (const Index v : boundary.triangles[static_cast<std::size_t>(one)]) {
      const auto node = std::lower_bound(hanging.begin(), hanging.end(), v,
                                         [](const HangingNode& n, Index w) { return n.vertex < w; });
      if (node != hanging.end() && node->vertex == v &&
          std::binary_search(contacts.begin(), contacts.end(), Contact{v, other}))
        return Cause{Check::hanging_node, static_cast<std::size_t>(node - hanging.begin())};
    }
  if (gap_of_face.empty()) return std::nullopt;
  const Index gap = gap_of_face[static_cast<std::size_t>(s)];
  return gap >= 0 && gap == gap_of_face[static_cast<std::size_t>(t)] ? cause_of_face(s) : std::nullopt;
}

bool one_place(const Boundary& boundary, const FacesAtVertices& at, const Near& near, Index s, Index t) {
  const double short_edge = 1e3 * near.room(s, t);
  constexpr std::size_t most = 200;
  const Triangle &first = boundary.triangles[static_cast<std::size_t>(s)],
                 &second = boundary.triangles[static_cast<std::size_t>(t)];
  const auto close = [&](Index v) {
    return near.to_triangle(v, s) <= short_edge && near.to_triangle(v, t) <= short_edge;
  };
  std::vector<Index> reached;
  for (const Index v : first)
    if (close(v)) reached.push_back(v);
  for (std::size_t i = 0; i < reached.size() && reached.size() < most; ++i) {
    if (std::find(second.begin(), second.end(), reached[i]) != second.end()) return true;
    for (const Index f : at[reached[i]])
      for (const Index v : boundary.triangles[static_cast<std::size_t>(f)])
        if (std::find(reached.begin(), reached.end(), v) == reached.end() && close(v)) reached.push_back(v);
  }
  return false;
}

}  // namespace tetproof::verify
