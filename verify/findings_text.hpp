// SPDX-License-Identifier: GPL-3.0-or-later
// Findings in words: for the report, for test suites, for CI systems.
#pragma once

#include <cstddef>
#include <string>

#include "verify/report.hpp"

namespace tetproof::verify {

/// A finding in one line: "tetrahedra 3, 17 at (0, 0, 1): ...", and a further line for each check with
/// consequences of it. Numbers are those of the file. Of many elements the first five are named.
std::string finding_text(const Finding& finding, const Numbering& numbering = {});

/// The first `most` findings of a check, each indented by two blanks, and the number of further ones.
std::string findings_text(const CheckResult& result, const Numbering& numbering = {}, std::size_t most = 5);

/// A check that does not hold: "FAIL inverted: 2" or "warning cavity: 1", and its findings.
std::string check_text(const CheckResult& result, const Numbering& numbering = {}, std::size_t most = 5);

/// What would remain without the faults that concern the mesh as a whole, in lines; empty if there are none.
std::string if_mended_text(const Report& report, const Numbering& numbering = {}, std::size_t most = 5);

/// One line without its end that begins with "sound: ", "DEFECTIVE: " or "incomplete: ". It says what was
/// judged, what was not judged, and what the options left out.
std::string verdict_text(const Report& report);
/// The name of a region: "physical 2 (steel)", "entity 2", or its number alone.
std::string region_text(const RegionTag& tag);
/// The reasons: a line for each item that was not judged or was left out.
std::string scope_text(const Report& report);

/// The verdict, what was not judged and why, and the checks that failed, causes before their consequences,
/// with the first `most` findings in all. Warnings, counts and volumes are left out.
std::string failure_text(const Report& report, const Numbering& numbering = {}, std::size_t most = 5);

}  // namespace tetproof::verify
