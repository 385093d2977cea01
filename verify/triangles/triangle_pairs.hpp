// SPDX-License-Identifier: GPL-3.0-or-later
// Exact test for two triangles that meet in more than their common vertices and edge. Internal.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "verify/triangles/edges.hpp"

namespace tetproof::verify {

/// The triangles whose three vertices lie on a line, tested exactly.
struct Degenerate {
  std::vector<std::uint8_t> triangles;  ///< 1 for a degenerate triangle, else 0
  std::int64_t count = 0;
};
Degenerate degenerate_triangles(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles);

/// Whether two non-degenerate triangles meet in a point outside their common vertices and edge. Vertices are
/// common if their numbers are equal, so triangles that touch without a common number do meet. Triangles with
/// three common vertices always meet.
bool triangles_meet(std::span<const Eigen::Vector3d> points, const Triangle& a, const Triangle& b);

}  // namespace tetproof::verify
