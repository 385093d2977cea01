// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates with few decimals. Internal.
#pragma once

#include <cstdint>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// The decimals that the shortest decimal number with the value of `x` has: 2 for 0.25, -3 for 5000. 0 has
/// none: the lowest int.
int decimals_of(double x);
/// `x` rounded to a multiple of 10^-decimals, as the double nearest to that; `x` where that is not finite.
/// Never -0.
double rounded(double x, int decimals);

/// The decimals at which rounding would leave little of a surface: a unit is about its size.
int coarsest_decimals(const TriangleSurface& surface);
/// The sum over all coordinates of their decimals beyond `coarsest`.
std::int64_t decimals_beyond(const TriangleSurface& surface, int coarsest);
/// The largest number of decimals of a coordinate, at least `coarsest`.
int most_decimals(const TriangleSurface& surface, int coarsest);

}  // namespace tetproof::corpus
