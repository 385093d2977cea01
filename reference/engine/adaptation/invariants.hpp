// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold after every step of the adaptation.
#pragma once

#include "reference/engine/adaptation/weighted_grid.hpp"

namespace tetproof::reference {

/// Throws std::logic_error, with what was expected and found, unless every tetrahedron from number `first` on
/// is exactly positive and meets its neighbours face to face from the other side, and E_avg as maintained is
/// the mean of all errors (to 1e-12). From 0, the default, also unless every face belongs to at most two
/// tetrahedra.
void check_invariants(const WeightedGrid& grid, Index first = 0);

}  // namespace tetproof::reference
