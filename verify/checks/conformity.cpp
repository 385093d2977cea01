// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/checks/conformity.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace tetproof::verify {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// The boundary with the nodes that lie on its faces.
class Interface {
 public:
  Interface(const TetMesh& mesh, const Boundary& boundary, const Near& near, std::vector<Contact> contacts)
      : mesh_(mesh), boundary_(boundary), near_(near), by_triangle_(std::move(contacts)) {
    std::sort(by_triangle_.begin(), by_triangle_.end(), [](const Contact& a, const Contact& b) {
      return a.triangle != b.triangle ? a.triangle < b.triangle : a.vertex < b.vertex;
    });
  }

  const Triangle& triangle(Index f) const { return boundary_.triangles[static_cast<std::size_t>(f)]; }
  const std::vector<Contact>& contacts() const { return by_triangle_; }

  std::span<const Contact> nodes_on(Index f) const {
    const auto [first, last] =
        std::equal_range(by_triangle_.begin(), by_triangle_.end(), Contact{0, f},
                         [](const Contact& a, const Contact& b) { return a.triangle < b.triangle; });
    return {first, last};
  }

  // Whether the tetrahedron of face g reaches to the outer side of face f, exactly.
  bool beyond(Index f, Index g) const {
    const FaceId face = boundary_.faces[static_cast<std::size_t>(g)];
    return side(f, mesh_.tets[face >> 2][face & 3]) == CGAL::POSITIVE;
  }

  // Each face's tetrahedron lies on the outer side of the other face.
  bool opposite(Index f, Index g) const { return beyond(f, g) && beyond(g, f); }

  // Of two faces with a common edge: they are of two tetrahedra, and bend outwards.
  bool overlap_between(Index f, Index g) const {
    if (tet_of(boundary_.faces[static_cast<std::size_t>(f)]) ==
        tet_of(boundary_.faces[static_cast<std::size_t>(g)]))
      return false;
    const Triangle& t = triangle(f);
    for (const Index v : triangle(g))
      if (std::find(t.begin(), t.end(), v) == t.end()) return side(f, v) == CGAL::NEGATIVE;
    return false;
  }

  // Whether face g has its vertices among face f's and the nodes on it.
  bool within(Index g, Index f) const {
    const auto nodes = nodes_on(f);
    const Triangle& t = triangle(f);
    return std::all_of(triangle(g).begin(), triangle(g).end(), [&](Index v) {
      return std::find(t.begin(), t.end(), v) != t.end() ||
             std::any_of(nodes.begin(), nodes.end(), [&](const Contact& c) { return c.vertex == v; });
    });
  }

  bool coplanar(Index g, Index f) const {
    return std::all_of(triangle(g).begin(), triangle(g).end(),
                       [&](Index v) { return near_.to_plane(v, triangle(f)) <= near_.limit(); });
  }

  // The faces cancel: cut at the nodes on them, every edge is run as often in the one direction as in the
  // other.
  bool closes(std::span<const Index> faces) const {
    std::map<std::pair<Index, Index>, int> runs;
    const auto run = [&](Index a, Index b) {
      if (a < b)
        ++runs[{a, b}];
      else
        --runs[{b, a}];
    };
    for (const Index f : faces)
      for (int k = 0; k < 3; ++k) {
        const Index a = triangle(f)[k], b = triangle(f)[(k + 1) % 3];
        std::vector<std::pair<double, Index>> on_edge;
        for (const Contact& c : nodes_on(f))
          if (near_.to_segment(c.vertex, a, b) <= near_.limit())
            on_edge.emplace_back(near_.along(c.vertex, a, b), c.vertex);
        std::sort(on_edge.begin(), on_edge.end());
        Index last = a;
        for (const auto& [share, v] : on_edge) run(std::exchange(last, v), v);
        run(last, b);
      }
    return std::all_of(runs.begin(), runs.end(), [](const auto& entry) { return entry.second == 0; });
  }

 private:
  CGAL::Orientation side(Index f, Index v) const {
    const auto point = [&](Index w) {
      const Eigen::Vector3d& p = mesh_.points[static_cast<std::size_t>(w)];
      return Kernel::Point_3(p.x(), p.y(), p.z());
    };
    const auto& [a, b, c] = triangle(f);
    return CGAL::orientation(point(a), point(b), point(c), point(v));
  }

  const TetMesh& mesh_;
  const Boundary& boundary_;
  const Near& near_;
  std::vector<Contact> by_triangle_;
};

// Gaps in the making: each a set of faces that have no other gap yet.
struct Gaps {
  std::vector<Index> of_face;
  Index count = 0;

