// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces moved to the origin and scaled to a size of about 1. Internal.
#pragma once

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// The longest side of its box [length].
double size_of(const TriangleSurface& surface);

/// The surface with the corner of its box moved to the origin, if it is far from there for its size, and
/// scaled by a power of two to a size of about 1, if it is far larger or smaller.
TriangleSurface brought_near(const TriangleSurface& surface, bool move, bool scale);

}  // namespace tetproof::corpus
