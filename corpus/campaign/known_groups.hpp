// SPDX-License-Identifier: GPL-3.0-or-later
// Files of known groups of failures. Not installed.
#pragma once

#include <string>
#include <vector>

namespace tetproof::corpus {

/// "NAME:OUTCOME:SIGNATURE" in one line, as a file of known groups has it.
std::string group_id(const std::string& name, const char* outcome, const std::string& signature);

/// Reads a file of ids, one a line; what begins with # is a comment. InputError if it cannot be read, or if a
/// line is no id: MESHER:OUTCOME:SIGNATURE.
std::vector<std::string> read_known_groups(const std::string& path);

}  // namespace tetproof::corpus