  bool free(Index f) const { return of_face[static_cast<std::size_t>(f)] < 0; }
  void add(std::span<const Index> faces) {
    for (const Index f : faces) of_face[static_cast<std::size_t>(f)] = count;
    ++count;
  }
};

// One face that others cover from its other side.
void find_covered_faces(const Interface& interface, const FacesAtVertices& at, Gaps& gaps) {
  const auto& contacts = interface.contacts();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Index f = contacts[i].triangle;
    if ((i > 0 && contacts[i - 1].triangle == f) || !gaps.free(f)) continue;
    std::vector<Index> faces{f};
    for (const Contact& c : interface.nodes_on(f))
      for (const Index g : at[c.vertex])
        if (gaps.free(g) && interface.within(g, f) && interface.opposite(f, g)) faces.push_back(g);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    if (faces.size() > 1 && interface.closes(faces)) gaps.add(faces);
  }
}

// Several faces on either side, none of which others cover alone.
void find_interfaces(const Interface& interface, const FacesAtVertices& at, Gaps& gaps) {
  std::vector<std::pair<Index, Index>> links;
  for (const Contact& c : interface.contacts())
    for (const Index g : at[c.vertex])
      if (gaps.free(c.triangle) && gaps.free(g) && interface.opposite(c.triangle, g) &&
          interface.coplanar(g, c.triangle))
        links.emplace_back(c.triangle, g);
  std::map<Index, Index> parent;
  const auto find = [&](Index f) {
    Index root = parent.try_emplace(f, f).first->second;
    while (root != parent.at(root)) root = parent.at(root);
    for (Index i = f; i != root;) i = std::exchange(parent.at(i), root);
    return root;
  };
  for (const auto& [f, g] : links) {
    const auto [low, high] = std::minmax({find(f), find(g)});
    parent.at(high) = low;
  }
  std::map<Index, std::vector<Index>> clusters;
  for (const auto& [f, up] : parent) clusters[f].clear();
  for (auto& [f, faces] : clusters) clusters.at(find(f)).push_back(f);
  for (const auto& [root, faces] : clusters)
    if (faces.size() > 1 && interface.closes(faces)) gaps.add(faces);
}

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

// The four faces on the vertices of two with a common edge, if there are just four.
std::optional<CrossedDiagonals> crossed(const Interface& interface, const FacesAtVertices& at,
                                        const Gaps& gaps, Index s, Index t) {
  CrossedDiagonals quad{};
  std::array<Index, 6> all;
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
  // Not so the outside of a tetrahedron that is cut into four and lies inside the mesh: nothing of it reaches
  // beyond it.
  if (std::none_of(faces.begin(), faces.end(), [&](Index f) {
        return std::any_of(faces.begin(), faces.end(), [&](Index g) { return interface.beyond(f, g); });
      }))
    return std::nullopt;
  // Where one of the four lies on a face of the others it hangs.
  for (const Index f : faces)
    for (const Contact& c : interface.nodes_on(f))
      if (std::binary_search(quad.vertices.begin(), quad.vertices.end(), c.vertex)) return std::nullopt;
  std::copy(faces.begin(), faces.end(), quad.faces.begin());
  return quad;
}

}  // namespace

FacesAtVertices::FacesAtVertices(const Boundary& boundary, std::size_t points)
    : start_(points + 1, 0), faces_(3 * boundary.faces.size()) {
  const auto triangles = boundary.boundary_triangles();
  for (const Triangle& t : triangles)
    for (const Index v : t) ++start_[static_cast<std::size_t>(v) + 1];
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  std::vector<Index> place(start_.begin(), start_.end() - 1);
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (const Index v : triangles[f]) faces_[place[v]++] = static_cast<Index>(f);
}

Conformity find_conformity(const TetMesh& mesh, const Boundary& boundary, const FacesAtVertices& at,
                           const Intersections& found, const Near& near, const std::vector<Index>& covered) {
  Conformity result;
  result.contacts = found.contacts;
  const Interface interface(mesh, boundary, near, found.contacts);
  Gaps gaps{std::vector<Index>(boundary.faces.size(), -1)};

  // Crossed diagonals first: two of their four faces may also be nodes' carriers where all is tiny.
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
  const double short_edge = 1e3 * near.limit();
  constexpr std::size_t most = 200;
  const Triangle &first = boundary.triangles[static_cast<std::size_t>(s)],
                 &second = boundary.triangles[static_cast<std::size_t>(t)];
  const auto close = [&](Index v) {
    return near.to_triangle(v, first) <= short_edge && near.to_triangle(v, second) <= short_edge;
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
