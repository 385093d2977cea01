// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/fuzz/revolved.hpp"

#include "corpus/generators/turns.hpp"

namespace tetproof::corpus {

TriangleSurface revolved(const std::vector<Ring>& rings, int n, const End& bottom, const End& top) {
  TriangleSurface surface;
  for (const Ring& ring : rings)
    for (int i = 0; i < n; ++i) {
      const CosSin at = cos_sin_turns(static_cast<double>(i) / n + ring.turned);
      surface.vertices.emplace_back(ring.radius * at.cos, ring.radius * at.sin, ring.z);
    }
  for (Index k = 0; k + 1 < static_cast<Index>(rings.size()); ++k)
    for (Index i = 0; i < n; ++i) {
      const Index a = k * n + i, b = k * n + (i + 1) % n;
      surface.triangles.push_back({a, b, b + n});
      surface.triangles.push_back({a, b + n, a + n});
    }
  const auto close = [&](const End& end, Index first, bool upward) {
    Index hub = first;
    if (end.apex) {
      hub = static_cast<Index>(surface.vertices.size());
      surface.vertices.emplace_back(0, 0, *end.apex);
    }
    for (Index i = end.apex ? 0 : 1; i < (end.apex ? n : n - 1); ++i) {
      const Index a = first + i, b = first + (i + 1) % n;
      surface.triangles.push_back(upward ? std::array<Index, 3>{hub, a, b} : std::array<Index, 3>{hub, b, a});
    }
  };
  close(bottom, 0, false);
  close(top, static_cast<Index>(rings.size() - 1) * n, true);
  return surface;
}

}  // namespace tetproof::corpus
