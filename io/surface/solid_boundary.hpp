// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of the solids that the facets of a TetGen input enclose.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::io {

/// Triangles of a surface that separate solids from what is empty, wound outwards.
struct SolidBoundary {
  std::vector<std::array<Index, 3>> triangles;
  std::vector<std::size_t> from;  ///< which of the given triangles each is
  std::size_t turned = 0;         ///< how many of them were wound inwards
};

/// TetGen gives the direction of a facet no meaning, and lets facets stand inside of solids, as between two
/// regions. The triangles cut space into cells; the outermost one is empty, and so is each that has a point
/// of `holes`; all others are solid. A triangle stays if it has a solid on one side and none on the other.
///
/// Decisions are exact. Nothing where the triangles are the surface of one solid already, and where this
/// makes no closed surface, because the triangles are open, cross each other or are degenerate.
std::optional<SolidBoundary> solid_boundary(const std::vector<Eigen::Vector3d>& points,
                                            const std::vector<std::array<Index, 3>>& triangles,
                                            std::span<const Eigen::Vector3d> holes);

/// Whether the triangles are the boundary of the solids as they are: all of it, and wound outwards.
bool are_solid_boundary(const std::vector<Eigen::Vector3d>& points,
                        const std::vector<std::array<Index, 3>>& triangles,
                        std::span<const Eigen::Vector3d> holes);

}  // namespace tetproof::io
