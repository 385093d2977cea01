// SPDX-License-Identifier: GPL-3.0-or-later
// Runs both engines on one surface, and tells where their decisions part.
#pragma once

#include <string>
#include <vector>

#include "reference/generate.hpp"

namespace tetproof::test {

/// One run of an engine.
struct EngineRun {
  std::vector<std::string> lines;  ///< its records, as lines of the trace; without the settings
  reference::Generation made;
  std::string refusal;  ///< the message, where the engine refuses the surface or the options as bad input
};

EngineRun run_engine(const TriangleSurface& surface, reference::Options options, reference::Engine engine);

struct BothEngines {
  EngineRun fast, page;
  std::size_t equal_lines = 0;  ///< the number of lines before the first one that differs
  bool equal = false;           ///< whether all lines are equal to the byte, and the reports agree
  std::int64_t ties = 0;        ///< of a trace that is not equal: the ties that its replay proves
  /// Why the page is not equal and its trace is not a proven tie; empty if all is well.
  std::string fault;
};

/// Runs both engines. Where their traces differ in step (vi), `reference::follow` replays the page's trace.
BothEngines run_both(const TriangleSurface& surface, const reference::Options& options);

}  // namespace tetproof::test
