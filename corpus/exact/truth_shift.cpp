// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/exact/truth_shift.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "corpus/truth.hpp"

namespace tetproof::corpus {
namespace {

// Whether all tetrahedra are positive with vertex numbers lower by this.
bool all_positive(const TetMesh& mesh, Index lower) {
  const auto points = static_cast<Index>(mesh.points.size());
  const auto point = [&](Index v) -> const Eigen::Vector3d& {
    return mesh.points[static_cast<std::size_t>(v)];
  };
  return std::all_of(mesh.tets.begin(), mesh.tets.end(), [&](std::array<Index, 4> t) {
    for (Index& v : t) {
      v -= lower;
      if (v < 0 || v >= points || !point(v).allFinite()) return false;
    }
    return orientation(point(t[0]), point(t[1]), point(t[2]), point(t[3])) > 0;
  });
}

}  // namespace

Index shift_of(const TetMesh& mesh) {
  std::int64_t lowest = std::numeric_limits<Index>::max(), highest = std::numeric_limits<Index>::min();
  for (const auto& tet : mesh.tets)
    for (const Index v : tet) {
      lowest = std::min<std::int64_t>(lowest, v);
      highest = std::max<std::int64_t>(highest, v);
    }
  const auto points = static_cast<std::int64_t>(mesh.points.size());
  if (mesh.tets.empty() || highest - lowest >= points || all_positive(mesh, 0)) return 0;
  for (const std::int64_t lower : {lowest, highest - points + 1})
    if (lower != 0 && all_positive(mesh, static_cast<Index>(lower))) return static_cast<Index>(lower);
  return 0;
}

}  // namespace tetproof::corpus
