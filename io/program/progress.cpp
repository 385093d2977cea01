// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/program/progress.hpp"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "io/bytes/one_line.hpp"
#include "io/program/program.hpp"

namespace tetproof::program {

bool shows_progress(const Common& common) {
  const char* const terminal = std::getenv("TERM");
  return !common.quiet && ::isatty(STDERR_FILENO) && terminal && std::string_view(terminal) != "dumb";
}

std::chrono::milliseconds quiet_time() {
  const char* const after = std::getenv("TETPROOF_PROGRESS_AFTER");
  return std::chrono::milliseconds(after ? std::clamp(std::atoi(after), 1, 1'000'000) : 2000);
}

void show_line(const std::string& line) {
  winsize size{};
  const std::size_t width =
      ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col : std::size_t{80};
  fmt::print(stderr, "\r\x1b[K{}", std::string_view(line).substr(0, width - 1));
  std::fflush(stderr);
}

std::string duration_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

Progress::Progress(const Common& common, std::vector<std::pair<std::string, double>> shares)
    : common_(common), shares_(std::move(shares)), start_(std::chrono::steady_clock::now()) {
  if (!shows_progress(common)) return;
  common.progress = this;
  line_ = std::thread([this] { show(); });
}

void Progress::enter(std::string_view phase) {
  const std::lock_guard lock(mutex_);
  phase_ = phase;
  done_ = total_ = 0;
  entered_ = so_far();
  before_ = share_ = 0;
  for (const auto& [name, share] : shares_) {
    if (name == phase) {
      share_ = share;
      return;
    }
    before_ += share;
  }
  before_ = 0;  // nothing is known of this phase
}

void Progress::at(std::uint64_t done, std::uint64_t total) {
  done_.store(done, std::memory_order_relaxed);
  total_.store(total, std::memory_order_relaxed);
}

ProgressListener Progress::listener() {
  if (!line_.joinable()) return {};
  return [this](std::string_view stage, std::uint64_t done, std::uint64_t total) {
    if (done == 0 && total == 0)
      enter(stage);
    else
      at(done, total);
  };
}

ProgressListener Progress::part_listener() {
  if (!line_.joinable()) return {};
  return [this](std::string_view, std::uint64_t done, std::uint64_t total) { at(done, total); };
}

void Progress::hide() {
  const std::lock_guard lock(mutex_);
  if (shown_) show_line("");
  shown_ = false;
}

void Progress::end() {
  if (!line_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_one();
  line_.join();
  hide();
  common_.progress = nullptr;
}

double Progress::so_far() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

std::string Progress::text() const {
  const auto done = done_.load(std::memory_order_relaxed), total = total_.load(std::memory_order_relaxed);
  const double part = total > 0 ? std::min(1.0, static_cast<double>(done) / static_cast<double>(total)) : 0;
  const double now = so_far();
  std::string line = phase_;
  if (total > 0)
    line += fmt::format(" {:.0f} %", 100 * part);
  else if (done > 0)
    line += fmt::format(" {}", done);
  line += ": " + duration_text(now);
  // A phase that does not tell its parts ends when the earlier ones say. Early in the work, errors in the
  // shares would make the estimate useless.
  const double share = before_ + share_ * part, time = total > 0 ? now : entered_;
  if (share >= 0.1 && share < 1 && time > share * now)
    line += fmt::format(", about {} left", duration_text(time / share - now));
  return io::in_one_line(line);  // phases may hold the names of files
}

void Progress::show() {
  using std::chrono_literals::operator""ms;
  std::unique_lock lock(mutex_);
  const std::chrono::milliseconds quiet = quiet_time();
  for (auto wait = quiet; !changed_.wait_for(lock, wait, [&] { return ended_; });
       wait = std::min(quiet, 250ms)) {
    if (phase_.empty()) continue;
    show_line(text());
    shown_ = true;
  }
}

}  // namespace tetproof::program
