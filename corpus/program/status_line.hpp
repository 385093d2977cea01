// SPDX-License-Identifier: GPL-3.0-or-later
// The line on a terminal that shows how far a campaign is. Not installed.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "io/program/program.hpp"

namespace tetproof::corpus {

/// Shows cases done, findings and an estimate of the rest, a few times a second, after two seconds. Shows
/// nothing if standard error is not a terminal, or with --quiet.
class StatusLine {
 public:
  StatusLine(const program::Common& common, std::uint64_t cases);
  ~StatusLine() { clear(); }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  void skip(std::uint64_t cases) { skipped_ = cases; }  ///< cases that are done already
  void add(bool finding);                               ///< a case that is done now
  void clear();                                         ///< before anything else is printed

 private:
  std::uint64_t cases_, skipped_ = 0, done_ = 0, findings_ = 0;
  std::chrono::steady_clock::time_point start_, last_;
  double quiet_s_;
  bool terminal_, shown_ = false;
};

}  // namespace tetproof::corpus
