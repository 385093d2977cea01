// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces the global operator new and delete. They stand on malloc, so that sanitizers still see every
// allocation.
#include "allocation_peak.hpp"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> now{0}, most{0};

void* counted(void* memory) {
  if (!memory) throw std::bad_alloc();
  const std::size_t total = now += malloc_usable_size(memory);
  for (std::size_t seen = most; seen < total && !most.compare_exchange_weak(seen, total);) {
  }
  return memory;
}

void give_back(void* memory) {
  if (!memory) return;
  now -= malloc_usable_size(memory);
  std::free(memory);
}

}  // namespace

namespace tetproof::test {

std::size_t allocated() {
  return now;
}
std::size_t peak_allocated() {
  return most;
}
void start_peak() {
  most = now.load();
}

}  // namespace tetproof::test

void* operator new(std::size_t size) {
  return counted(std::malloc(size ? size : 1));
}
void* operator new[](std::size_t size) {
  return counted(std::malloc(size ? size : 1));
}
void* operator new(std::size_t size, std::align_val_t align) {
  const auto a = static_cast<std::size_t>(align);
  return counted(std::aligned_alloc(a, (size + a - 1) / a * a));
}
void* operator new[](std::size_t size, std::align_val_t align) {
  return operator new(size, align);
}
// std::stable_sort asks for its buffer like this.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept {
  return operator new(size, tag);
}
void operator delete(void* memory) noexcept {
  give_back(memory);
}
void operator delete[](void* memory) noexcept {
  give_back(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  give_back(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  give_back(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  give_back(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
  give_back(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  give_back(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
  give_back(memory);
}
