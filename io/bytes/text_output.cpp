// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes/text_output.hpp"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <string_view>

#include "io/bytes/checksum.hpp"
#include "io/bytes/large_pages.hpp"

namespace tetproof::io {

void write_chunks(AtomicFile& file, std::size_t chunks, std::size_t longest,
                  const std::function<char*(std::size_t, char*)>& format) {
  if (chunks == 0) return;
  const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  const std::size_t room = std::min(chunks, threads + 2);  // chunks in progress at a time
  const Scratch memory(room * longest);
  struct Formatted {
    std::string_view bytes;
    std::uint32_t crc32 = 0;
  };
  const auto formatted = [&](std::size_t c) {
    char* const to = memory.data() + c % room * longest;
    const std::string_view bytes(to, format(c, to));
    return Formatted{bytes, file.keeps_checksum() ? crc32_of(bytes) : 0};
  };
  const auto write = [&](const Formatted& chunk) { file.write(chunk.bytes, chunk.crc32); };
  if (chunks == 1) return write(formatted(0));  // many files have many short lists, not worth a thread each
  std::size_t next = 0;
  const auto chunk_numbers = [&](tbb::flow_control& control) {
    if (next == chunks) control.stop();
    return next++;
  };
  using tbb::filter_mode;
  tbb::parallel_pipeline(room,
                         tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, chunk_numbers) &
                             tbb::make_filter<std::size_t, Formatted>(filter_mode::parallel, formatted) &
                             tbb::make_filter<Formatted, void>(filter_mode::serial_in_order, write));
}

}  // namespace tetproof::io
