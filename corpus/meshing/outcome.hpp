// SPDX-License-Identifier: GPL-3.0-or-later
// The classes of what a mesher can do with a valid surface.
#pragma once

#include <optional>
#include <string_view>

namespace tetproof::corpus {

enum class Outcome {
  sound,                  ///< a valid mesh that fills the surface
  wrong,                  ///< success, but the mesh is defective in itself
  wrong_against_surface,  ///< success, and a valid mesh, but not of this surface
  refused,                ///< gave up, and says so: a limit of its own, or no reason
  refused_valid,          ///< gave up because the surface is invalid, it says: it is valid
  crashed,                ///< ended by a signal, an assertion or an uncaught exception
  slow,                   ///< over its limit of CPU or wall time: no finding by itself
  out_of_memory,          ///< over its limit of memory, or says so
  no_output,              ///< success, and no file
  no_tetrahedra,          ///< success, and a file without tetrahedra
  unreadable,             ///< success, and a file that breaks its format
  not_compiled_in,        ///< says that what was asked for is not part of this build: no finding
  not_judged,  ///< a mesh whose verdict is incomplete or took too long: no finding, and never sound
};
inline constexpr int outcome_count = static_cast<int>(Outcome::not_judged) + 1;

/// Stable, in reports and journals: "sound", "wrong-answer", "wrong-against-surface", "refused",
/// "refused-valid", "crashed", "slow", "out-of-memory", "no-output", "no-tetrahedra", "unreadable",
/// "not-compiled-in", "not-judged".
const char* name_of(Outcome outcome);
std::optional<Outcome> outcome_of_name(std::string_view name);

/// Whether it makes a run of the fuzz driver fail: wrong, wrong_against_surface, refused_valid, crashed,
/// no_output, no_tetrahedra, unreadable. Refusals without a false claim, time and memory are counted only.
bool is_finding(Outcome outcome);

}  // namespace tetproof::corpus
