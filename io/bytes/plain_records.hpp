// SPDX-License-Identifier: GPL-3.0-or-later
// Long runs of binary records of one size, read by several threads.
#pragma once

#include <algorithm>
#include <cstring>
#include <functional>

#include "io/bytes/input_file.hpp"

namespace tetproof::io {

/// Fewer records are read one number after the other.
inline constexpr std::size_t least_plain_records = 1024;

template <class T>
T number_at(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

/// How many records of so many bytes are read as one run.
inline std::size_t records_in_run(std::size_t size) {
  return std::max<std::size_t>(1, (std::size_t{1} << 18) / size);
}

/// Calls `read(bytes, first, count)` for runs of the `count` records of `size` bytes from `offset` on, which
/// must be there, from several threads.
void read_records(const Source& bytes, std::size_t offset, std::size_t size, std::size_t count,
                  const std::function<void(const char*, std::size_t, std::size_t)>& read);

/// Copies so many bytes from `offset` on, which must be there, by several threads.
void copy_bytes(const Source& bytes, std::size_t offset, std::size_t count, char* to);

}  // namespace tetproof::io
