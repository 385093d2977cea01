// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/mesh/parts.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <utility>

#include "verify/triangles/disjoint_sets.hpp"

namespace tetproof::verify {

std::vector<Index> parts_of(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                            std::span<const std::array<FaceId, 2>> also) {
  std::vector<std::array<Index, 4>> faces;  // three vertices, ascending, and the tetrahedron
  faces.reserve(4 * mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (!excluded.empty() && excluded[t]) continue;
    for (FaceId f = 0; f < 4; ++f) {
      auto [a, b, c] = vertices_of(mesh, 4 * static_cast<FaceId>(t) + f);
      if (a > b) std::swap(a, b);
      if (b > c) std::swap(b, c);
      if (a > b) std::swap(a, b);
      faces.push_back({a, b, c, static_cast<Index>(t)});
    }
  }
  tbb::parallel_sort(faces.begin(), faces.end());

  DisjointSets sets(mesh.tets.size());
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (std::equal(faces[i].begin(), faces[i].begin() + 3, faces[i - 1].begin()))
      sets.unite(faces[i][3], faces[i - 1][3]);
  for (const auto& [one, other] : also) sets.unite(tet_of(one), tet_of(other));

  // A root is the lowest tetrahedron of its part.
  std::vector<Index> part(mesh.tets.size(), -1);
  Index parts = 0;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (!excluded.empty() && excluded[t]) continue;
    const Index root = sets.find(static_cast<Index>(t));
    part[t] = root == static_cast<Index>(t) ? parts++ : part[root];
  }
  return part;
}

}  // namespace tetproof::verify
