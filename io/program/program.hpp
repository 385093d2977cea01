// SPDX-License-Identifier: GPL-3.0-or-later
// What every tetproof program does the same way: common options, exit codes, one-line errors, threads.
// Not installed: the libraries do not know about programs.
#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
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

/// What a program says of itself.
struct Description {
  std::string purpose;                 ///< one sentence
  std::string examples;                ///< shown first by --help
  std::vector<std::string> libraries;  ///< name and version of what it links beyond what all programs link
};

/// Runs a program. `declare` adds the program's own options to `app` and returns what to do once they are
/// parsed: a function that returns an exit code. Adds --quiet, --json, --threads, --version and --help, and
/// turns exceptions into exit codes: InputError and usage errors 2, all others 3.
int run(int argc, char** argv, const Description& description,
        const std::function<std::function<int()>(CLI::App& app, Common& common)>& declare);

/// Talk: a line on standard error, unless --quiet.
void say(const Common& common, const std::string& line);

/// A line on the terminal for work that takes longer than two seconds: the phase, the time so far and an
/// estimate of the rest. Nothing where standard error is no terminal, or with --quiet.
class Progress {
 public:
  /// `shares`: the phases in their order, each with its typical part of the whole time.
  Progress(const Common& common, std::vector<std::pair<std::string, double>> shares);
  ~Progress() { end(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void enter(std::string_view phase);
  void end();  ///< takes the line away

 private:
  void show();

  std::vector<std::pair<std::string, double>> shares_;
  std::chrono::steady_clock::time_point start_;
  std::string phase_;
  double done_ = 0;  ///< the share of the phases before this one
  bool ended_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread line_;
};

/// Writes `text` to `path` whole or not at all (written beside, then renamed); "-" is standard output.
/// Throws InputError when the place cannot be written.
void write_text(const std::string& path, const std::string& text);

}  // namespace tetproof::program
