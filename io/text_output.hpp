// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as text, and long lists of lines formatted by all threads and written in order.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "io/atomic_file.hpp"

namespace tetproof::io {

inline constexpr std::size_t longest_real = 24;     ///< characters of -2.2250738585072014e-308
inline constexpr std::size_t longest_integer = 20;  ///< characters of -9223372036854775808

/// The shortest decimal that reads back as `value`; nan and inf as other programs write them. At most
/// `longest_real` characters.
inline char* put(char* to, double value) {
  if (std::isnan(value)) {
    std::memcpy(to, "nan", 3);  // without a sign, which other readers may not take
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

/// Writes items 0 .. count-1 in order; `format(i, to)` puts item i at `to`, at most `longest` bytes, and
/// returns its end. The bytes do not depend on the number of threads.
template <class FormatItem>
void write_items(AtomicFile& file, std::size_t count, std::size_t longest, const FormatItem& format) {
  constexpr std::size_t chunk_bytes = 1 << 18;
  const std::size_t chunk = std::max<std::size_t>(1, chunk_bytes / longest);
  if (count <= chunk) {  // the many short lists of some files are not worth a thread
    std::string bytes(count * longest, '\0');
    char* at = bytes.data();
    for (std::size_t i = 0; i < count; ++i) at = format(i, at);
    file.write({bytes.data(), static_cast<std::size_t>(at - bytes.data())});
    return;
  }
  const std::size_t batch =
      4 * static_cast<std::size_t>(std::max(1, tbb::this_task_arena::max_concurrency()));
  struct Buffer {
    std::string bytes;
    std::size_t used = 0;
  };
  std::vector<Buffer> buffers(std::min(batch, count / chunk + 1));
  for (std::size_t start = 0; start < count; start += chunk * buffers.size()) {
    const std::size_t chunks = std::min(buffers.size(), (count - start + chunk - 1) / chunk);
    tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t c) {
      Buffer& buffer = buffers[c];
      const std::size_t from = start + c * chunk, to = std::min(count, from + chunk);
      buffer.bytes.resize(std::max(buffer.bytes.size(), (to - from) * longest));
      char* at = buffer.bytes.data();
      for (std::size_t i = from; i < to; ++i) at = format(i, at);
      buffer.used = at - buffer.bytes.data();
    });
    for (std::size_t c = 0; c < chunks; ++c) file.write({buffers[c].bytes.data(), buffers[c].used});
  }
}

}  // namespace tetproof::io
