// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of a binary file, in a byte order.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

namespace tetproof::test {

template <class T>
void append(std::string& bytes, T value, std::endian order) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (order != std::endian::native) std::reverse(raw, raw + sizeof value);
  bytes.append(raw, sizeof value);
}

}  // namespace tetproof::test
