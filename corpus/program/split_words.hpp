// SPDX-License-Identifier: GPL-3.0-or-later
// The words of a command that is given as one text. Not installed.
#pragma once

#include <string>
#include <vector>

namespace tetproof::corpus {

/// Splits at blanks. Quotes keep words together and a backslash keeps the next byte, as in a shell; nothing
/// else has a meaning. InputError for a quote without an end.
std::vector<std::string> split_words(const std::string& text);

}  // namespace tetproof::corpus
