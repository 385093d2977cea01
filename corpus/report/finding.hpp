// SPDX-License-Identifier: GPL-3.0-or-later
// A finding as a folder that the maintainer of a mesher can act on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "corpus/fuzz_surface.hpp"
#include "corpus/meshing/judgement.hpp"
#include "corpus/meshing/mesher.hpp"

namespace tetproof::corpus {

/// All that is known about one failure when its folder is written.
struct FindingFacts {
  std::uint64_t seed = 1, index = 0;  ///< the case that it was found with
  FuzzSurface original;
  TriangleSurface shrunk;       ///< still fails in the same way; equals the original if it was not shrunk
  std::string shrunk_recipe{};  ///< empty: the shrunk surface is no longer what a recipe builds
  std::string shrink_steps{};
  const Mesher* mesher = nullptr;
  MesherRun run;                          ///< of the shrunk surface; its mesh file still exists
  Judgement judgement;                    ///< of `run`
  std::vector<std::string> checks{};      ///< the only ones that were asked for; empty: all
  int repeats = 1, failed = 1;            ///< of the shrunk surface: "3 of 20"
  std::int64_t cases = 1, cases_run = 1;  ///< how many of all cases fall into this group
  /// The folder in which `run` was made, whose files called "surface" (in the mesher's own format, with what
  /// else it got) are copied. Empty: the folder of `run.mesh_file`; if there is none, the surface is written
  /// anew.
  std::string run_folder{};
  std::string since{};  ///< the first version that does it, if known
};

/// Writes the folder `folder` (which does not exist yet, and appears complete or not at all): README.md (ten
/// lines: what is wrong, an exact statement that can be checked without this project, the command, how
/// often), the shrunk surface in the mesher's own format and as .off, the original, what the mesher wrote and
/// printed, its version, report.json, and picture.svg; and finding.json, with the statements that
/// corpus/findings/check.py proves or refutes. Without times: the same facts give the same bytes. InputError
/// if the folder exists or cannot be written.
void write_finding(const std::string& folder, const FindingFacts& facts);

}  // namespace tetproof::corpus
