// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/checks/interface.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace tetproof::verify {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

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

Interface::Interface(const TetMesh& mesh, const Boundary& boundary, const Near& near,
                     std::vector<Contact> contacts)
    : mesh_(mesh), boundary_(boundary), near_(near), by_triangle_(std::move(contacts)) {
  std::sort(by_triangle_.begin(), by_triangle_.end(), [](const Contact& a, const Contact& b) {
    return a.triangle != b.triangle ? a.triangle < b.triangle : a.vertex < b.vertex;
  });
}

std::span<const Contact> Interface::nodes_on(Index f) const {
  const auto [first, last] =
      std::equal_range(by_triangle_.begin(), by_triangle_.end(), Contact{0, f},
                       [](const Contact& a, const Contact& b) { return a.triangle < b.triangle; });
  return {first, last};
}

bool Interface::beyond(Index f, Index g) const {
  const FaceId face = boundary_.faces[static_cast<std::size_t>(g)];
  return side(f, mesh_.tets[face >> 2][face & 3]) > 0;
}

bool Interface::overlap_between(Index f, Index g) const {
  if (tet_of(boundary_.faces[static_cast<std::size_t>(f)]) ==
      tet_of(boundary_.faces[static_cast<std::size_t>(g)]))
    return false;
  const Triangle& t = triangle(f);
  for (const Index v : triangle(g))
    if (std::find(t.begin(), t.end(), v) == t.end()) return side(f, v) < 0;
  return false;
}

bool Interface::within(Index g, Index f) const {
  const auto nodes = nodes_on(f);
  const Triangle& t = triangle(f);
  return std::all_of(triangle(g).begin(), triangle(g).end(), [&](Index v) {
    return std::find(t.begin(), t.end(), v) != t.end() ||
           std::binary_search(nodes.begin(), nodes.end(), Contact{v, f});
  });
}

bool Interface::coplanar(Index g, Index f) const {
  return std::all_of(triangle(g).begin(), triangle(g).end(), [&](Index v) { return near_.on_plane(v, f); });
}

bool Interface::closes(std::span<const Index> faces) const {
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
        if (near_.on_edge(c.vertex, a, b, f)) on_edge.emplace_back(near_.along(c.vertex, a, b), c.vertex);
      std::sort(on_edge.begin(), on_edge.end());
      Index last = a;
      for (const auto& [share, v] : on_edge) run(std::exchange(last, v), v);
      run(last, b);
    }
  return std::all_of(runs.begin(), runs.end(), [](const auto& entry) { return entry.second == 0; });
}

int Interface::side(Index f, Index v) const {
  const auto point = [&](Index w) {
    const Eigen::Vector3d& p = mesh_.points[static_cast<std::size_t>(w)];
    return Kernel::Point_3(p.x(), p.y(), p.z());
  };
  const auto& [a, b, c] = triangle(f);
  return static_cast<int>(CGAL::orientation(point(a), point(b), point(c), point(v)));
}

}  // namespace tetproof::verify
