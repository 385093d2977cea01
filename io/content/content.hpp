// SPDX-License-Identifier: GPL-3.0-or-later
// Recognises the format of a file by its content.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetproof::io {

/// The format of a file, as its content shows it.
struct Content {
  std::string format;  ///< a name of `formats()`; empty: a foreign format, which is not read
  std::string what;    ///< with its article: "a Gmsh .msh 4.1 file", "an MFEM mesh"
  std::string advice;  ///< of a foreign format: what the user can do
};

/// The formats that we read and that the content shows, the most certain one first; mostly one or none.
/// TetGen's files are never recognised, since they hold numbers and nothing else; nor is an OFF without its
/// keyword.
std::vector<Content> own_contents(std::string_view bytes);

/// The foreign format, if the content leaves no doubt. `ending` is that of the file's name, in lower case: a
/// FreeFem .msh is recognised under this ending only, because an OFF without its keyword begins in the same
/// way.
std::optional<Content> foreign_content(std::string_view bytes, std::string_view ending);

}  // namespace tetproof::io
