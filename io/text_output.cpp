// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/text_output.hpp"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <string_view>

#include "io/large_pages.hpp"

namespace tetproof::io {

void write_chunks(AtomicFile& file, std::size_t chunks, std::size_t longest,
                  const std::function<char*(std::size_t, char*)>& format) {
  if (chunks == 0) return;
  const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  const std::size_t room = std::min(chunks, 2 * threads + 2);  // chunks that are in work at once
  const Scratch memory(room * longest);
  if (chunks == 1) {  // the many short lists of some files are not worth a thread
    file.write({memory.data(), format(0, memory.data())});
    return;
  }
  std::size_t next = 0;
  tbb::parallel_pipeline(
      room, tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order,
                                                [&](tbb::flow_control& control) {
                                                  if (next == chunks) control.stop();
                                                  return next++;
                                                }) &
                tbb::make_filter<std::size_t, std::string_view>(tbb::filter_mode::parallel,
                                                                [&](std::size_t c) {
                                                                  char* const to =
                                                                      memory.data() + c % room * longest;
                                                                  return std::string_view(to, format(c, to));
                                                                }) &
                tbb::make_filter<std::string_view, void>(tbb::filter_mode::serial_in_order,
                                                         [&](std::string_view bytes) { file.write(bytes); }));
}

}  // namespace tetproof::io
