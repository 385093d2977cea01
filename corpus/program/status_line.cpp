// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/program/status_line.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>

namespace tetproof::corpus {
namespace {

double seconds_between(std::chrono::steady_clock::time_point a, std::chrono::steady_clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

}  // namespace

StatusLine::StatusLine(const program::Common& common, std::uint64_t cases)
    : cases_(cases),
      start_(std::chrono::steady_clock::now()),
      last_(start_),
      terminal_(!common.quiet && ::isatty(STDERR_FILENO)) {}

void StatusLine::add(bool finding) {
  ++done_;
  if (finding) ++findings_;
  const auto now = std::chrono::steady_clock::now();
  const double so_far = seconds_between(start_, now);
  if (!terminal_ || so_far < 2 || seconds_between(last_, now) < 0.25) return;
  last_ = now;
  const std::uint64_t done = skipped_ + done_;
  const double each = so_far / static_cast<double>(done_);
  const double rest = cases_ > done ? each * static_cast<double>(cases_ - done) : 0;
  fmt::print(stderr, "\r\x1b[K{} of {} cases, {} findings, about {} left", done, cases_, findings_,
             duration_text(rest));
  std::fflush(stderr);
  shown_ = true;
}

void StatusLine::clear() {
  if (!shown_) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
  shown_ = false;
}

std::string duration_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace tetproof::corpus
