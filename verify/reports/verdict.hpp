// SPDX-License-Identifier: GPL-3.0-or-later
// Words for the verdict on the whole mesh, which all reports use. Internal.
#pragma once

#include <string>

#include "verify/report.hpp"

namespace tetproof::verify {

/// "sound", "defective" or "incomplete".
const char* verdict_word(const Report& report);
/// "pass", "warning", "fail", "undecided" or "skipped": of one check.
const char* verdict_name(Verdict verdict);
/// "8 cells of type 42", "check overlap", "26 checks".
std::string name_of(const NotJudged& entry);

}  // namespace tetproof::verify
