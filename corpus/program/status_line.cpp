// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/program/status_line.hpp"

#include <fmt/core.h>

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
      quiet_s_(std::chrono::duration<double>(program::quiet_time()).count()),
      terminal_(program::shows_progress(common)) {}

void StatusLine::add(bool finding) {
  ++done_;
  if (finding) ++findings_;
  const auto now = std::chrono::steady_clock::now();
  const double so_far = seconds_between(start_, now);
  if (!terminal_ || so_far < quiet_s_ || seconds_between(last_, now) < 0.25) return;
  last_ = now;
  const std::uint64_t done = skipped_ + done_;
  const double each = so_far / static_cast<double>(done_);
  const double rest = cases_ > done ? each * static_cast<double>(cases_ - done) : 0;
  program::show_line(fmt::format("{} of {} cases, {} findings, about {} left", done, cases_, findings_,
                                 program::duration_text(rest)));
  shown_ = true;
}

void StatusLine::clear() {
  if (!shown_) return;
  program::show_line("");
  shown_ = false;
}

}  // namespace tetproof::corpus
