// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign/share_work.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tetproof::corpus {

void share_work(const Indices& indices, int threads,
                const std::function<void(std::uint64_t, const std::atomic<bool>&)>& work) {
  std::atomic<std::uint64_t> next{indices.first};
  std::atomic<bool> stop{false};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto run = [&] {
    try {
      while (!stop) {
        const std::uint64_t index = next.fetch_add(indices.step);
        if (index >= indices.end) return;
        work(index, stop);
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      stop = true;
    }
  };
  const int all = threads > 0 ? threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  {
    std::vector<std::jthread> workers;
    for (int t = 1; t < all; ++t) workers.emplace_back(run);
    run();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace tetproof::corpus
