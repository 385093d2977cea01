// SPDX-License-Identifier: GPL-3.0-or-later
// A triangulated surface as plain arrays, with an optional parametric definition.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof {

/// A triangulated surface. Outward orientation: (b-a) x (c-a) points out of the solid. There are no promises:
/// `verify/surface.hpp` judges whether it is closed, manifold, oriented and free of self-intersections.
struct TriangleSurface {
  std::vector<Eigen::Vector3d> vertices;        ///< coordinates [length]; the paper's x_1 .. x_n
  std::vector<std::array<Index, 3>> triangles;  ///< three positions in `vertices` each

  /// The parametric definition, if the surface has one (reading D12): (u,v) at each corner of each triangle,
  /// so that seams and poles are unambiguous, and the evaluator. Otherwise both are empty.
  std::vector<std::array<Eigen::Vector2d, 3>> parameters;
  std::function<Eigen::Vector3d(const Eigen::Vector2d&)> evaluate;
};

}  // namespace tetproof
