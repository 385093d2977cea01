// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes multiplied by powers of two, which changes no digit.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "io/tet_mesh.hpp"

namespace tetproof::test {

/// The mesh times 2^power along each axis; nothing if a coordinate would lose a digit or leave the doubles.
inline std::optional<TetMesh> scaled(TetMesh mesh, const std::array<int, 3>& power) {
  for (Eigen::Vector3d& p : mesh.points)
    for (int k = 0; k < 3; ++k) {
      const double before = p[k];
      p[k] = std::ldexp(before, power[static_cast<std::size_t>(k)]);
      if (std::isfinite(before) &&
          (!std::isfinite(p[k]) || std::ldexp(p[k], -power[static_cast<std::size_t>(k)]) != before))
        return std::nullopt;
    }
  return mesh;
}

}  // namespace tetproof::test
