// SPDX-License-Identifier: GPL-3.0-or-later
// The backtrace of a crash, from gdb.
#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/meshing/crash_words.hpp"
#include "corpus/meshing/output_lines.hpp"
#include "corpus/meshing/process.hpp"
#include "corpus/meshing/program_path.hpp"

namespace tetproof::corpus {

namespace {

/// The C and C++ libraries' way from a fault to its report. Their other functions are left out by the library
/// from which they come.
constexpr std::array own_ways{std::string_view{"__pthread_kill"},  std::string_view{"raise"},
                              std::string_view{"__GI_"},           std::string_view{"abort"},
                              std::string_view{"__assert"},        std::string_view{"__libc_message"},
                              std::string_view{"malloc_"},         std::string_view{"_int_"},
                              std::string_view{"__gnu_cxx::"},     std::string_view{"__cxxabi"},
                              std::string_view{"std::terminate"},  std::string_view{"__cxa_"},
                              std::string_view{"<signal handler"}, std::string_view{"std::__"}};

/// "#1  0x0000 in NAME (arguments) at FILE:LINE", or "... from LIBRARY". Empty: the frame is none of the
/// program's own, or no frame.
std::string frame_of(const std::string& line) {
  if (line.empty() || line[0] != '#') return "";
  std::size_t at = line.find_first_not_of("0123456789", 1);
  at = line.find_first_not_of(' ', at);
  if (at == std::string::npos) return "";
  if (line.compare(at, 2, "0x") == 0) {
    const std::size_t in = line.find(" in ", at);
    if (in == std::string::npos) return "";
    at = in + 4;
  }
  const std::string rest = line.substr(at);
  for (const std::string_view way : own_ways)
    if (rest.compare(0, way.size(), way) == 0) return "";
  const std::size_t from = rest.rfind(" from ");
  const std::string library = from == std::string::npos ? "" : rest.substr(rest.find_last_of("/ ") + 1);
  for (const std::string_view c : {"libc.so", "libc-", "ld-linux", "libstdc++", "libpthread", "libgomp",
                                   "libtbb", "libasan", "libubsan"})
    if (library.compare(0, c.size(), c) == 0) return "";
  // Debian's C library comes with its sources' places, relative to its own folder.
  for (const std::string_view folder : {" at ../sysdeps/", " at ./nptl/", " at ./stdlib/", " at ./malloc/",
                                        " at ./string/", " at ./assert/", " at ./debug/", " at ./libio/"})
    if (rest.find(folder) != std::string::npos) return "";
  const std::string declaration = rest.substr(0, from);
  if (declaration.compare(0, 2, "??") == 0) return library.empty() ? "?" : "? of " + library;
  // gdb puts a space before the arguments.
  return function_name(declaration);
}

}  // namespace

std::vector<std::string> own_frames(const std::vector<std::string>& lines) {
  std::vector<std::string> frames;
  for (const std::string& line : lines)
    if (const std::string frame = frame_of(line); !frame.empty()) frames.push_back(frame);
  return frames;
}

std::vector<std::string> backtrace(const std::vector<std::string>& command, const ProcessOptions& options,
                                   bool at_exit) {
  if (program_path("gdb").empty() || command.empty()) return {};
  const std::string program = program_path(command[0]);
  if (program.empty()) return {};
  std::vector<std::string> words{"gdb", "-batch", "-nx", "-q"};
  for (const char* line :
       {"set confirm off", "set debuginfod enabled off", "set pagination off", "set width 0",
        "set print frame-arguments none", "set print address on", "handle SIGPIPE nostop noprint pass",
        at_exit ? "catch syscall exit_group" : "", "run", "echo \\n=== backtrace\\n", "backtrace 40"}) {
    if (*line == 0) continue;
    words.emplace_back("-ex");
    words.emplace_back(line);
  }
  words.emplace_back("--args");
  words.push_back(program);
  words.insert(words.end(), command.begin() + 1, command.end());
  ProcessOptions more = options;
  more.environment.emplace_back("SHELL=/bin/sh");     // by which gdb starts the command
  more.limits.cpu_s = 2 * options.limits.cpu_s + 10;  // gdb reads the symbols of all libraries first
  more.limits.wall_s = 2 * options.limits.wall_s + 20;
  more.limits.memory_mb = options.limits.memory_mb + 1000;
  const ProcessEnd end = run_process(words, more);
  const std::vector<std::string> lines = output_lines(end.output);
  return own_frames({std::find(lines.begin(), lines.end(), "=== backtrace"), lines.end()});
}

}  // namespace tetproof::corpus
