// SPDX-License-Identifier: GPL-3.0-or-later
// Titles of documents as comments at the top of a text.
#pragma once

#include <string>
#include <vector>

#include "io/bytes/input_file.hpp"
#include "io/bytes/scanner.hpp"

namespace tetproof::io {

/// The comments above everything else, line by line, without '#' and one blank behind it.
std::string leading_comments(Scanner scanner);
/// The lines of a title, without line ends.
std::vector<std::string> title_lines(const std::string& title);
/// Whether a title that is written as comments comes back unchanged.
bool title_in_lines(const std::string& title);

}  // namespace tetproof::io
