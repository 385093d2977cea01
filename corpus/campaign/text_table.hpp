// SPDX-License-Identifier: GPL-3.0-or-later
// Tables for terminals. Not installed.
#pragma once

#include <string>
#include <vector>

namespace tetproof::corpus {

/// A terminal must not take what a program printed for commands: control characters become '?'.
std::string printable(std::string text);

/// Rows of cells, the head first.
using TextRows = std::vector<std::vector<std::string>>;

/// The rows in columns that are as wide as their widest cell: the first one to the left,
/// numbers to the right. Control characters become '?'.
std::string text_table(const TextRows& rows);

}  // namespace tetproof::corpus
