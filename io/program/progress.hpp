// SPDX-License-Identifier: GPL-3.0-or-later
// The line on a terminal that shows how far a program is. Not installed.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "io/progress.hpp"

namespace tetproof::program {

struct Common;

/// Shows a line on the terminal when work takes longer than two seconds: the phase, how much of it is done,
/// the time so far and an estimate of the rest. The line is gone at the end. Shows nothing if standard error
/// is not a terminal that can remove a line, or with --quiet.
class Progress {
 public:
  /// `shares`: the phases in their order, each with its typical share of the whole time. Phases that are not
  /// among them are shown without an estimate.
  explicit Progress(const Common& common, std::vector<std::pair<std::string, double>> shares = {});
  ~Progress() { end(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void enter(std::string_view phase);
  /// What of the phase is done. Without a total the number itself is shown. Any thread may call it.
  void at(std::uint64_t done, std::uint64_t total);
  /// Enters the stages of a library as phases, and takes over what is done of them. It must not be called
  /// when the Progress is gone.
  ProgressListener listener();
  /// Takes over what a library says is done of a stage, and stays in its own phase. As above.
  ProgressListener part_listener();
  void hide();  ///< before another line is printed; the next quarter of a second shows it again
  void end();   ///< removes the line for good

 private:
  void show();
  double so_far() const;  // [s]
  std::string text() const;

  const Common& common_;
  std::vector<std::pair<std::string, double>> shares_;
  std::chrono::steady_clock::time_point start_;
  std::string phase_;
  double before_ = 0, share_ = 0;  ///< the shares of the earlier phases, added up, and that of this one
  double entered_ = 0;             ///< when this phase began [s]
  std::atomic<std::uint64_t> done_ = 0, total_ = 0;
  bool ended_ = false, shown_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread line_;
};

/// Whether lines of progress are wanted: standard error is a terminal that can remove a line, and not
/// --quiet.
bool shows_progress(const Common& common);
/// How long work is quiet: two seconds, or what TETPROOF_PROGRESS_AFTER says, in milliseconds (for tests).
std::chrono::milliseconds quiet_time();
/// Shows `line` in place of the one that is shown, cut to the width of the terminal. Empty: removes it.
void show_line(const std::string& line);
/// "42 s", "7 min", "3.2 h": about so long.
std::string duration_text(double seconds);

}  // namespace tetproof::program
