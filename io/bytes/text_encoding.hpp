// SPDX-License-Identifier: GPL-3.0-or-later
// The encoding of texts: UTF-8, with or without a byte order mark, is read.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/bytes/input_file.hpp"

namespace tetproof::io {

/// Where a text begins: behind the byte order mark that some editors write before UTF-8.
inline std::size_t start_of_utf8(std::string_view bytes) {
  return bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0;
}

/// Where a text ends: before the zero bytes and the ^Z of DOS that some writers leave at its end.
std::size_t end_of_text(std::string_view bytes);

/// A warning of what stands behind the end of a text; empty: nothing.
std::string warning_of_end(const InputFile& file);

/// InputError if the file is text in UTF-16 or UTF-32, which no mesh format has.
void refuse_wide_text(const InputFile& file);

}  // namespace tetproof::io
