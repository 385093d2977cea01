// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/mesh/orientation.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "verify/triangles/chunks.hpp"

namespace tetproof::verify {

Orientations orientations(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto point = [&](Index i) {
    const Eigen::Vector3d& p = mesh.points[static_cast<std::size_t>(i)];
    return Kernel::Point_3(p.x(), p.y(), p.z());
  };
  // A flat tetrahedron t is collected as 2 t, and a negative one as 2 t + 1.
  const auto found = collect_in_order<std::int64_t>(
      mesh.tets.size(), 16384, [&](std::size_t begin, std::size_t end, std::vector<std::int64_t>& bad) {
        for (std::size_t t = begin; t < end; ++t) {
          if (!excluded.empty() && excluded[t]) continue;
          const auto& [a, b, c, d] = mesh.tets[t];
          const CGAL::Orientation sign = CGAL::orientation(point(a), point(b), point(c), point(d));
          if (sign != CGAL::POSITIVE)
            bad.push_back(static_cast<std::int64_t>(2 * t) + (sign == CGAL::NEGATIVE));
        }
      });
  Orientations result;
  for (const std::int64_t bad : found)
    (bad % 2 ? result.negative : result.flat).push_back(static_cast<Index>(bad / 2));
  return result;
}

}  // namespace tetproof::verify
