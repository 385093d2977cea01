// SPDX-License-Identifier: GPL-3.0-or-later
// The statements of OBJ: a word and its fields. A statement ends with its line, or goes on in the next line
// after a backslash.
#pragma once

#include <string>
#include <string_view>

#include "io/bytes/scanner.hpp"

namespace tetproof::io {

/// The next word of a statement; empty at the statement's end.
std::string_view next_field(Scanner& scanner);
/// The rest of a statement as one name: its words with one blank between them.
std::string name_field(Scanner& scanner);
void skip_statement(Scanner& scanner);

inline bool is_face(std::string_view statement) {
  return statement == "f" || statement == "fo";
}
/// Whether OBJ has a statement with this word.
bool is_statement(std::string_view word);

}  // namespace tetproof::io
