// SPDX-License-Identifier: GPL-3.0-or-later
// Separates the tags of a .vtu file from the content between them. The content may be many gigabytes, and raw
// appended data is no XML at all, so the XML parser must not see it.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "io/bytes/input_file.hpp"

namespace tetproof::io {

/// The tags of a file. Each text between tags is replaced by its position in `texts`.
struct VtuSkeleton {
  struct Text {
    std::size_t begin, end;
  };
  std::string xml;
  std::vector<Text> texts;
  std::vector<std::pair<std::size_t, std::size_t>> tags;  ///< place of each in `xml`, and in the file
  std::size_t appended = 0;  ///< where appended data begins, after the underscore; 0: there is none

  /// Returns the place in the file of a place in `xml`.
  std::size_t place(std::ptrdiff_t in_xml) const;
};

/// InputError if this is no XML, or has more tags than a file of this size needs.
VtuSkeleton vtu_skeleton(const InputFile& file);

}  // namespace tetproof::io
