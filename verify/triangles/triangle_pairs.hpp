// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two triangles meet in more than their common vertices and edge, exactly. Internal.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "verify/triangles/edges.hpp"

namespace tetproof::verify {

/// 1 where a triangle's three vertices lie on a line, exactly tested; `count` of them.
struct Degenerate {
  std::vector<std::uint8_t> triangles;
  std::int64_t count = 0;
};
Degenerate degenerate_triangles(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles);

/// Whether two non-degenerate triangles meet in a point that is not on a common vertex or edge; vertices are
/// common when their numbers are equal (touching without a common number is meeting). Three common vertices:
/// always.
bool triangles_meet(std::span<const Eigen::Vector3d> points, const Triangle& a, const Triangle& b);

}  // namespace tetproof::verify
