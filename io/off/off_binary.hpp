// SPDX-License-Identifier: GPL-3.0-or-later
// Binary OFF.
#pragma once

#include <cstddef>

#include "io/bytes/input_file.hpp"
#include "io/model/read_document.hpp"

namespace tetproof::io {

/// What the keyword of an OFF says of its vertices.
struct OffKeyword {
  bool texture = false, color = false, normal = false;
  std::size_t end = 0;  ///< the byte behind the keyword
};

/// Reads what follows `[ST][C][N]OFF BINARY` into `read`: numbers of 4 bytes, the most significant first.
/// Three counts; for each vertex 3 coordinates, 3 of a normal, 4 of a colour and 2 of a texture, floats; for
/// each face the number of its corners, these, the number of its colour's components, and these as floats.
/// InputError, with the byte.
void read_binary_off(const InputFile& file, const OffKeyword& keyword, bool surface, ReadDocument& read);

}  // namespace tetproof::io
