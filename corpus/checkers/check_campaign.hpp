// SPDX-License-Identifier: GPL-3.0-or-later
// Asks checkers about meshes with planted defects and about sound ones: who misses what.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "corpus/checkers/checker.hpp"
#include "corpus/plant.hpp"

namespace tetproof::corpus {

/// What an answer is worth.
enum class Grade {
  seen,           ///< defective, and called so
  accepted,       ///< sound, and called so
  debatable,      ///< both answers are right
  missed,         ///< defective, and called sound: a finding
  false_alarm,    ///< sound, and called defective: a finding
  refused_sound,  ///< sound, and no verdict was given: a finding
  crashed,        ///< a finding, whatever the mesh is
  refused,        ///< defective or debatable, and no verdict was given
  slow,
  out_of_memory,
  not_compiled_in,
  not_held,     ///< the format cannot say exactly what the mesh is: the checker was not asked
  not_planted,  ///< no place was found for this kind of defect: there is no mesh
};
inline constexpr int grade_count = static_cast<int>(Grade::not_planted) + 1;

/// Stable, in reports: "seen", "accepted", "debatable", "missed", "false-alarm", "refused-sound", "crashed",
/// "refused", "slow", "out-of-memory", "not-compiled-in", "not-held", "not-planted".
const char* name_of(Grade grade);
bool is_finding(Grade grade);
/// Whether nothing can be said of the checker: refused, slow, out_of_memory, not_compiled_in, not_held,
/// not_planted.
bool is_unasked(Grade grade);

Grade grade_of(Expected expected, Answer answer);

/// One mesh, one checker.
struct CheckedCase {
  std::uint64_t index = 0;
  std::string checker, kind, ground;
  std::int64_t tets = 0;
  Expected expected = Expected::sound;
  Grade grade = Grade::seen;
  std::string signature;  ///< of a crash: where
  std::string what;       ///< what the checker said, or why it was not asked
};

struct JudgingOptions {
  std::uint64_t seed = 1;
  std::uint64_t each = 3;            ///< meshes of each kind
  std::vector<std::string> kinds{};  ///< empty: all
  Limits limits{};
  int threads = 0;
  std::string folder{};  ///< where a mesh of each finding is kept; empty: nowhere
  std::function<void(const CheckedCase&)> progress{};  ///< called after each case, one at a time
};

/// Findings of one checker, of the same grade, about the same kind of defect; crashes: in the same place.
struct CheckFinding {
  std::string checker;
  Grade grade{};
  std::string subject;             ///< the kind; of crashes: the signature
  std::vector<CheckedCase> cases;  ///< the smallest mesh first
  std::string file;                ///< a mesh in the folder; empty: none
};

struct CheckResult {
  std::uint64_t seed = 1, each = 0;
  std::vector<Checker> checkers;
  std::vector<std::string> kinds;      ///< the rows
  std::vector<CheckedCase> cases;      ///< in the order of their indices, then checkers
  std::vector<CheckFinding> findings;  ///< in the order of checkers, grades and rows
};

/// The number of meshes.
std::uint64_t case_count(const JudgingOptions& options);

/// Asks. The result is the same for any number of threads. InputError for an unknown kind, a wrong
/// expression or a program that is not there.
CheckResult run_checkers(const std::vector<Checker>& checkers, const JudgingOptions& options);

/// Counts by grade.
using GradeCounts = std::array<std::int64_t, grade_count>;
GradeCounts count_grades(const CheckResult& result, const std::string& checker, const std::string& kind = "");

/// The matrix for people: a row for each kind, a column for each checker.
std::string check_text(const CheckResult& result);
std::string check_json(const CheckResult& result);
/// The same as a page of HTML, with what is known about the meshes that are kept in `folder`.
std::string check_page(const CheckResult& result, const std::string& folder);
/// A suite for each checker, a test case for each kind.
std::string check_junit(const CheckResult& result);

}  // namespace tetproof::corpus
