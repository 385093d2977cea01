// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the records of steps (i) to (iv) of a trace with our own. Not installed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/trace.hpp"

namespace tetproof::reference {

/// Reads the trace up to its first record of step (v) or (vi), or to its `end` record, and compares it with
/// `ours`, the records of our steps (i) to (iv). Records of one kind may come in any order. `own_settings`
/// are those of our run. Returns the first record that is none of
/// these. Throws Divergence for a record that differs, that stands twice, or that is missing.
/// `not_checked` gets the kinds of records that the trace leaves out altogether. Throws InputError for a
/// trace that breaks off here.
trace::Record check_first_steps(trace::Reader& reader, const std::vector<trace::Record>& ours,
                                const trace::Settings& own_settings, std::vector<std::string>& not_checked);

/// Throws InputError: the trace ends without an `end` record.
[[noreturn]] void fail_truncated(const trace::Reader& reader);

}  // namespace tetproof::reference
