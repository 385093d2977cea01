// SPDX-License-Identifier: GPL-3.0-or-later
// Cases on several threads. Not installed.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

namespace tetproof::corpus {

/// Some of the numbers from `first` to before `end`.
struct Indices {
  std::uint64_t first = 0, end = 0, step = 1;
};

/// Calls `work` once for each index, on `threads` threads (0: one for each core), in the order of the indices
/// as far as several threads have one. The first exception ends it: no further index begins, `stop` becomes
/// true, and the exception is thrown again when all threads have ended.
void share_work(const Indices& indices, int threads,
                const std::function<void(std::uint64_t index, const std::atomic<bool>& stop)>& work);

}  // namespace tetproof::corpus
