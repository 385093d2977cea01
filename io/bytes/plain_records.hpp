// SPDX-License-Identifier: GPL-3.0-or-later
// Reads long runs of binary records of one size by several threads.
#pragma once

#include <algorithm>
#include <cstring>
#include <functional>

#include "io/bytes/input_file.hpp"

namespace tetproof::io {

/// Shorter runs of records are read one number after the other.
inline constexpr std::size_t least_plain_records = 1024;

template <class T>
T number_at(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

/// The number of records of `size` bytes that one call of `read` gets.
inline std::size_t records_in_run(std::size_t size) {
  return std::max<std::size_t>(1, (std::size_t{1} << 18) / size);
}

/// Reads `count` records of `size` bytes from `offset` on; the source must have them. Calls `read(bytes,
/// first, count)` from several threads, each time for a run of them.
void read_records(const Source& bytes, std::size_t offset, std::size_t size, std::size_t count,
                  const std::function<void(const char*, std::size_t, std::size_t)>& read);

/// Copies `count` bytes from `offset` on by several threads; the source must have them.
void copy_bytes(const Source& bytes, std::size_t offset, std::size_t count, char* to);

}  // namespace tetproof::io
