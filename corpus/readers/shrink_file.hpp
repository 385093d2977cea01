// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a file smaller that makes a program fail.
#pragma once

#include <functional>
#include <string>

namespace tetproof::corpus {

/// Leaves out lines, then bytes, as long as `fails` holds for what remains, and until `seconds` are over.
/// `bytes` fails. Delta debugging: A. Zeller and R. Hildebrandt, "Simplifying and Isolating Failure-Inducing
/// Input", 2002.
std::string shrink_file(std::string bytes, const std::function<bool(const std::string&)>& fails,
                        double seconds);

}  // namespace tetproof::corpus
