// SPDX-License-Identifier: GPL-3.0-or-later
// Writes values as solutions, in a .sol, a .solb or the mesh.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "io/bytes/atomic_file.hpp"
#include "io/document.hpp"
#include "io/medit/medit_solution.hpp"

namespace tetproof::io {

/// Values with the type of the field as which they are written (io/medit/medit_solution.hpp).
using MeditFields = std::vector<std::pair<const Values*, int>>;

/// What stands under a keyword such as SolAtVertices.
struct MeditSolutionPart {
  const MeditSolutionKeyword* keyword = nullptr;
  MeditFields fields{};
  std::size_t items = 0;
};

/// Returns how many numbers an item has in all fields together.
std::size_t medit_row(const MeditFields& fields);
/// Writes the numbers of all fields, item by item.
void write_medit_numbers(AtomicFile& file, const MeditFields& fields, std::size_t items, bool binary);

/// Writes a .sol or .solb with these parts in their order.
void write_medit_solution(AtomicFile& file, const std::vector<MeditSolutionPart>& parts, bool binary);

}  // namespace tetproof::io
