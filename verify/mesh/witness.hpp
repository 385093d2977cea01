// SPDX-License-Identifier: GPL-3.0-or-later
// A rational point inside two tetrahedra: the proof that they overlap. Internal.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <string>

#include "io/tet_mesh.hpp"

namespace tetproof::verify {

struct Witness {
  Eigen::Vector3d point;             ///< [length], rounded
  std::array<std::string, 3> exact;  ///< rationals "n/d" in lowest terms
};

/// A point strictly inside both tetrahedra; nothing if they have no volume in common. Either orientation is
/// allowed. Exact: the point is a mean of corners of the common part, or the nearest point with double
/// coordinates if that is also inside both.
std::optional<Witness> common_point(std::span<const Eigen::Vector3d> points, const std::array<Index, 4>& one,
                                    const std::array<Index, 4>& other);

}  // namespace tetproof::verify
