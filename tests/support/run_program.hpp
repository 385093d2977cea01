// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a command for a test: no shell, standard output and error captured, exit code, time and peak memory.
#pragma once

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace tetproof::test {

/// What a command did.
struct Outcome {
  int exit_code = -1;        ///< -1 when a signal ended it
  int signal = 0;            ///< the signal that ended it, 0 if none; SIGALRM: it ran longer than allowed
  std::string out, err;      ///< standard output and standard error, whole
  double seconds = 0;        ///< wall time
  long peak_memory_kib = 0;  ///< largest resident set [KiB]; never below this test program's own at the start
};

/// How to run it.
struct RunOptions {
  std::string directory{};       ///< working directory; empty: the present one
  std::string input{};           ///< standard input
  unsigned timeout_s = 120;      ///< wall time allowed [s]; a longer run is ended by SIGALRM
  std::size_t memory_limit = 0;  ///< address space allowed [bytes], 0: unlimited; not under AddressSanitizer
  std::vector<std::string> environment{};  ///< further "NAME=value"
};

inline std::string text_of(int descriptor) {
  std::string text;
  char buffer[1 << 16];
  for (off_t at = 0;;) {
    const ssize_t got = ::pread(descriptor, buffer, sizeof buffer, at);
    if (got < 0) throw std::system_error(errno, std::generic_category(), "reading a program's output");
    if (got == 0) return text;
    text.append(buffer, static_cast<std::size_t>(got));
    at += got;
  }
}

/// Runs `command` (the program, looked up in PATH when it has no slash, and its arguments) and waits for its
/// end. A program that cannot be started exits with 127, as from a shell.
inline Outcome run_program(const std::vector<std::string>& command, const RunOptions& options = {}) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);

  // Files in memory rather than pipes: whatever the program writes, nothing can block.
  const int in = ::memfd_create("stdin", MFD_CLOEXEC), out = ::memfd_create("stdout", MFD_CLOEXEC),
            err = ::memfd_create("stderr", MFD_CLOEXEC);
  if (in < 0 || out < 0 || err < 0) throw std::system_error(errno, std::generic_category(), "memfd_create");
  if (::write(in, options.input.data(), options.input.size()) != static_cast<ssize_t>(options.input.size()))
    throw std::system_error(errno, std::generic_category(), "writing a program's input");
  ::lseek(in, 0, SEEK_SET);

  Outcome run;
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    ::dup2(in, 0), ::dup2(out, 1), ::dup2(err, 2);
    if (!options.directory.empty() && ::chdir(options.directory.c_str()) != 0) ::_exit(126);
    if (options.memory_limit) {
      const rlimit limit{options.memory_limit, options.memory_limit};
      ::setrlimit(RLIMIT_AS, &limit);
    }
    for (const std::string& variable : options.environment) ::putenv(const_cast<char*>(variable.c_str()));
    ::alarm(options.timeout_s);  // outlives exec
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }
  int status = 0;
  rusage usage{};
  while (::wait4(child, &status, 0, &usage) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "wait4");
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.peak_memory_kib = usage.ru_maxrss;
  if (WIFEXITED(status)) run.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) run.signal = WTERMSIG(status);
  run.out = text_of(out);
  run.err = text_of(err);
  ::close(in), ::close(out), ::close(err);
  return run;
}

/// GoogleTest prints a failed run with this.
inline std::ostream& operator<<(std::ostream& stream, const Outcome& run) {
  return stream << "exit code " << run.exit_code << ", signal " << run.signal << ", " << run.seconds << " s, "
                << run.peak_memory_kib << " KiB\nstandard output:\n"
                << run.out << "\nstandard error:\n"
                << run.err;
}

/// One of the project's programs as it was built, for example program("tetproof-verify").
inline std::string program(const std::string& name) {
  return std::string(TETPROOF_BINARY_DIR "/") + name;
}

/// True when `name` is found in PATH: for tests that let another tool read or write a file.
inline bool have_tool(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::string rest = path ? path : "";
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    if (::access((rest.substr(0, colon) + "/" + name).c_str(), X_OK) == 0) return true;
    rest = colon == std::string::npos ? "" : rest.substr(colon + 1);
  }
  return false;
}

/// Number of lines in `text`; an unfinished last one counts.
inline std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) +
         (!text.empty() && text.back() != '\n');
}

/// An empty folder of the test's own, removed with everything in it at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "tetproof-test-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), name);
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

  /// Writes a file of this folder and returns its path.
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(*this / name, std::ios::binary) << bytes;
    return *this / name;
  }
  /// The bytes of a file of this folder; throws when there is none.
  std::string read(const std::string& name) const {
    std::ifstream file(*this / name, std::ios::binary);
    if (!file) throw std::runtime_error(*this / name + " is missing");
    return {std::istreambuf_iterator<char>(file), {}};
  }
  bool has(const std::string& name) const { return std::filesystem::exists(*this / name); }
  /// Names of what lies in the folder, sorted: a half-written file beside the wanted one shows.
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      all.push_back(entry.path().filename().string());
    std::sort(all.begin(), all.end());
    return all;
  }

 private:
  std::string path_;
};

}  // namespace tetproof::test
