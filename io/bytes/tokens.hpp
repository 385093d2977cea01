// SPDX-License-Identifier: GPL-3.0-or-later
// Words in files: keywords in upper or lower case, and names encoded as one word, with %XX for characters
// that would end the word.
#pragma once

#include <string>
#include <string_view>

namespace tetproof::io {

/// Lower case for ASCII letters; other bytes stay.
std::string lower_case(std::string_view text);

/// Encodes a name as one word. Blanks, control characters, '#' and backslashes become % and two hexadecimal
/// digits, and so does a '%' that would look like such a code. `blanks`: single blanks inside the name stay,
/// for names that end with their line. An empty name stays empty.
std::string encode_name(std::string_view name, bool blanks = false);
/// The name that `encode_name` encoded.
std::string decode_name(std::string_view word);

}  // namespace tetproof::io
