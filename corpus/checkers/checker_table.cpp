// SPDX-License-Identifier: GPL-3.0-or-later
// The known checkers. What they print was seen with Gmsh 4.8 and TetGen 1.5.
#include <fmt/format.h>

#include "corpus/checkers/checker.hpp"
#include "corpus/meshing/command_words.hpp"
#include "corpus/meshing/program_path.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

struct Preset {
  Checker checker;
  const char* what;
  std::vector<std::string> version_words{};
};

const std::vector<Preset>& table() {
  static const std::vector<Preset> all{
      {{.name = "tetproof-verify",
        .words = {"tetproof-verify", "{mesh}"},
        .format = "msh22",
        .mesh_ending = ".msh",
        .rule = {.unread_exits = {2, 3, 4}}},
       "exit code 0: sound, 1: defective, others: no verdict",
       {"--version"}},
      {{.name = "gmsh",
        .words = {"gmsh", "-check", "{mesh}"},
        .format = "msh22",
        .mesh_ending = ".msh",
        .rule = {.defective = "^(Warning|Error) *:", .unread = "Error loading"}},
       "warnings, errors or an exit code: defective",
       {"--version"}},
      {{.name = "tetgen",
        .words = {"tetgen", "-rC", "{mesh}"},
        .format = "tetgen",
        .mesh_ending = ".ele",
        .rule = {.defective = "!!|invalid vertex index", .sound = "appears to be consistent"}},
       "'!!' or an invalid index: defective; 'appears to be consistent': sound"}};
  return all;
}

std::string path_of(const std::string& program) {
  const std::string beside = program_path(own_folder() + "/" + program);
  return !own_folder().empty() && !beside.empty() ? beside : program_path(program);
}

}  // namespace

Checker preset_checker(const std::string& name) {
  for (const Preset& preset : table()) {
    if (preset.checker.name != name) continue;
    Checker checker = preset.checker;
    const std::string path = path_of(checker.words[0]);
    if (path.empty())
      throw InputError(fmt::format("--judge {}: {} is not installed", name, checker.words[0]));
    checker.words[0] = path;
    if (!preset.version_words.empty()) {
      std::vector<std::string> words{path};
      words.insert(words.end(), preset.version_words.begin(), preset.version_words.end());
      const std::string said = run_process(words).output;
      checker.version = said.substr(0, said.find('\n'));
    }
    return checker;
  }
  std::vector<std::string> names;
  for (const Preset& preset : table()) names.push_back(preset.checker.name);
  throw InputError(fmt::format("--judge: expected a COMMAND with {{mesh}}, or one of {}, found '{}'",
                               fmt::join(names, ", "), name));
}

std::string list_checkers() {
  std::string text;
  for (const Preset& preset : table()) {
    const Checker& c = preset.checker;
    text += fmt::format("{}\n  {}   (mesh: {}, {})\n  {}\n", c.name, command_line(c.words), c.mesh_ending,
                        c.format, preset.what);
  }
  return text;
}

}  // namespace tetproof::corpus
