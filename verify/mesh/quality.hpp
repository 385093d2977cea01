// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the angles and aspect ratios of tetrahedra. Internal.
#pragma once

#include <cstdint>
#include <vector>

#include "verify/report.hpp"

namespace tetproof::verify {

/// Only tetrahedra of exactly positive volume are measured and counted; the `excluded` ones (empty: none) are
/// left out.
Quality measure_quality(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded);

}  // namespace tetproof::verify
