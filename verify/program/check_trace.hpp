// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a trace by the reference's own method, for tetproof-compare. Not installed.
#pragma once

#include <optional>
#include <string>

#include "io/triangle_surface.hpp"
#include "reference/options.hpp"
#include "verify/compare_traces.hpp"

namespace tetproof::verify {

/// Replays the trace at `path` on the surface from which it was made, with the trace's own settings, and
/// checks every decision. `surface`: a file or a generated surface; empty: the one that the trace names,
/// which is looked for where the program runs and then beside the trace. Throws InputError for a file that is
/// no trace, or that breaks off. `listener` hears how far the replay is.
CheckedTrace check_trace(const std::string& path, const std::string& surface,
                         const reference::Listener& listener = {});

/// The surface from which the trace was made, as `check_trace` finds it; none if it is not found, or if
/// `path` is no file that can be read twice. Throws InputError for a surface that cannot be read.
std::optional<TriangleSurface> surface_of_trace(const std::string& path, const std::string& surface);

/// The options of the run that made the trace at `path`, with `follow` set to it. Throws InputError for a
/// file that is no trace, and for one that asks for what no run can be asked for.
reference::Options options_of_trace(const std::string& path);

}  // namespace tetproof::verify
