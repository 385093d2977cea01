// SPDX-License-Identifier: GPL-3.0-or-later
// Declares and parses the options of tetproof-fuzz. Not installed.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "corpus/fuzz_campaign.hpp"

namespace tetproof::corpus {

/// How the command line names the meshers.
struct MesherArguments {
  std::vector<std::string> presets;  ///< "NAME" or "NAME,VARIANT,..."
  std::string program;               ///< the place of the preset's program; empty: as the preset says
  std::vector<std::string> command;  ///< after --
  std::string surface_format = "off", mesh_ending = ".msh", name;
};

/// How the command line names programs that are no meshers: checkers of meshes, readers of files.
struct OtherArguments {
  std::vector<std::string> judge, reader;  ///< each a COMMAND or a preset
  std::string says, says_sound;            ///< expressions
  std::vector<std::string> formats;
};

/// The command line's arguments.
struct FuzzArguments {
  MesherArguments mesher;
  OtherArguments others;
  std::uint64_t seed = 1, cases = 100;
  bool cases_given = false;
  std::string shard, shards;
  FuzzOptions surfaces;
  Limits limits;
  JudgeOptions judge;
  int repeats = 0;
  double shrink_s = 0;
  std::string out, known, junit, html, replay;
  std::vector<std::string> merge;
  bool list_kinds = false, print_preset = false;
};

/// Adds all options to `app`, which fills `a`.
void declare_options(CLI::App& app, FuzzArguments& a);
/// Adds those that choose the mesher.
void declare_mesher_options(CLI::App& app, MesherArguments& a);

/// A mesher with the words of the command line that choose it.
struct ChosenMesher {
  std::unique_ptr<Mesher> mesher;
  std::vector<std::string> words;
};

/// The meshers that are asked for; presets with all their variants where none is named. InputError if there
/// are none, or presets and a COMMAND, or if a COMMAND lacks {surface} or {mesh}.
std::vector<ChosenMesher> choose_meshers(const MesherArguments& a);
/// The same from the words that a journal has.
std::vector<ChosenMesher> choose_meshers(const std::vector<std::string>& words);

}  // namespace tetproof::corpus
