// SPDX-License-Identifier: GPL-3.0-or-later
// What a format has no place for, as lines of text in a corner of the file that other programs skip: written
// beside the native part, and put together with it again on reading.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/document.hpp"
#include "io/loss/holds.hpp"

namespace tetproof::io {

/// What the native part was when the supplement was written: a file changed since then is believed instead.
struct Checksum {
  std::string ending;       ///< of another file of the set; empty: this file, up to the supplement
  std::uint32_t crc32 = 0;  ///< as zlib has it
};

/// Lines of printable ASCII without `$` and `#`, none longer than 1000 bytes, each ending in LF: everything
/// that `holds` says the native part lacks. Empty if it lacks nothing.
std::string supplement_of(const Document& document, const Holds& holds);

/// The line in front of them.
std::string supplement_head(const std::vector<Checksum>& checksums);

/// The same lines as comments of a file whose comments start with `#`.
std::string as_comments(std::string_view lines);

/// The checksums in the first of `lines`; empty, and a warning, if it is of a version that this reader does
/// not know.
std::vector<Checksum> read_supplement_head(std::string_view lines, Document& native);

/// Puts back into `native`, as its reader made it, what `lines` (with their head) say; nothing
/// if there are none. Their content is
/// checked like that of any file; `place` begins the message of the InputError.
void take_back(std::string_view lines, const std::string& place, Document& native);

/// The lines that stand in comments at the end of `file`, if any do and the checksums are right: of this
/// file, and of files called `stem` and an ending. Where they are not it is ignored with a warning.
std::string supplement_in_comments(const std::string& file, const std::string& stem, Document& native);

/// Whether values of elements in the native part are only for other programs, since the document has none.
bool has_no_element_values(std::string_view lines);

/// Warns of a file that was changed after its supplement was written, and lists the supplement as dropped.
void drop_outdated_supplement(const std::string& path, Document& native);

}  // namespace tetproof::io
