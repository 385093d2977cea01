// SPDX-License-Identifier: GPL-3.0-or-later
// The table of known meshers.
#pragma once

#include <string>
#include <vector>

namespace tetproof::corpus {

/// One way to call a preset's program.
struct PresetVariant {
  std::string name;
  std::vector<std::string> words;  ///< as in `Tool`
  std::string what;                ///< what it is for, one line
  int repeats = 1;
  bool keeps_boundary = false;  ///< where the preset in general may change it
};

/// A known mesher.
struct Preset {
  std::string name;
  std::string what;
  std::vector<std::string> programs;  ///< names under which its program is installed
  std::vector<std::string> version;   ///< arguments that make it tell its version; empty: none do
  std::string version_word;           ///< in the line that tells it; empty: the first line
  std::string surface_ending, mesh_file;
  bool may_change_boundary = false;
  double fidelity = 0;
  int digits = -1;                                                         ///< as in `Tool`
  int own_verdict_exit = 0, own_failure_exit = 0, partly_judged_exit = 0;  ///< as in `Tool`
  bool coarse = false;                                                     ///< as in `Mesher`
  std::vector<PresetVariant> variants;                                     ///< the first is the default
};

const std::vector<Preset>& preset_table();

}  // namespace tetproof::corpus
