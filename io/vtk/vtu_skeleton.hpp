// SPDX-License-Identifier: GPL-3.0-or-later
// The XML of a .vtu file without what stands between its tags: that may be most of many gigabytes, is no XML
// where it is appended raw, and is kept from the XML parser.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "io/bytes/input_file.hpp"

namespace tetproof::io {

/// The tags of a file, each text between them replaced by its number in `texts`.
struct VtuSkeleton {
  struct Text {
    std::size_t begin, end;
  };
  std::string xml;
  std::vector<Text> texts;
  std::vector<std::pair<std::size_t, std::size_t>> tags;  ///< place of each in `xml`, and in the file
  std::size_t appended = 0;  ///< where appended data begin, behind the underscore; 0: none

  /// Where in the file a place in `xml` is.
  std::size_t place(std::ptrdiff_t in_xml) const;
};

/// InputError for what is no XML, or is more tags than the file's size justifies.
VtuSkeleton vtu_skeleton(const InputFile& file);

}  // namespace tetproof::io
