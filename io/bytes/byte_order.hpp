// SPDX-License-Identifier: GPL-3.0-or-later
// Loads and stores numbers in either byte order, at any address.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace tetproof::io {

/// The number whose bytes begin at `from`.
template <class Number>
Number load(const char* from, std::endian order) {
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), from, sizeof(Number));
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

/// Writes the number's bytes at `to` and returns the address after them.
template <class Number>
char* store(char* to, Number value, std::endian order) {
  auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  std::memcpy(to, bytes.data(), sizeof(Number));
  return to + sizeof(Number);
}

}  // namespace tetproof::io
