// SPDX-License-Identifier: GPL-3.0-or-later
// What a user can type after a program's name, for man pages and completion: CLI11's options in plain terms.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace tetproof::program {

/// The values that an option or another argument can have, by its name ("--check") or, for all that have this
/// placeholder, by its placeholder ("FORMAT").
using Choices = std::map<std::string, std::vector<std::string>>;

/// An option, a flag, or an argument without a name (MESH).
struct Argument {
  enum class Kind { flag, word, choice, list, file, folder, command };

  std::vector<std::string> names;    ///< with their dashes, the short one first; empty: by its position
  std::string value;                 ///< the placeholder: "N", "FILE.json", "inside|outside"; empty: a flag
  std::string limits;                ///< of the value, in words: "whole number in [0 - 4096]"; empty: none
  std::string standard;              ///< the value without the option; empty: none
  std::string help;                  ///< the text of --help
  std::string group;                 ///< the heading in --help
  bool required = false;             ///< the program does nothing without it
  bool repeats = false;              ///< several values are taken
  Kind kind = Kind::word;            ///< what completion offers for the value
  std::vector<std::string> choices;  ///< the values of Kind::choice and of the parts of Kind::list
};

/// All arguments that --help shows, in its order, without --help itself's details: an option that CLI11 hides
/// is left out. A placeholder tells what completes it: FILE, GRID, MESH and the like are files, DIR is a
/// folder, and words in lower case with "|" between them are the choices, unless `choices` says more.
std::vector<Argument> arguments_of(const CLI::App& app, const Choices& choices);

/// The program's manual page, section 1, in roff (man macros). `purpose` is its description; `examples` are
/// lines as in --help; `closing` is what --help says last.
std::string man_page(const CLI::App& app, const Choices& choices, const std::string& purpose,
                     const std::string& examples, const std::string& closing, const std::string& version);

/// A script that makes `shell` (bash, zsh or fish) complete the program's arguments. InputError for another
/// shell.
std::string completion(const CLI::App& app, const Choices& choices, const std::string& shell);

}  // namespace tetproof::program
