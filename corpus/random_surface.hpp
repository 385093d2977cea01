// SPDX-License-Identifier: GPL-3.0-or-later
// Random closed surfaces, for tests of properties that must hold on all surfaces.
#pragma once

#include <cstdint>
#include <string>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// A closed, 2-manifold, consistently oriented surface without self-intersections. It has about ten to a
/// thousand triangles and a size of about 1 to 10, and is the same on every machine for the same seed. The
/// seed chooses between: a star-shaped body; nested copies of one; several bodies side by side; and columns
/// of cells or an octahedron, whose coordinates are integers or half-integers, like those of a lattice. One
/// surface in eight is oriented inward. It has no parametric definition.
TriangleSurface random_closed_surface(std::uint64_t seed);

/// The description of the surface with this seed, in one line.
std::string describe_random_surface(std::uint64_t seed);

}  // namespace tetproof::corpus
