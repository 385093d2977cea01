// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a surface that can be cut out, and the caps that close the holes. Internal.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// Some triangles of a surface, ascending.
using Patch = std::vector<Index>;

/// The surface with a cap of least area, without new vertices, on each border of the patch in place of the
/// patch. Nothing if a border touches itself or another or has more than 200 vertices, if a cap would need an
/// edge that the rest has, or if the caps have as many triangles as the patch. Whether the caps meet anything
/// is left to be judged.
std::optional<TriangleSurface> replace_patch(const TriangleSurface& surface, const Patch& patch);

/// All triangles with a vertex fewer than `radius` edges from a centre, for some centres and some radii of 2
/// and more: the largest first.
std::vector<Patch> balls(const TriangleSurface& surface, std::uint64_t seed);
/// The triangles around each vertex that has six or more. (With fewer, every cap is what an edge collapse
/// leaves.)
std::vector<Patch> stars(const TriangleSurface& surface);
/// Rings of triangles around a handle or through a tunnel, short ones first, at most 60: the 8 shortest of 24
/// places. Cutting one out and capping it lowers the genus. Empty if the surface has no handles.
std::vector<Patch> handle_rings(const TriangleSurface& surface, std::uint64_t seed);

}  // namespace tetproof::corpus
