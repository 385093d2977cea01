// SPDX-License-Identifier: GPL-3.0-or-later
// Random closed surfaces for properties that must hold on all of them.
#pragma once

#include <cstdint>
#include <string>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// A closed, 2-manifold, consistently oriented surface without self-intersections, of some ten to a thousand
/// triangles and a size of about 1 to 10, the same on every machine for the same seed. By the seed: a
/// star-shaped body; one with a cavity, perhaps a body within; several bodies side by side; columns of unit
/// cells or an octahedron whose planes, edges and vertices have integer or half-integer coordinates, as a
/// lattice has. One in eight is oriented inward. No parametric definition.
TriangleSurface random_closed_surface(std::uint64_t seed);

/// What that surface is, in one line.
std::string describe_random_surface(std::uint64_t seed);

}  // namespace tetproof::corpus
