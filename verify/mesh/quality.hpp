// SPDX-License-Identifier: GPL-3.0-or-later
// Angles and aspect ratios of the tetrahedra. Internal.
#pragma once

#include <cstdint>
#include <vector>

#include "verify/report.hpp"

namespace tetproof::verify {

Quality measure_quality(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded);

}  // namespace tetproof::verify
