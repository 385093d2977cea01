// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes/large_pages.hpp"

#include <sys/mman.h>

#include <cstdint>
#include <new>
#include <utility>

namespace tetproof::io {

void prefer_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::uintptr_t page = std::uintptr_t{1} << 21;
  const auto start = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (start + page - 1) / page * page, last = (start + bytes) / page * page;
  // NOLINTNEXTLINE(performance-no-int-to-ptr): rounded up to a page, it is the same memory
  if (first < last) ::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
}

Scratch::Kept& Scratch::kept() {
  thread_local Kept of_this_thread;
  return of_this_thread;
}

Scratch::Scratch(std::size_t bytes) {
  // Take the memory from the thread while it is in use: the thread may start other work meanwhile, which must
  // find other memory.
  if (Kept& mine = kept(); mine.size >= bytes) {
    memory_ = std::move(mine.memory);
    size_ = std::exchange(mine.size, 0);
    return;
  }
  // Use small pages for little memory: the unused part of a large page would be resident, too.
  const std::size_t page = std::size_t{1} << (bytes < std::size_t{1} << 20 ? 12 : 21);
  size_ = (bytes + page - 1) / page * page;
  memory_.reset(static_cast<char*>(std::aligned_alloc(page, size_)));
  if (!memory_) throw std::bad_alloc();
  prefer_large_pages(memory_.get(), size_);
}

Scratch::~Scratch() {
  constexpr std::size_t most = std::size_t{1} << 25;
  if (Kept& mine = kept(); size_ > mine.size && size_ <= most) mine = {std::move(memory_), size_};
}

}  // namespace tetproof::io
