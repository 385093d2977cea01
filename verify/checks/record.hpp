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
  /// Drops checks that the options leave out; the report lists them so. If the options ask for checks by
  /// their ids, these were asked for, and are not judged.
  void leave_out(std::initializer_list<Check> checks, const std::string& why) {
    drop(checks, why, by_id_ ? &report.not_judged : &report.left_out);
  }
  /// Drops checks that nobody asks of such a mesh.
  void does_not_apply(std::initializer_list<Check> checks, const std::string& why) {
    drop(checks, why, by_id_ ? &report.not_judged : nullptr);
  }
  /// Drops checks that should run and cannot; the report lists them as not judged.
  void could_not_run(std::initializer_list<Check> checks, const std::string& why) {
    drop(checks, why, &report.not_judged);
  }

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
  // Drops the checks that are wanted, and lists them; null: nowhere.
  void drop(const std::vector<Check>& checks, const std::string& why, std::vector<NotJudged>* list);

  std::array<bool, check_count> wanted_{}, allowed_{};
  bool by_id_ = false;  // the options name the checks that they ask for
  std::vector<Suspects> suspects_ = std::vector<Suspects>(check_count);
};

}  // namespace tetproof::verify
