// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a program's output, and the words for which they are searched.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tetproof::corpus {

/// Lines without their ends and without colours; what a carriage return overwrote is left out.
std::vector<std::string> output_lines(std::string_view output);

/// Whether `text` contains `part`, which is in lower case; the case of `text` does not matter.
bool says(std::string_view text, std::string_view part);

/// A line without what changes from run to run: numbers become "#", addresses "ADDRESS", paths their last
/// part. At most 160 bytes.
std::string without_numbers(std::string_view line);

}  // namespace tetproof::corpus
