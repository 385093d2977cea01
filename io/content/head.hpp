// SPDX-License-Identifier: GPL-3.0-or-later
// Looks at the first bytes of a file whose format is not known.
#pragma once

#include <cstddef>
#include <string_view>

#include "io/bytes/input_file.hpp"
#include "io/bytes/scanner.hpp"

namespace tetproof::io {

/// No more of a text than this is looked at: enough for a hundred statements.
inline constexpr std::size_t head_bytes = 65536;

/// The first bytes, without the mark of UTF-8 and blanks in front.
std::string_view head_text(std::string_view bytes);

/// A scanner at the start of these; it is not asked for places.
Scanner head_scanner(std::string_view bytes);

/// The first tag of an XML or HTML file from its "<" on, behind declarations `<?...?>` and comments; empty:
/// there is none.
std::string_view first_tag(std::string_view bytes);

}  // namespace tetproof::io
