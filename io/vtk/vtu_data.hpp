// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the numbers of an array in a .vtu file, in all their encodings.
#pragma once

#include <bit>
#include <optional>
#include <string>
#include <string_view>

#include "io/document.hpp"
#include "io/vtk/vtu_unpack.hpp"

namespace tetproof::io {

/// The encoding of all arrays of a file.
struct VtuEncoding {
  const std::string& path;
  std::string_view bytes;  ///< the whole file
  std::endian order = std::endian::native;
  int header_size = 4;  ///< bytes of each number in front of binary data
  VtuPacking packing = VtuPacking::none;
};

/// The place of an array's numbers: bytes `begin` to `end` of the file.
struct VtuPlace {
  enum Kind { ascii, base64, raw } kind = ascii;
  std::size_t begin = 0, end = 0;
  bool shared = false;  ///< appended data: other arrays may follow before `end`
};

/// Reads the values of an array into `column`, whose type is set and valid: reals, integers or texts. The
/// type Bit becomes UInt8. `count`: how many there must be, if that is known. Returns how many bytes of the
/// place follow the values. InputError, with line or byte, for anything else.
std::size_t read_vtu_array(const VtuEncoding& encoding, const VtuPlace& place,
                           std::optional<std::size_t> count, Column& column);

}  // namespace tetproof::io
