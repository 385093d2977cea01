// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of a reader, and what it returns.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// What a reader is asked for: everything in the file, or only the part that a TriangleSurface takes, with
/// the places of the elements where the reader knows them. Readers of mesh formats read everything in both
/// cases.
enum class Wanted { document, surface };

/// A document as its reader gives it.
struct ReadDocument {
  Document document;
  /// The byte at which each element starts, if a surface is wanted and the reader knows them; else empty.
  std::vector<std::size_t> places{};
  bool text = true;     ///< a message tells a place as a line; else as a byte
  bool welded = false;  ///< no two points are equal
  /// For messages of what is wrong with the file, if its content overruled its ending: " (read as an OFF file
  /// because of its content, though its name ends in .stl)". Else empty.
  std::string read_as{};
};

}  // namespace tetproof::io
