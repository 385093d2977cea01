// SPDX-License-Identifier: GPL-3.0-or-later
// Shortens the coordinates of a surface. Internal.
#pragma once

#include "corpus/shrink/certified_test.hpp"

namespace tetproof::corpus {

/// Moves the surface to the origin and scales it to a size of about 1, then rounds all coordinates to as few
/// decimals, then those of each vertex and long ones by themselves to fewer, as the surface still fails.
/// Returns whether it changed.
bool shorten_coordinates(CertifiedTest& test, TriangleSurface& surface);

}  // namespace tetproof::corpus
