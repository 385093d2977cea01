// SPDX-License-Identifier: GPL-3.0-or-later
// The generators that the library has, by the file they stand in.
#pragma once

#include <vector>

#include "corpus/generators/spec.hpp"

namespace tetproof::corpus {

Generator sphere_generator();  // sphere.cpp
Generator torus_generator();   // torus.cpp
Generator wing_generator();
Generator random_generator();  // random_star.cpp
Generator shells_generator();
Generator octahedron_generator();
std::vector<Generator> block_generators();

/// All of them, in the order of the list that users see.
const std::vector<Generator>& generators();

inline constexpr double most_triangles =
    2e7;  ///< about 2 GB with parameters; beyond it a specification is refused

}  // namespace tetproof::corpus
