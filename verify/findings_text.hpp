// SPDX-License-Identifier: GPL-3.0-or-later
// What the checks found, in words: for the report, for test suites, for CI systems.
#pragma once

#include <cstddef>
#include <string>

#include "verify/report.hpp"

namespace tetproof::verify {

/// A finding in one line, and what follows from it in lines of their own: "tetrahedra 3, 17 at (0, 0, 1):
/// ...". Numbers as in the file, of many elements the first five.
std::string finding_text(const Finding& finding, const Numbering& numbering = {});

/// The findings of one check, the first `most` of them, each indented by two blanks, and how many more there
/// are.
std::string findings_text(const CheckResult& result, const Numbering& numbering = {}, std::size_t most = 5);

/// What a check says of a mesh that does not pass it: "FAIL inverted: 2" and its findings.
std::string check_text(const CheckResult& result, const Numbering& numbering = {}, std::size_t most = 5);

/// "sound: certified, ..." or "DEFECTIVE: ...".
std::string verdict_text(const Report& report);

/// The verdict and what failed, causes before what follows from them; in all the first `most` findings. No
/// warnings, no accounts.
std::string failure_text(const Report& report, const Numbering& numbering = {}, std::size_t most = 5);

}  // namespace tetproof::verify
