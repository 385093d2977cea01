// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the values of vertices as a .sol or .solb.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "io/bytes/atomic_file.hpp"
#include "io/document.hpp"

namespace tetproof::io {

/// Values with the type of the field as which they are written (io/medit/medit_solution.hpp).
using MeditFields = std::vector<std::pair<const Values*, int>>;

void write_medit_solution(AtomicFile& file, const MeditFields& fields, std::size_t nodes, bool binary);

}  // namespace tetproof::io
