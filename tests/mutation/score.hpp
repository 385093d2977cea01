// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the judge says of a planted mesh what is true of it.
#pragma once

#include <string>

#include "corpus/plant.hpp"
#include "verify/report.hpp"

namespace tetproof::test {

/// Empty if the report is right: the verdict and the certificate are what exact arithmetic says, every root
/// cause is admissible, every defect is named at its place, and what is called inverted or flat is. Otherwise
/// what is wrong, in one line.
std::string objection(const corpus::Planted& planted, const verify::Report& report);

/// Empty if the judge has nothing to say against a valid mesh, but for warnings of what is there.
std::string objection_to_sound(const corpus::Truth& truth, const verify::Report& report);

}  // namespace tetproof::test
