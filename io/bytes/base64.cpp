// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes/base64.hpp"

namespace tetproof::io {

char* put_base64(char* to, const unsigned char* from, std::size_t size) {
  for (; size >= 3; size -= 3, from += 3, to += 4) {
    const unsigned bits = from[0] << 16 | from[1] << 8 | from[2];
    for (int k = 0; k < 4; ++k) to[k] = base64_digits[bits >> (18 - 6 * k) & 63];
  }
  if (size > 0) {
    const unsigned bits = from[0] << 16 | (size > 1 ? from[1] << 8 : 0);
    to[0] = base64_digits[bits >> 18 & 63];
    to[1] = base64_digits[bits >> 12 & 63];
    to[2] = size > 1 ? base64_digits[bits >> 6 & 63] : '=';
    to[3] = '=';
    to += 4;
  }
  return to;
}

std::string base64(std::string_view bytes) {
  std::string text((bytes.size() + 2) / 3 * 4, '\0');
  put_base64(text.data(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  return text;
}

}  // namespace tetproof::io
