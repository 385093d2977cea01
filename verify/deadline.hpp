// SPDX-License-Identifier: GPL-3.0-or-later
// The time after which a verdict is given up.
#pragma once

#include <chrono>
#include <optional>
#include <stdexcept>

namespace tetproof::verify {

/// Absent: a verdict may take as long as it needs.
using Deadline = std::optional<std::chrono::steady_clock::time_point>;

/// Thrown by `verify` after `Options::deadline`.
struct OutOfTime : std::runtime_error {
  OutOfTime() : std::runtime_error("the verdict took longer than allowed") {}
};

/// Throws OutOfTime if the deadline is over.
inline void keep(const Deadline& deadline) {
  if (deadline && std::chrono::steady_clock::now() > *deadline) throw OutOfTime();
}

}  // namespace tetproof::verify
