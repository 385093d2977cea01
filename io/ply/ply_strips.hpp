// SPDX-License-Identifier: GPL-3.0-or-later
// Strips of triangles, as scanners write them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tetproof::io {

/// The triangles of a strip: corners 1 2 3, then 3 2 4, and so on; -1 ends a strip and starts the next. Two
/// equal corners only turn the strip, and make no triangle.
inline std::vector<std::array<std::int64_t, 3>> triangles_of_strip(const std::vector<std::int64_t>& strip) {
  std::vector<std::array<std::int64_t, 3>> triangles;
  std::size_t start = 0;
  for (std::size_t k = 0; k < strip.size(); ++k) {
    if (strip[k] == -1) start = k + 1;
    if (k < start + 2) continue;
    const bool turned = (k - start) % 2 == 1;
    const std::int64_t a = strip[turned ? k - 1 : k - 2], b = strip[turned ? k - 2 : k - 1], c = strip[k];
    if (a != b && b != c && c != a) triangles.push_back({a, b, c});
  }
  return triangles;
}

}  // namespace tetproof::io
