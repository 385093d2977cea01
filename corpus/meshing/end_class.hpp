// SPDX-License-Identifier: GPL-3.0-or-later
// What the end of a mesher's process and its words mean.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "corpus/meshing/outcome.hpp"
#include "corpus/meshing/process.hpp"

namespace tetproof::corpus {

/// The class of an end, before anyone looks for the mesh.
struct EndClass {
  std::optional<Outcome> failure{};  ///< absent: success, as far as its exit code and words tell
  std::string signature{};           ///< as in `MesherRun`
  std::string message{};             ///< as in `MesherRun`
  std::vector<std::string> warnings{};
  /// A crash whose words do not say where it happened: a backtrace would tell more.
  bool wants_backtrace = false;
  bool by_exit = false;  ///< no signal ended it: the backtrace is that of its exit
};

EndClass classify_end(const ProcessEnd& end);

/// Runs a command that crashed once more under gdb, as `options` say, and adds the innermost three frames of
/// the program's own to the signature: "SIGSEGV in f < g < h". Without gdb it stays as it is.
void add_backtrace(const std::vector<std::string>& command, const ProcessOptions& options, EndClass& end);

/// "SIGSEGV" for 11.
std::string signal_name(int signal);

}  // namespace tetproof::corpus
