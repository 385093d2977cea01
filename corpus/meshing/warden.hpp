// SPDX-License-Identifier: GPL-3.0-or-later
// The process between this program and a command: it starts the command, watches its limits and ends all
// that it left behind.
#pragma once

#include <sys/types.h>

#include "corpus/meshing/process.hpp"

namespace tetproof::corpus {

/// What the warden is to do. Everything is made before the fork: after it nothing may be allocated.
struct Order {
  const char* program = nullptr;  ///< a path
  char* const* words = nullptr;
  char* const* environment = nullptr;
  const char* folder = nullptr;  ///< null: the present one
  Limits limits{};
  int output = -1;   ///< descriptor for the command's output
  int results = -1;  ///< descriptor to which `WardenReport` is written
  pid_t owner = 0;   ///< the process for which all this happens
};

/// What the warden writes at the end.
struct WardenReport {
  int status = 0;  ///< as from waitpid
  int error = 0;   ///< errno, if the command could not be started
  bool bad_folder = false;
  Limit limit = Limit::none;
  double cpu_s = 0, wall_s = 0;
  std::int64_t peak_bytes = 0;
};

/// Never returns. To be called in the child of a fork, with all signals blocked.
[[noreturn]] void be_warden(const Order& order);

}  // namespace tetproof::corpus
