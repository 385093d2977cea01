// SPDX-License-Identifier: GPL-3.0-or-later
// The beginning and the end of a stream of unknown length.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

namespace tetproof::corpus {

/// Keeps the first and the last half of `most` bytes of what is added.
class KeptOutput {
 public:
  explicit KeptOutput(std::size_t most) : half_(most / 2) {}

  void add(const char* bytes, std::size_t count) {
    const std::size_t first = std::min(count, half_ - head_.size());
    head_.append(bytes, first);
    tail_.append(bytes + first, count - first);
    if (tail_.size() > 2 * half_ + (1 << 16)) cut();
  }

  /// What was kept, with a line in place of what was cut.
  std::string text() {
    if (tail_.size() > half_) cut();
    if (cut_ == 0) return head_ + tail_;
    return head_ + "\n[" + std::to_string(cut_) + " bytes of output were cut here]\n" + tail_;
  }

 private:
  void cut() {
    const std::size_t surplus = tail_.size() - half_;
    tail_.erase(0, surplus);
    cut_ += surplus;
  }

  std::size_t half_, cut_ = 0;
  std::string head_, tail_;
};

}  // namespace tetproof::corpus
