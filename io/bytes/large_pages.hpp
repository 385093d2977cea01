// SPDX-License-Identifier: GPL-3.0-or-later
// Large arrays in large memory pages. With pages of 4 KiB, the page faults for a mesh take as long as reading
// it.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <vector>

namespace tetproof::io {

/// Asks the system to use large pages for this memory, which must not have been written to yet. Costs nothing
/// if the memory has no room for them.
void prefer_large_pages(void* memory, std::size_t bytes);

/// Reserves room for `count` items in total.
template <class T>
void reserve_in_large_pages(std::vector<T>& items, std::size_t count) {
  if (count <= items.capacity()) return;
  items.reserve(count);
  prefer_large_pages(items.data(), items.capacity() * sizeof(T));
}

/// Resizes to `count` items; new ones are T().
template <class T>
void resize_in_large_pages(std::vector<T>& items, std::size_t count) {
  reserve_in_large_pages(items, count);
  items.resize(count);
}

/// Temporary memory, in large pages if there is much of it. The thread keeps it and uses it again for the
/// next Scratch that needs no more.
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
