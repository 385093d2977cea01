// SPDX-License-Identifier: GPL-3.0-or-later
// Formats numbers as text, and writes long lists of lines: all threads format, and the order is kept.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>

#include "io/bytes/atomic_file.hpp"

namespace tetproof::io {

inline constexpr std::size_t longest_real = 24;     ///< characters of -2.2250738585072014e-308
inline constexpr std::size_t longest_integer = 20;  ///< characters of -9223372036854775808

/// Writes the shortest decimal that reads back as `value`, or nan, inf, -inf as other programs do. At most
/// `longest_real` characters. Returns the end, as the other `put` do.
inline char* put(char* to, double value) {
  if (std::isnan(value)) {
    std::memcpy(to, "nan", 3);  // without a sign, which other readers may refuse
    return to + 3;
  }
  return std::to_chars(to, to + longest_real, value).ptr;
}
inline char* put(char* to, std::int64_t value) {
  return std::to_chars(to, to + longest_integer, value).ptr;
}
inline char* put(char* to, std::int32_t value) {
  return std::to_chars(to, to + longest_integer, value).ptr;
}
inline char* put(char* to, char c) {
  *to = c;
  return to + 1;
}

/// Writes chunks 0 .. chunks-1 in order. All threads format, and one of them writes meanwhile. `format(c,
/// to)` puts chunk c at `to`, in at most `longest` bytes, and returns its end.
void write_chunks(AtomicFile& file, std::size_t chunks, std::size_t longest,
                  const std::function<char*(std::size_t, char*)>& format);

/// Writes items 0 .. count-1 in order. `format(i, to)` puts item i at `to`, in at most `longest` bytes, and
/// returns its end. The file's bytes do not depend on the number of threads.
template <class FormatItem>
void write_items(AtomicFile& file, std::size_t count, std::size_t longest, const FormatItem& format) {
  constexpr std::size_t chunk_bytes = std::size_t{1}
                                      << 19;  // smaller chunks make binary output wait for its turn
  const std::size_t chunk = std::max<std::size_t>(1, chunk_bytes / longest);
  write_chunks(file, (count + chunk - 1) / chunk, std::min(chunk, count) * longest,
               [&](std::size_t c, char* to) {
                 for (std::size_t i = c * chunk, end = std::min(count, i + chunk); i < end; ++i)
                   to = format(i, to);
                 return to;
               });
}

}  // namespace tetproof::io
