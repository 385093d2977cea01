// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a closed surface smaller while something about it stays true.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// Whether the candidate still shows what is looked for. It is called by up to `threads` threads at once.
using StillFails = std::function<bool(const TriangleSurface&)>;

struct ShrinkOptions {
  double seconds = 120;    ///< wall time; calls that are under way when it is over still end
  int threads = 0;         ///< calls of the test at once; 0: one for each core
  std::uint64_t seed = 1;  ///< of the order in which edges are tried
};

struct ShrinkResult {
  TriangleSurface surface;
  std::int64_t calls = 0;  ///< of the test, with those that ran in vain beside another and the last one
  double seconds = 0;
  bool finished = true;   ///< false: the time was over before nothing more of what is tried could be removed
  bool confirmed = true;  ///< the result failed once more at the end; false: the test is not deterministic
  std::string steps;      ///< "2 parts removed, 1 handle cut, 57 edges collapsed, coordinates to 3 decimals"
};

/// Shrinks `surface`, for which `fails` is true. Removes connected parts (with the cavities inside them),
/// cuts handles, cuts off pieces, collapses edges whose link condition holds, and rounds coordinates to short
/// decimals. Every candidate is certified before it is tested: closed, manifold, oriented as `surface` is,
/// free of self-intersections; it never has more triangles than the last. The candidate that is accepted is
/// the first in a fixed order, so the result does not depend on the number of threads unless the time runs
/// out. A parametric definition is dropped. InputError, one line, if `surface` itself is not valid; what
/// `fails` throws is passed on.
ShrinkResult shrink_surface(const TriangleSurface& surface, const StillFails& fails,
                            const ShrinkOptions& options = {});

}  // namespace tetproof::corpus
