// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the settings of two runs.
#pragma once

#include "verify/compare/tolerance.hpp"
#include "verify/compare/trace_differences.hpp"

namespace tetproof::verify {

struct TracedSettings {
  const trace::Settings& settings;
  std::int64_t line;  ///< 0: the trace has no settings record, and `settings` are the defaults
};

/// Adds one difference that lists all settings that differ. `program` and `surface` are not compared,
/// `improve_below` only if one of the runs improves, and the settings of steps (v) and (vi) only if one of
/// the runs makes these steps.
void compare_settings(const TracedSettings& reference, const TracedSettings& other,
                      const Tolerance& tolerance, Differences& differences);

}  // namespace tetproof::verify
