// SPDX-License-Identifier: GPL-3.0-or-later
// Writes values as solutions: those of vertices as a .sol or .solb.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "io/bytes/atomic_file.hpp"
#include "io/document.hpp"

namespace tetproof::io {

/// Values with the type of the field as which they are written (io/medit/medit_solution.hpp).
using MeditFields = std::vector<std::pair<const Values*, int>>;

/// Returns how many numbers an item has in all fields together.
std::size_t medit_row(const MeditFields& fields);
/// Writes the numbers of all fields, item by item.
void write_medit_numbers(AtomicFile& file, const MeditFields& fields, std::size_t items, bool binary);

void write_medit_solution(AtomicFile& file, const MeditFields& fields, std::size_t nodes, bool binary);

}  // namespace tetproof::io
