// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/mesh/tets_at.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <numeric>

#include "verify/triangles/chunks.hpp"

namespace tetproof::verify {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 cgal(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

bool contains(const std::array<Eigen::Vector3d, 4>& corners, const Eigen::Vector3d& p) {
  const std::array<Kernel::Point_3, 4> c{cgal(corners[0]), cgal(corners[1]), cgal(corners[2]),
                                         cgal(corners[3])};
  const CGAL::Orientation whole = CGAL::orientation(c[0], c[1], c[2], c[3]);
  if (whole == CGAL::COPLANAR) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Kernel::Point_3, 4> with = c;
    with[i] = cgal(p);
    if (CGAL::orientation(with[0], with[1], with[2], with[3]) == -whole) return false;
  }
  return true;
}

}  // namespace

std::vector<std::vector<Index>> tets_at(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                                        std::span<const Eigen::Vector3d> points) {
  std::vector<std::vector<Index>> result(points.size());
  std::vector<std::size_t> order(points.size());  // by x
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return points[a].x() < points[b].x(); });
  struct Hit {
    std::size_t point;
    Index tet;
  };
  const auto hits = collect_in_order<Hit>(
      points.empty() ? 0 : mesh.tets.size(), 16384,
      [&](std::size_t begin, std::size_t end, std::vector<Hit>& found) {
        for (std::size_t t = begin; t < end; ++t) {
          if (!excluded.empty() && excluded[t]) continue;
          std::array<Eigen::Vector3d, 4> corners;
          for (int i = 0; i < 4; ++i) corners[i] = mesh.points[static_cast<std::size_t>(mesh.tets[t][i])];
          const Eigen::Vector3d low =
                                    corners[0].cwiseMin(corners[1]).cwiseMin(corners[2].cwiseMin(corners[3])),
                                high =
                                    corners[0].cwiseMax(corners[1]).cwiseMax(corners[2].cwiseMax(corners[3]));
          for (auto at = std::partition_point(order.begin(), order.end(),
                                              [&](std::size_t i) { return points[i].x() < low.x(); });
               at != order.end() && points[*at].x() <= high.x(); ++at) {
            const Eigen::Vector3d& p = points[*at];
            if ((p.array() < low.array()).any() || (p.array() > high.array()).any()) continue;
            if (contains(corners, p)) found.push_back({*at, static_cast<Index>(t)});
          }
        }
      });
  for (const Hit& hit : hits) result[hit.point].push_back(hit.tet);
  return result;
}

}  // namespace tetproof::verify
