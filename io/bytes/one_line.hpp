// SPDX-License-Identifier: GPL-3.0-or-later
// Shows texts of files in messages: in one line, and without characters that a terminal obeys.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tetproof::io {

/// The text with escapes for everything that breaks a line, steers a terminal or changes the direction of
/// writing, and for bytes that are no UTF-8: "\x1B", "\x85", "\u2028". All other characters stay.
std::string in_one_line(std::string_view text);

/// The same for the start of a text, at most `most` bytes of it; "..." stands for the rest.
std::string start_in_one_line(std::string_view text, std::size_t most);

/// JSON whose strings have escapes for all such characters: "\u009B". JSON itself wants this for a few only.
std::string escape_controls_of_json(std::string_view json);

}  // namespace tetproof::io
