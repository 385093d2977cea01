// SPDX-License-Identifier: GPL-3.0-or-later
// The connected parts of a surface, and which of them can be removed together. Internal.
#pragma once

#include <cstdint>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// The parts of a valid surface.
struct Parts {
  std::vector<Index> of_triangle;  ///< the part of each triangle
  /// Sets of parts. Any of `solids` can be removed together, and then any of `cavities`, and what is left
  /// stays inside as many others or an even number fewer, so that solid stays solid: a solid with the walls
  /// of its cavities; a cavity's wall with the solids in it.
  std::vector<std::vector<Index>> solids, cavities;
};
Parts find_parts(const TriangleSurface& surface);

/// The surface without the triangles of the marked parts, and without unused vertices.
TriangleSurface without_parts(const TriangleSurface& surface, const Parts& parts,
                              const std::vector<std::uint8_t>& removed);

}  // namespace tetproof::corpus
