// SPDX-License-Identifier: GPL-3.0-or-later
// Words in files: keywords in any case, and names that are a word, in which what would end it stands as % and
// two hexadecimal digits.
#pragma once

#include <string>
#include <string_view>

namespace tetproof::io {

/// Of letters of ASCII.
std::string lower_case(std::string_view text);

/// `name` as one word: blanks, control characters, '#', a backslash, and a '%' that would be taken for such a
/// code are encoded. `blanks`: single ones inside stay, for names that reach to the end of the line. Empty
/// stays empty.
std::string encode_name(std::string_view name, bool blanks = false);
/// The other way.
std::string decode_name(std::string_view word);

}  // namespace tetproof::io
