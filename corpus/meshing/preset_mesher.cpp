// SPDX-License-Identifier: GPL-3.0-or-later
// Known meshers by name: finds their programs and asks for their versions.
#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "corpus/meshing/mesher.hpp"
#include "corpus/meshing/output_lines.hpp"
#include "corpus/meshing/preset_table.hpp"
#include "corpus/meshing/process.hpp"
#include "corpus/meshing/program_path.hpp"
#include "corpus/meshing/tool_mesher.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {

namespace {

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

const Preset& preset_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Preset& preset : preset_table()) {
    if (preset.name == name) return preset;
    names.push_back(preset.name);
  }
  throw InputError(fmt::format("there is no preset {}; the presets are {}", name, joined(names, ", ")));
}

/// "TETPROOF_CGAL" names the program of "cgal".
std::string variable_of(const Preset& preset) {
  std::string name = "TETPROOF_" + preset.name;
  for (char& c : name)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return name;
}

/// Empty: it is not installed.
std::string find_program(const Preset& preset) {
  if (const char* path = std::getenv(variable_of(preset).c_str()); path && *path) return program_path(path);
  for (const std::string& program : preset.programs) {
    // Programs of a build lie in its folder, its tests in folders below.
    for (std::string folder = own_folder(); folder.size() > 1; folder = folder.substr(0, folder.rfind('/')))
      if (std::string path = program_path(folder + "/" + program); !path.empty()) return path;
    if (std::string path = program_path(program); !path.empty()) return path;
  }
  return "";
}

std::string ask_version(const Preset& preset, const std::string& program) {
  if (preset.version.empty()) return "";
  std::vector<std::string> command{program};
  command.insert(command.end(), preset.version.begin(), preset.version.end());
  ProcessOptions options;
  options.limits = {5, 10, 2000};
  for (const std::string& line : output_lines(run_process(command, options).output)) {
    const std::size_t at = line.find(preset.version_word);
    if (line.find_first_not_of(' ') != std::string::npos && at != std::string::npos)
      return line.substr(line.find_first_not_of(' '));
  }
  return "";
}

/// Asks each program once.
std::string version_of(const Preset& preset, const std::string& program) {
  static std::mutex mutex;
  static std::map<std::string, std::string> known;
  const std::lock_guard lock(mutex);
  const auto found = known.find(preset.name + program);
  if (found != known.end()) return found->second;
  return known[preset.name + program] = ask_version(preset, program);
}

}  // namespace

std::unique_ptr<Mesher> preset_mesher(const std::string& name, const std::string& path) {
  const std::size_t comma = name.find(',');
  const std::string preset_name = name.substr(0, comma);
  const Preset& preset = preset_named(preset_name);
  const PresetVariant* variant = comma == std::string::npos ? &preset.variants.front() : nullptr;
  std::vector<std::string> names;
  for (const PresetVariant& v : preset.variants) {
    names.push_back(v.name);
    if (comma != std::string::npos && v.name == name.substr(comma + 1)) variant = &v;
  }
  if (!variant)
    throw InputError(fmt::format("the preset {} has no variant {}; it has {}", preset.name,
                                 name.substr(comma + 1), joined(names, ", ")));
  Tool tool;
  tool.program = path.empty() ? find_program(preset) : program_path(path);
  if (tool.program.empty())
    throw InputError(
        path.empty()
            ? fmt::format("the program of the preset {} is not installed: {} (or set {} to its path)",
                          preset.name, joined(preset.programs, " or "), variable_of(preset))
            : path + ": there is no such program");
  tool.name = preset.name + "," + variant->name;
  tool.words = variant->words;
  tool.surface_ending = preset.surface_ending;
  tool.mesh_file = preset.mesh_file;
  // TetGen's -Y: the boundary must stay as it is.
  tool.may_change_boundary = preset.may_change_boundary && !variant->keeps_boundary;
  tool.fidelity = tool.may_change_boundary ? preset.fidelity : 0;
  tool.repeats = variant->repeats;
  tool.digits = preset.digits;
  tool.own_verdict_exit = preset.own_verdict_exit;
  tool.own_failure_exit = preset.own_failure_exit;
  tool.partly_judged_exit = preset.partly_judged_exit;
  tool.coarse = preset.coarse;
  tool.version = version_of(preset, tool.program);
  return tool_mesher(std::move(tool));
}

std::vector<std::string> preset_variants(const std::string& name) {
  const std::size_t comma = name.find(',');
  const std::string preset_name = name.substr(0, comma);
  const Preset& preset = preset_named(preset_name);
  std::vector<std::string> result;
  for (const PresetVariant& variant : preset.variants)
    if (comma == std::string::npos || variant.name == name.substr(comma + 1))
      result.push_back(preset.name + "," + variant.name);
  if (result.empty()) preset_mesher(name);  // says which variants there are
  return result;
}

std::string list_presets() {
  std::string text;
  for (const Preset& preset : preset_table()) {
    const std::string program = find_program(preset);
    const std::string version = program.empty() ? "" : version_of(preset, program);
    text += fmt::format("{}: {}. ", preset.name, preset.what);
    text += program.empty() ? fmt::format("Not installed: {}\n", joined(preset.programs, " or "))
                            : fmt::format("{}{}\n", program, version.empty() ? "" : " (" + version + ")");
    for (const PresetVariant& variant : preset.variants) {
      text += fmt::format("  {},{}  {}{}\n", preset.name, variant.name, variant.what,
                          variant.repeats > 1 ? fmt::format("; {} runs of each case", variant.repeats) : "");
      text += fmt::format("      {}\n", joined(variant.words, " "));
    }
  }
  return text +
         "In place of {surface} and {mesh} stand the files; of {box}, the box's diagonal; of {size}, a "
         "twelfth of it; "
         "of\n{distance}, 4e-4 of it; of {volume}, a two hundredth of the solid's volume.\n";
}

}  // namespace tetproof::corpus
