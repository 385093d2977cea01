// SPDX-License-Identifier: GPL-3.0-or-later
// A command's words with the files' paths in place of {mesh} and the like.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tetproof::corpus {

/// Pairs of a placeholder and what it stands for: {"{mesh}", "/tmp/x/mesh.msh"}.
using Placeholders = std::vector<std::pair<std::string, std::string>>;

/// The text with each placeholder replaced, wherever it stands.
std::string replaced(std::string text, const Placeholders& values);

/// The same for all words.
std::vector<std::string> replaced(std::vector<std::string> words, const Placeholders& values);

/// Whether one of the words contains `part`.
bool has_part(const std::vector<std::string>& words, const std::string& part);

/// A word as a shell takes it: in quotes where it needs them.
std::string shell_word(const std::string& word);

/// The words as one line for a shell, each as `shell_word` gives it.
std::string command_line(const std::vector<std::string>& words);

}  // namespace tetproof::corpus
