// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/figure/near_part.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

namespace tetproof::reference {
namespace {

// A vertex of the surface, as (i, i), or the point where the plane meets an edge, as (low, high).
using Node = std::pair<Index, Index>;

}  // namespace

std::vector<std::vector<Eigen::Vector3d>> near_part_outline(const TriangleSurface& surface,
                                                            const Plane& plane, const Eigen::Vector3d& view) {
  const PlaneSides sides(surface.vertices, plane);
  const double unit = unit_of(surface.vertices);
  // How often each directed edge occurs more than its opposite: edges inside the part cancel. The border that
  // is left winds around each point as often as the triangles cover it.
  std::map<std::pair<Node, Node>, int> border;
  for (const auto& triangle : surface.triangles) {
    const auto& [a, b, c] = triangle;
    const Eigen::Vector3d pa = surface.vertices[a] / unit, pb = surface.vertices[b] / unit,
                          pc = surface.vertices[c] / unit;
    if (!((pb - pa).cross(pc - pa).dot(view) > 0)) continue;
    if (sides[a] <= 0 && sides[b] <= 0 && sides[c] <= 0) continue;
    std::vector<Node> part;
    for (int i = 0; i < 3; ++i) {
      const Index p = triangle[i], q = triangle[(i + 1) % 3];
      if (sides[p] >= 0) part.emplace_back(p, p);
      if (sides[p] * sides[q] < 0) part.emplace_back(std::minmax(p, q));
    }
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Node &p = part[i], &q = part[(i + 1) % part.size()];
      if (p < q)
        ++border[{p, q}];
      else
        --border[{q, p}];
    }
  }

  std::map<Node, std::vector<Node>> next;  // as many lines leave a node as reach it
  for (const auto& [edge, count] : border)
    for (int k = 0; k < std::abs(count); ++k)
      if (count > 0)
        next[edge.first].push_back(edge.second);
      else
        next[edge.second].push_back(edge.first);
  std::vector<std::vector<Eigen::Vector3d>> lines;
  for (auto& [start, out] : next)
    while (!out.empty()) {
      std::vector<Eigen::Vector3d> line;
      Node at = start;
      do {
        line.push_back(at.first == at.second ? surface.vertices[at.first]
                                             : sides.crossing(at.first, at.second));
        std::vector<Node>& ways = next[at];
        at = ways.back();
        ways.pop_back();
      } while (at != start);
      lines.push_back(std::move(line));
    }
  return lines;
}

}  // namespace tetproof::reference
