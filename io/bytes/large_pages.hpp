// SPDX-License-Identifier: GPL-3.0-or-later
// Large arrays in large pages of memory: faulting a mesh in by pages of 4 KiB takes as long as reading it.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <vector>

namespace tetproof::io {

/// Asks the system for large pages where this memory, not yet written to, has room for them. Costs nothing
/// where there are none.
void prefer_large_pages(void* memory, std::size_t bytes);

/// Room for `count` items in all.
template <class T>
void reserve_in_large_pages(std::vector<T>& items, std::size_t count) {
  if (count <= items.capacity()) return;
  items.reserve(count);
  prefer_large_pages(items.data(), items.capacity() * sizeof(T));
}

/// `count` items, each T().
template <class T>
void resize_in_large_pages(std::vector<T>& items, std::size_t count) {
  reserve_in_large_pages(items, count);
  items.resize(count);
}

/// Memory for a while, in large pages if it is much; the thread keeps it for the next time that it wants so
/// much.
class Scratch {
 public:
  explicit Scratch(std::size_t bytes);
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  char* data() const { return memory_.get(); }

 private:
  struct Free {
    void operator()(char* memory) const { std::free(memory); }
  };
  using Memory = std::unique_ptr<char, Free>;
  struct Kept {
    Memory memory;
    std::size_t size = 0;
  };
  static Kept& kept();

  Memory memory_;
  std::size_t size_ = 0;
};

}  // namespace tetproof::io
