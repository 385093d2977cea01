// SPDX-License-Identifier: GPL-3.0-or-later
// All processes below this one, read from /proc, for code between fork and exec: nothing here allocates,
// throws or locks.
#pragma once

#include <sys/types.h>

#include <cstdint>

namespace tetproof::corpus {

/// What the processes below this one use now.
struct TreeUse {
  int processes = 0;  ///< zombies too
  std::int64_t cpu_ticks =
      0;                   /// of them and of their children that they waited for [1 / sysconf(_SC_CLK_TCK)]
  std::int64_t pages = 0;  ///< resident memory [pages]
};

/// Walks over the children of `root`, their children, and so on: at most 4096 processes. It sends `signal`
/// to each unless it is 0. Processes that start or end meanwhile may be missed.
TreeUse walk_process_tree(pid_t root, int signal);

}  // namespace tetproof::corpus
