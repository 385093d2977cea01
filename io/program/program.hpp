// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a program: common options, exit codes, errors in one line, threads, progress, output of text and JSON.
// Not installed: the libraries do not know about programs.
#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

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
};

/// The texts of --help and --version that differ from program to program.
struct Description {
  std::string purpose;                 ///< one sentence
  std::string examples;                ///< shown first by --help
  std::vector<std::string> libraries;  ///< names and versions of libraries that not every program links
};

/// Runs a program. `declare` adds the program's own options to `app` and returns the program's work: a
/// function that is called after the options are parsed and returns an exit code. `run` adds --quiet, --json,
/// --threads, --version and --help. It turns exceptions into exit codes: InputError and usage errors into 2,
/// all others into 3.
int run(int argc, char** argv, const Description& description,
        const std::function<std::function<int()>(CLI::App& app, Common& common)>& declare);

/// Writes a line to standard error, unless --quiet. Control characters, which names from files can bring, are
/// shown as "\x1B" and the like.
void say(const Common& common, const std::string& line);

/// Shows a line on the terminal when work takes longer than two seconds: the phase, the time so far and an
/// estimate of the rest. Shows nothing if standard error is not a terminal, or with --quiet.
class Progress {
 public:
  /// `shares`: the phases in their order, each with its typical share of the whole time.
  Progress(const Common& common, std::vector<std::pair<std::string, double>> shares);
  ~Progress() { end(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void enter(std::string_view phase);
  void end();  ///< removes the line

 private:
  void show();

  std::vector<std::pair<std::string, double>> shares_;
  std::chrono::steady_clock::time_point start_;
  std::string phase_;
  double done_ = 0;  ///< the shares of the earlier phases, added up
  bool ended_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread line_;
};

/// Writes `text` to `path` whole or not at all; "-" is standard output. Throws an InputError if it cannot be
/// written.
void write_text(const std::string& path, const std::string& text);
/// Writes `json`, indented. Bytes that are not UTF-8, as file names can have them, are replaced.
void write_json(const std::string& path, const nlohmann::ordered_json& json);

}  // namespace tetproof::program
