// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes/plain_records.hpp"

#include <tbb/parallel_for.h>

#include <optional>

#include "io/bytes/large_pages.hpp"

namespace tetproof::io {

void read_records(const Source& source, std::size_t offset, std::size_t size, std::size_t count,
                  const std::function<void(const char*, std::size_t, std::size_t)>& read) {
  const std::size_t run = records_in_run(size);
  const std::size_t runs = (count + run - 1) / run;
  tbb::parallel_for(std::size_t{0}, runs, [&](std::size_t r) {
    const std::size_t first = r * run, here = std::min(run, count - first);
    if (!source.file) return read(source.bytes.data() + offset + first * size, first, here);
    const Scratch memory(here * size);
    source.file->copy(offset + first * size, here * size, memory.data());
    read(memory.data(), first, here);
  });
}

void copy_bytes(const Source& source, std::size_t offset, std::size_t count, char* to) {
  constexpr std::size_t run = std::size_t{1} << 20;
  tbb::parallel_for(std::size_t{0}, (count + run - 1) / run, [&](std::size_t r) {
    const std::size_t from = r * run, here = std::min(run, count - from);
    if (source.file)
      source.file->copy(offset + from, here, to + from);
    else
      std::memcpy(to + from, source.bytes.data() + offset + from, here);
  });
}

}  // namespace tetproof::io
