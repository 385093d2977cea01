// SPDX-License-Identifier: GPL-3.0-or-later
// The first of many trials that succeeds, with several trials running at once. Internal.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>

namespace tetproof::corpus {

/// The time that a shrinker may take.
class TimeLimit {
 public:
  explicit TimeLimit(double seconds) : seconds_(seconds), start_(std::chrono::steady_clock::now()) {}
  double elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  bool over() const { return elapsed() >= seconds_; }

 private:
  double seconds_;
  std::chrono::steady_clock::time_point start_;
};

/// The number of threads that `threads` asks for; 0: one for each core.
int threads_or_cores(int threads);

/// The lowest i < n for which `trial(i)` is true. Up to `threads` trials run at once, taken in order, so some
/// beyond the lowest may run in vain; the answer is the same for any number of threads. No trial is begun
/// once the time is over: the answer is then the lowest that was found. If a trial throws, the exception of
/// the lowest such trial below the answer is thrown, after the trials under way have ended.
std::optional<std::size_t> first_success(std::size_t n, int threads, const TimeLimit& limit,
                                         const std::function<bool(std::size_t)>& trial);

}  // namespace tetproof::corpus
