// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers for what an edit makes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace tetproof::io {

/// Gives numbers above 0 that nothing has yet: those behind the largest one. Where a file has such large
/// numbers that there is no room behind them, the smallest ones that are free.
class FreeNumbers {
 public:
  /// `taken`: in any order, also more than once.
  explicit FreeNumbers(std::vector<std::int64_t> taken) : taken_(std::move(taken)) {
    if (!std::is_sorted(taken_.begin(), taken_.end())) std::sort(taken_.begin(), taken_.end());
    constexpr std::int64_t limit = std::numeric_limits<std::int64_t>::max() / 2;
    if (!taken_.empty() && taken_.back() > 0 && taken_.back() < limit) next_ = taken_.back() + 1;
  }

  std::int64_t next() {
    while (at_ < taken_.size() && taken_[at_] <= next_) next_ += taken_[at_++] == next_;
    return next_++;
  }

 private:
  std::vector<std::int64_t> taken_;  // ascending
  std::size_t at_ = 0;
  std::int64_t next_ = 1;
};

}  // namespace tetproof::io
