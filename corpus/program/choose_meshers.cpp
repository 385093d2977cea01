// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the meshers that a command line or a journal names.
#include <fmt/format.h>

#include "corpus/meshing/command_words.hpp"
#include "corpus/program/fuzz_options.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"

namespace tetproof::corpus {
namespace {

std::string ending_of_format(const std::string& name) {
  return format_named(name).endings.front();
}

ChosenMesher command(const MesherArguments& a) {
  const MesherArguments usual;
  if (!has_part(a.command, "{surface}"))
    throw InputError(
        fmt::format("COMMAND: expected {{surface}} among its words, found '{}'", command_line(a.command)));
  // A mesher that takes no name for its mesh puts it beside the surface: surface.1.ele.
  if (!has_part(a.command, "{mesh}") && a.mesh_ending == usual.mesh_ending)
    throw InputError(fmt::format("COMMAND: expected {{mesh}} among its words, or --mesh-ending, found '{}'",
                                 command_line(a.command)));
  if (!a.mesh_ending.starts_with('.'))
    throw InputError(
        fmt::format("--mesh-ending: expected a dot first, as in .msh, found '{}'", a.mesh_ending));
  if (!a.program.empty()) throw InputError("--program is for presets: COMMAND names its own program");
  ChosenMesher chosen;
  chosen.mesher = command_mesher({.words = a.command,
                                  .surface_ending = ending_of_format(a.surface_format),
                                  .mesh_ending = a.mesh_ending,
                                  .name = a.name});
  if (a.surface_format != usual.surface_format)
    chosen.words.insert(chosen.words.end(), {"--surface-format", a.surface_format});
  if (a.mesh_ending != usual.mesh_ending)
    chosen.words.insert(chosen.words.end(), {"--mesh-ending", a.mesh_ending});
  if (!a.name.empty()) chosen.words.insert(chosen.words.end(), {"--name", a.name});
  chosen.words.push_back("--");
  chosen.words.insert(chosen.words.end(), a.command.begin(), a.command.end());
  return chosen;
}

// "tetgen,pq,pY": "tetgen,pq" and "tetgen,pY"; "tetgen": all of its variants.
std::vector<std::string> names_of(const std::string& preset) {
  const std::size_t comma = preset.find(',');
  const std::string name = preset.substr(0, comma);
  if (comma == std::string::npos) return preset_variants(name);
  std::vector<std::string> names;
  for (std::size_t at = comma; at != std::string::npos;) {
    const std::size_t next = preset.find(',', at + 1);
    names.push_back(name + preset.substr(at, next == std::string::npos ? next : next - at));
    at = next;
  }
  return names;
}

}  // namespace

std::vector<ChosenMesher> choose_meshers(const MesherArguments& a) {
  if (!a.command.empty() && !a.presets.empty())
    throw InputError("expected either --mesher or a COMMAND, found both");
  if (a.command.empty() && a.presets.empty())
    throw InputError(
        "expected --mesher NAME, or -- COMMAND with {surface} and {mesh} (see tetproof-fuzz --help)");
  std::vector<ChosenMesher> all;
  if (!a.command.empty()) {
    all.push_back(command(a));
    return all;
  }
  const MesherArguments usual;
  if (a.surface_format != usual.surface_format || a.mesh_ending != usual.mesh_ending || !a.name.empty())
    throw InputError("--surface-format, --mesh-ending and --name are for a COMMAND: a preset has its own");
  for (const std::string& preset : a.presets)
    for (const std::string& name : names_of(preset)) {
      ChosenMesher chosen{preset_mesher(name, a.program), {"--mesher", name}};
      if (!a.program.empty()) chosen.words.insert(chosen.words.end(), {"--program", a.program});
      all.push_back(std::move(chosen));
    }
  return all;
}

std::vector<ChosenMesher> choose_meshers(const std::vector<std::string>& words) {
  CLI::App app;
  MesherArguments arguments;
  declare_mesher_options(app, arguments);
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 takes the last word first
  } catch (const CLI::ParseError& error) {
    throw InputError(
        fmt::format("the journal's words for the mesher, '{}': {}", fmt::join(words, " "), error.what()));
  }
  return choose_meshers(arguments);
}

}  // namespace tetproof::corpus
