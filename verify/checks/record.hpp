// SPDX-License-Identifier: GPL-3.0-or-later
// The record that the checks write while a mesh is judged: suspects, measured values, notes. Internal.
#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <vector>

#include "verify/checks/suspects.hpp"
#include "verify/verify.hpp"

namespace tetproof::verify {

class Record {
 public:
  /// Wants the checks that the options ask for; those that need a surface, only with one. InputError for an
  /// unknown id.
  Record(const Options& options, bool with_surface);

  bool wants(Check check) const { return wanted_[static_cast<std::size_t>(check)]; }
  /// Whether the options say that findings of this check are meant.
  bool allows(Check check) const { return allowed_[static_cast<std::size_t>(check)]; }
  /// Drops checks that the options do not ask for, after all.
  void leave_out(std::initializer_list<Check> checks);
  /// Drops checks that were asked for and cannot run; the report then lists them as not judged.
  void could_not_run(std::initializer_list<Check> checks, const std::string& why);

  Suspects& operator[](Check check) { return suspects_[static_cast<std::size_t>(check)]; }
  const Suspects& operator[](Check check) const { return suspects_[static_cast<std::size_t>(check)]; }
  CheckResult& result(Check check) { return report.checks[static_cast<std::size_t>(check)]; }

  /// Makes this suspect the cause of all suspects of other checks, even of those that name another cause,
  /// except for those of the checks in `but`.
  void blame(Cause cause, std::initializer_list<Check> but);

  /// Turns the suspects into findings, and gives each check its verdict and the mesh its certificate.
  void settle(const TetMesh& mesh, const Options& options);

  Report report;

 private:
  std::array<bool, check_count> wanted_{}, allowed_{};
  std::vector<Suspects> suspects_ = std::vector<Suspects>(check_count);
};

}  // namespace tetproof::verify
