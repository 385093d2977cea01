// SPDX-License-Identifier: GPL-3.0-or-later
// The invariants that must hold after every step of the adaptation.
#pragma once

#include "reference/engine/adaptation/weighted_grid.hpp"

namespace tetproof::reference {

/// Throws std::logic_error, saying what is wrong, unless: every tetrahedron from number `first` on is exactly
/// positive and meets its neighbours face to face, with opposite orientation; its error is that of its
/// volume; and E_avg as maintained is the mean of all errors (to 1e-12). If `first` is 0, the default, every
/// face must also belong to at most two tetrahedra.
void check_invariants(const WeightedGrid& grid, Index first = 0);

}  // namespace tetproof::reference
