// SPDX-License-Identifier: GPL-3.0-or-later
// One line for each repetition of a work that formats.py times.
#pragma once

#include <time.h>

#include <cstdio>

namespace tetproof::bench {

inline double now(clockid_t clock) {
  timespec time{};
  ::clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Prints "seconds WALL cpu CPU" of what `work` takes.
template <class Work>
void timed(const Work& work) {
  const double start = now(CLOCK_MONOTONIC), cpu_start = now(CLOCK_PROCESS_CPUTIME_ID);
  work();
  const double cpu = now(CLOCK_PROCESS_CPUTIME_ID) - cpu_start, wall = now(CLOCK_MONOTONIC) - start;
  std::printf("seconds %.9g cpu %.9g\n", wall, cpu);
}

}  // namespace tetproof::bench
