// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a program: common options, exit codes, errors in one line, threads, output of text and JSON.
// Not installed: the libraries do not know about programs.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "io/program/arguments.hpp"
#include "io/program/progress.hpp"

namespace tetproof::program {

/// The exit codes of all programs.
enum ExitCode : int {
  sound = 0,        ///< done, and nothing is wrong
  wrong = 1,        ///< done, and something is wrong with what was judged
  bad_input = 2,    ///< bad input or usage; one line on standard error, nothing written
  own_failure = 3,  ///< our own failure; what to report on standard error
  incomplete = 4,   ///< nothing wrong was found, and not everything could be judged
};

/// Options that every program has.
struct Common {
  bool quiet = false;
  std::string json;  ///< a file, "-" for standard output, empty for none
  int threads = 0;   ///< 0: all
  /// The line of progress on the terminal, which `say` has to remove first; null: there is none.
  mutable Progress* progress = nullptr;
};

/// The texts of --help and --version that differ from program to program.
struct Description {
  std::string purpose;                 ///< one sentence
  std::string examples;                ///< shown first by --help
  std::vector<std::string> libraries;  ///< names and versions of libraries that not every program links
  Choices choices{};  ///< for completion: values that no placeholder tells, see arguments.hpp
};

/// Runs a program. `declare` adds the program's own options to `app` and returns the program's work: a
/// function that is called after the options are parsed and returns an exit code. `run` adds --quiet, --json,
/// --threads, --version and --help; and, as the only arguments, --help-man and --completion bash|zsh|fish,
/// which print the manual page and a shell's completion for the installation. It turns exceptions into exit
/// codes: InputError and usage errors into 2, all others into 3.
int run(int argc, char** argv, const Description& description,
        const std::function<std::function<int()>(CLI::App& app, Common& common)>& declare);

/// Writes a line to standard error, unless --quiet. Control characters, which names from files can bring, are
/// shown as "\x1B" and the like.
void say(const Common& common, const std::string& line);

/// Writes `text` to `path` whole or not at all; "-" is standard output. Throws an InputError if it cannot be
/// written.
void write_text(const std::string& path, const std::string& text);
/// Writes `json`, indented. Bytes that are not UTF-8, as file names can have them, are replaced.
void write_json(const std::string& path, const nlohmann::ordered_json& json);

}  // namespace tetproof::program
