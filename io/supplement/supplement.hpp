// SPDX-License-Identifier: GPL-3.0-or-later
// The supplement: what a format has no place for, as lines of text in a corner of the file that other
// programs skip. It is written beside the format's own content, the native part, and joined with it again on
// reading.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/holds.hpp"

namespace tetproof::io {

/// Identifies a file of the native part at the time when the supplement was written. If the file has changed
/// since then, the supplement is ignored and the file is believed.
struct Checksum {
  std::string ending;       ///< of another file of the set; empty: this file, up to the supplement
  std::uint32_t crc32 = 0;  ///< as zlib computes it
};

/// How the native part has values.
inline constexpr std::int32_t not_native = 0, as_they_are = 1, integers_as_reals = 2;

/// Returns everything that the native part lacks according to `holds`, and whatever else the reader needs to
/// put it back: lines of printable ASCII without `$` and `#`, at most 1000 bytes long, each ending in LF.
/// Only of use if `unheld` in io/loss/holds.hpp lists something.
std::string supplement_of(const Document& document, const Holds& holds);

/// Returns the line that comes before them.
std::string supplement_head(const std::vector<Checksum>& checksums);

/// Turns lines into comments for a file whose comments start with `#`.
std::string as_comments(std::string_view lines);

/// Returns the checksums in the first of `lines`. If that line is of a version that this reader does not
/// know, returns none and adds a warning.
std::vector<Checksum> read_supplement_head(std::string_view lines, Document& native);

/// Puts what `lines` (with their head) say back into `native`, which is as its reader made it. Without lines,
/// does nothing. The content is checked like that of any file; the message of the InputError begins with
/// `place`.
void take_back(std::string_view lines, const std::string& place, Document& native);

/// Returns the lines of the supplement in comments at the end of `file`; empty: there is none. If a checksum,
/// of this file or of another one whose name is `stem` and an ending, is wrong, the supplement is ignored
/// with a warning.
std::string supplement_in_comments(const InputFile& file, const std::string& stem, Document& native);

/// Whether the document had no values of elements, so that those in the native part are only for other
/// programs.
bool has_no_element_values(std::string_view lines);

/// Warns of a file that was changed after its supplement was written, and lists the supplement as dropped.
void drop_outdated_supplement(const std::string& path, Document& native);

}  // namespace tetproof::io
