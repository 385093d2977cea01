// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/mesh/regions.hpp"

#include <algorithm>
#include <utility>

#include "verify/mesh/faces.hpp"
#include "verify/mesh/mesh_volumes.hpp"

namespace tetproof::verify {

std::vector<RegionAccount> account_of_regions(const TetMesh& mesh, const std::vector<std::int64_t>& regions,
                                              const std::vector<std::uint8_t>& excluded) {
  std::vector<std::pair<std::int64_t, Index>> tets;  // region, tetrahedron
  tets.reserve(regions.size());
  for (std::size_t t = 0; t < regions.size(); ++t)
    if (excluded.empty() || !excluded[t]) tets.emplace_back(regions[t], static_cast<Index>(t));
  std::sort(tets.begin(), tets.end());
  std::vector<RegionAccount> accounts;
  if (tets.empty() || tets.front().first == tets.back().first) return accounts;

  std::vector<Index> place(mesh.points.size(), -1);  // of a point in the current region; -1: not in it
  for (std::size_t first = 0, last; first < tets.size(); first = last) {
    TetMesh part;
    std::vector<Index> used;
    for (last = first; last < tets.size() && tets[last].first == tets[first].first; ++last) {
      std::array<Index, 4> tet = mesh.tets[static_cast<std::size_t>(tets[last].second)];
      for (Index& v : tet) {
        if (place[v] < 0) {
          place[v] = static_cast<Index>(part.points.size());
          part.points.push_back(mesh.points[v]);
          used.push_back(v);
        }
        v = place[v];
      }
      part.tets.push_back(tet);
    }
    for (const Index v : used) place[v] = -1;
    const Boundary boundary = find_boundary(part, {}, match_faces(part, {}));
    RegionAccount account{{.tag = tets[first].first}, shape_of(boundary, mesh_volumes(part, boundary))};
    account.shape.points = static_cast<std::int64_t>(part.points.size());
    account.shape.tets = static_cast<std::int64_t>(part.tets.size());
    accounts.push_back(std::move(account));
  }
  return accounts;
}

}  // namespace tetproof::verify
