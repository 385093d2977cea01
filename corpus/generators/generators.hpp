// SPDX-License-Identifier: GPL-3.0-or-later
// The list of all generators. A new one is declared here and added to the list in corpus/surfaces.cpp.
#pragma once

#include <vector>

#include "corpus/generators/spec.hpp"

namespace tetproof::corpus {

Generator sphere_generator();               // sphere.cpp
Generator torus_generator();                // torus.cpp
Generator wing_generator();                 // wing.cpp
Generator random_generator();               // random_star.cpp
Generator shells_generator();               // shells.cpp
Generator octahedron_generator();           // octahedron.cpp
std::vector<Generator> block_generators();  // blocks.cpp

/// All generators, in the order in which users see them.
const std::vector<Generator>& generators();

/// A specification that asks for more triangles is refused: with (u,v) they would need more than about 2 GB.
inline constexpr double most_triangles = 2e7;

}  // namespace tetproof::corpus
