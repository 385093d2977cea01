// SPDX-License-Identifier: GPL-3.0-or-later
// Words for the verdict on the whole mesh, which all reports use. Internal.
#pragma once

#include <string>

#include "verify/report.hpp"

namespace tetproof::verify {

/// "sound", "defective" or "incomplete".
const char* verdict_word(const Report& report);
/// "8 cells of type 42 (not read: the first is cell 3)".
std::string not_judged_text(const NotJudged& entry);

}  // namespace tetproof::verify
