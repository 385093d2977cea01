// SPDX-License-Identifier: GPL-3.0-or-later
// Finds out which of its two forms a Medit file has, and reads it.
#include <bit>

#include "io/bytes/byte_order.hpp"
#include "io/medit/medit.hpp"
#include "io/medit/medit_content.hpp"

namespace tetproof::io {

Document read_medit(const InputFile& file) {
  for (const std::endian order : {std::endian::little, std::endian::big})
    if (file.bytes().size() >= 4 && load<std::int32_t>(file.bytes().data(), order) == 1)
      return read_medit_binary(file, order);
  return read_medit_text(file);
}

}  // namespace tetproof::io
