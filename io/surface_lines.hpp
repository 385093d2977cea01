// SPDX-License-Identifier: GPL-3.0-or-later
// Points and triangles as lines of text, exact, for the formats that list them so.
#pragma once

#include <string_view>

#include "io/text_output.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::io {

/// One line a point: `start` and three coordinates.
inline void write_points(AtomicFile& file, std::string_view start,
                         const std::vector<Eigen::Vector3d>& points) {
  write_items(file, points.size(), start.size() + 3 * (longest_real + 1), [&](std::size_t i, char* to) {
    to = std::copy(start.begin(), start.end(), to);
    for (int k = 0; k < 3; ++k) to = put(put(to, points[i][k]), k < 2 ? ' ' : '\n');
    return to;
  });
}

/// One line a triangle: `start` and three vertices, the first of which is called `first`.
inline void write_triangles(AtomicFile& file, std::string_view start,
                            const std::vector<std::array<Index, 3>>& triangles, std::int64_t first) {
  write_items(file, triangles.size(), start.size() + 3 * (longest_integer + 1), [&](std::size_t i, char* to) {
    to = std::copy(start.begin(), start.end(), to);
    for (int k = 0; k < 3; ++k) to = put(put(to, triangles[i][k] + first), k < 2 ? ' ' : '\n');
    return to;
  });
}

}  // namespace tetproof::io
