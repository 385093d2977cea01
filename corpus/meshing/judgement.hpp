// SPDX-License-Identifier: GPL-3.0-or-later
// Judges in this process what a mesher wrote: first the mesh alone, then against the surface.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "corpus/fuzz_surface.hpp"
#include "corpus/meshing/mesher.hpp"
#include "verify/report.hpp"
#include "verify/surface.hpp"
#include "verify/verify.hpp"

namespace tetproof::corpus {

struct JudgeOptions {
  /// Allowed distance between boundary and surface, in box diagonals, before rounding is added; for meshers
  /// that must keep the boundary.
  double tolerance = 1e-9;
  double seconds = 20;               ///< for the verdict; beyond: not_judged
  std::vector<std::string> check{};  ///< ids as for tetproof-verify; empty: all
};

/// The verdict on one run of a mesher.
struct Judgement {
  Outcome outcome = Outcome::sound;
  /// "inverted", "overlap", ...: the root check of a wrong answer; else the run's signature. Together with
  /// the outcome it names the group.
  std::string signature{};
  std::string what{};                      ///< one sentence: the first finding, or what the mesher said
  std::optional<verify::Report> report{};  ///< of pass 1, or of pass 2 if pass 1 found nothing
  double allowed = 0;                      ///< distance allowed in pass 2 [length]
  double seconds = 0;                      ///< of the verdict
};

/// Sets how pass 2 judges: whether the mesh fills the surface, strictly or as a grid from a coarse lattice,
/// whose box and topology may differ. `options` has its checks already.
void set_against_surface(verify::Options& options, bool coarse);

/// Judges. Pass 1 judges the mesh alone. Pass 2 compares it with the surface: distance, volume, regions, and
/// topology always. The tolerance of pass 2 is `tolerance` (or the mesher's own `fidelity`) times the
/// diagonal, plus eight units in the last place of the largest coordinate, plus half a unit of the last digit
/// that a text file has. If the surface's file rounded it, the mesh is compared with what the mesher got.
Judgement judge_run(const MesherRun& run, const Mesher& mesher, const verify::JudgedSurface& surface,
                    const JudgeOptions& options = {});

}  // namespace tetproof::corpus
