// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a command within limits of time and memory, in a process group of its own.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tetproof::corpus {

struct Limits {
  double cpu_s = 5;               ///< CPU time of all its processes together [s]
  double wall_s = 60;             ///< [s]
  std::int64_t memory_mb = 2000;  ///< resident memory of all its processes together [10^6 bytes]
};

enum class Limit { none, cpu, wall, memory };

/// How a command ended.
struct ProcessEnd {
  int exit_code = -1;         ///< -1: a signal ended it
  int signal = 0;             ///< 0: it exited by itself
  Limit limit = Limit::none;  ///< the limit for which it was killed
  bool started = true;        ///< false: there is no such program
  std::string output;         ///< standard output and error together, in order; the middle is cut where long
  double cpu_s = 0, wall_s = 0;  ///< [s]
  std::int64_t peak_mb = 0;      ///< largest resident memory seen [10^6 bytes]
};

struct ProcessOptions {
  std::string folder{};  ///< working directory; empty: the present one
  Limits limits{};
  std::vector<std::string> environment{};  ///< further "NAME=value"
  std::size_t most_output = 1 << 20;       ///< bytes of output that are kept: the first and the last half
};

/// Runs `command` (the program, looked up in PATH, and its arguments; no shell) and waits until it has ended.
/// Its standard input is empty, its output line-buffered. All processes that it started are killed with it,
/// also those that moved to another process group or session, and also when this program dies.
ProcessEnd run_process(const std::vector<std::string>& command, const ProcessOptions& options = {});

/// The backtrace of a crash: the command is run once more under gdb, and the innermost frames of the crashed
/// thread are returned, innermost first, without those of the C library and of gdb. Empty: there is no gdb,
/// or it did not crash again. `at_exit`: where it ends by itself instead, for programs that report an
/// internal error and exit.
std::vector<std::string> backtrace(const std::vector<std::string>& command,
                                   const ProcessOptions& options = {}, bool at_exit = false);

/// The frames in what gdb prints, without those of the C library and of the libraries that start threads:
/// which of these are there depends on the thread that crashed.
std::vector<std::string> own_frames(const std::vector<std::string>& lines);

}  // namespace tetproof::corpus
