// SPDX-License-Identifier: GPL-3.0-or-later
// A mesher that is a program: what command meshers and presets have in common.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "corpus/meshing/command_words.hpp"
#include "corpus/meshing/mesher.hpp"

namespace tetproof::corpus {

/// A program with all that is to be known about it.
struct Tool {
  std::string name;
  /// With {surface} and {mesh}, the files' paths; {box}, the box's diagonal; {size}, a twelfth of it;
  /// {distance}, 4e-4 of it [length]; {volume}, a two hundredth of the solid's volume [length^3].
  std::vector<std::string> words;
  std::string program{};  ///< the path that is run in place of `words[0]`
  std::string surface_ending = ".off";
  std::string mesh_file = "mesh.msh";  ///< what {mesh} stands for, a name in the folder
  bool may_change_boundary = false;
  double fidelity = 0;
  int repeats = 1;
  int digits = -1;  ///< as in `MesherRun`; -1: as the file shows
  /// Exit codes that mean more than "gave up", 0: none. It says that its own mesh is empty or defective; that
  /// it broke down; that it judged a part of its mesh only, which it has written.
  int own_verdict_exit = 0, own_failure_exit = 0, partly_judged_exit = 0;
  bool coarse = false;  ///< as in `Mesher`
  std::vector<std::string> environment{};
  std::string version{};
};

/// What a command's words stand for, for this surface: as `Tool::words` says.
Placeholders placeholders(const TriangleSurface& surface, const std::string& surface_file,
                          const std::string& mesh_file);

std::unique_ptr<Mesher> tool_mesher(Tool tool);

}  // namespace tetproof::corpus
