// SPDX-License-Identifier: GPL-3.0-or-later
// The text of a file, and lines of it as examples of what a reader drops.
#pragma once

#include <string>
#include <string_view>

#include "io/bytes/input_file.hpp"
#include "io/bytes/scanner.hpp"
#include "io/document.hpp"

namespace tetproof::io {

/// The bytes of a text without the zero bytes and the ^Z that some writers leave at its end. If there are
/// any, they are a warning of `document`.
std::string_view text_of_file(const InputFile& file, Document& document);

/// A scanner at the start of such a text, behind a byte order mark of UTF-8.
Scanner start_of_text(const InputFile& file, std::string_view text);

/// The rest of the line from `place` on, as an example: "line 17: curv2 1 2 3". It counts all lines above.
std::string example_line(const std::string& path, std::string_view text, std::size_t place);

}  // namespace tetproof::io
