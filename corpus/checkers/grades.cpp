// SPDX-License-Identifier: GPL-3.0-or-later
// What a checker's answer is worth.
#include <stdexcept>

#include "corpus/checkers/check_campaign.hpp"

namespace tetproof::corpus {

const char* name_of(Grade grade) {
  static constexpr std::array names{
      "seen",    "accepted", "debatable",     "missed",          "false-alarm", "refused-sound", "crashed",
      "refused", "slow",     "out-of-memory", "not-compiled-in", "not-held",    "not-planted"};
  static_assert(names.size() == grade_count);
  return names[static_cast<std::size_t>(grade)];
}

bool is_finding(Grade grade) {
  return grade == Grade::missed || grade == Grade::false_alarm || grade == Grade::refused_sound ||
         grade == Grade::crashed;
}

bool is_unasked(Grade grade) {
  return grade > Grade::crashed;
}

Grade grade_of(Expected expected, Answer answer) {
  switch (answer) {
    case Answer::sound:
      return expected == Expected::sound       ? Grade::accepted
             : expected == Expected::debatable ? Grade::debatable
                                               : Grade::missed;
    case Answer::defective:
      return expected == Expected::sound       ? Grade::false_alarm
             : expected == Expected::debatable ? Grade::debatable
                                               : Grade::seen;
    case Answer::refused:
      return expected == Expected::sound ? Grade::refused_sound : Grade::refused;
    case Answer::crashed:
      return Grade::crashed;
    case Answer::slow:
      return Grade::slow;
    case Answer::out_of_memory:
      return Grade::out_of_memory;
    case Answer::not_compiled_in:
      return Grade::not_compiled_in;
  }
  throw std::logic_error("no such answer");
}

GradeCounts count_grades(const CheckResult& result, const std::string& checker, const std::string& kind) {
  GradeCounts counts{};
  for (const CheckedCase& one : result.cases)
    if (one.checker == checker && (kind.empty() || one.kind == kind))
      ++counts[static_cast<std::size_t>(one.grade)];
  return counts;
}

}  // namespace tetproof::corpus
