// SPDX-License-Identifier: GPL-3.0-or-later
// Shrinks a surface by edge collapses. Internal.
#pragma once

#include <cstdint>

#include "corpus/shrink/certified_test.hpp"

namespace tetproof::corpus {

/// Collapses edges as long as the surface still fails: many independent ones at once, then fewer, in the end
/// one by one, each to either end or its midpoint, until none is left that can go. Returns the number of
/// collapses.
std::int64_t collapse_edges(CertifiedTest& test, TriangleSurface& surface, std::uint64_t seed);

}  // namespace tetproof::corpus
