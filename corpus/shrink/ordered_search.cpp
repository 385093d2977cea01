// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/shrink/ordered_search.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tetproof::corpus {

int threads_or_cores(int threads) {
  return threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::optional<std::size_t> first_success(std::size_t n, int threads, const TimeLimit& limit,
                                         const std::function<bool(std::size_t)>& trial) {
  std::mutex mutex;
  std::size_t next = 0, end = n;  // trials from `end` on no longer matter
  bool success = false;
  std::exception_ptr error;
  const auto work = [&] {
    for (;;) {
      std::size_t i;
      {
        const std::scoped_lock lock(mutex);
        if (next >= end || limit.over()) return;
        i = next++;
      }
      bool succeeded = false;
      std::exception_ptr thrown;
      try {
        succeeded = trial(i);
      } catch (...) {
        thrown = std::current_exception();
      }
      const std::scoped_lock lock(mutex);
      if ((!succeeded && !thrown) || i >= end) continue;
      end = i;
      success = succeeded;
      error = thrown;
    }
  };
  const std::size_t helpers = std::min<std::size_t>(static_cast<std::size_t>(threads), n);
  std::vector<std::jthread> others;
  for (std::size_t k = 1; k < helpers; ++k) others.emplace_back(work);
  work();
  for (std::jthread& other : others) other.join();
  if (error) std::rethrow_exception(error);
  return success ? std::optional(end) : std::nullopt;
}

}  // namespace tetproof::corpus
