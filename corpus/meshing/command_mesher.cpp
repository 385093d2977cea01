// SPDX-License-Identifier: GPL-3.0-or-later
// A mesher given as a command line.
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "corpus/meshing/command_words.hpp"
#include "corpus/meshing/mesher.hpp"
#include "corpus/meshing/program_path.hpp"
#include "corpus/meshing/tool_mesher.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {

std::unique_ptr<Mesher> command_mesher(CommandMesher command) {
  if (command.words.empty()) throw InputError("the mesher's command is empty");
  if (!has_part(command.words, "{surface}")) throw InputError("the mesher's command has no {surface}");
  Tool tool;
  tool.program = program_path(command.words[0]);
  if (tool.program.empty()) throw InputError(command.words[0] + ": there is no such program");
  tool.name = command.name;
  if (tool.name.empty()) tool.name = command.words[0].substr(command.words[0].find_last_of('/') + 1);
  // A program that takes no name for its mesh puts it beside the surface, as TetGen does: surface.1.ele.
  tool.mesh_file = (has_part(command.words, "{mesh}") ? "mesh" : "surface") + command.mesh_ending;
  tool.words = std::move(command.words);
  tool.surface_ending = std::move(command.surface_ending);
  tool.repeats = std::max(1, command.repeats);
  return tool_mesher(std::move(tool));
}

}  // namespace tetproof::corpus
