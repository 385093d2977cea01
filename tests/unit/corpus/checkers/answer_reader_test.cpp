// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <csignal>

#include "corpus/checkers/check_campaign.hpp"
#include "corpus/checkers/checker.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

Answer answer(const AnswerRule& rule, int exit_code, const char* output = "") {
  return AnswerReader(rule).read({.exit_code = exit_code, .output = output}).answer;
}

TEST(AnswerReader, TheExitCodeDecides) {
  EXPECT_EQ(answer({}, 0, "Error : nonsense\n"), Answer::sound);
  EXPECT_EQ(answer({}, 1), Answer::defective);
  EXPECT_EQ(answer({}, 77, "degenerate facets\n"),
            Answer::defective);  // no refusal, as it would be a mesher's
  EXPECT_EQ(answer({.unread_exits = {2}}, 2), Answer::refused);
}

TEST(AnswerReader, WordsDecideToo) {
  const AnswerRule says{.defective = "^Warning *:"};
  EXPECT_EQ(answer(says, 0, "Info : x\nWarning : y\n"), Answer::defective);
  EXPECT_EQ(answer(says, 0, "Info : no Warning : here\n"), Answer::sound);
  EXPECT_EQ(answer(says, 1, "fine\n"), Answer::defective);
  const AnswerRule sound{.sound = "all is well"};
  EXPECT_EQ(answer(sound, 0, "hm\n"), Answer::defective);
  EXPECT_EQ(answer(sound, 1, "all is well\n"), Answer::sound);
  const AnswerRule both{.defective = "!!", .sound = "consistent"};
  EXPECT_EQ(answer(both, 0, "consistent\n"), Answer::sound);
  EXPECT_EQ(answer(both, 0, "!! inverted\nconsistent\n"), Answer::defective);
  EXPECT_EQ(answer(both, 0, "cannot open\n"), Answer::refused);
  EXPECT_EQ(answer({.defective = "Warning", .unread = "Error loading"}, 0, "Error loading\nWarning\n"),
            Answer::refused);
}

TEST(AnswerReader, OtherEndsAreNoAnswers) {
  const AnswerReader reader(AnswerRule{.defective = "bad"});
  EXPECT_EQ(reader.read({.signal = SIGSEGV, .output = "bad\n"}).answer, Answer::crashed);
  EXPECT_EQ(reader.read({.signal = SIGSEGV, .output = ""}).signature, "SIGSEGV");
  EXPECT_EQ(reader.read({.signal = SIGKILL, .limit = Limit::cpu}).answer, Answer::slow);
  EXPECT_EQ(reader.read({.signal = SIGKILL, .limit = Limit::memory}).answer, Answer::out_of_memory);
}

TEST(AnswerReader, RefusesWhatIsNoExpression) {
  EXPECT_THROW(AnswerReader(AnswerRule{.defective = "("}), InputError);
}

// A line far longer than the matcher's stack has room for.
TEST(AnswerReader, LongLines) {
  const std::string line(3 << 20, 'a');
  EXPECT_EQ(answer({.defective = "(a|b)*c"}, 0, line.c_str()), Answer::sound);
}

TEST(Grades, EveryAnswerOnEveryMesh) {
  EXPECT_EQ(grade_of(Expected::defective, Answer::defective), Grade::seen);
  EXPECT_EQ(grade_of(Expected::defective, Answer::sound), Grade::missed);
  EXPECT_EQ(grade_of(Expected::defective, Answer::refused), Grade::refused);
  EXPECT_EQ(grade_of(Expected::sound, Answer::sound), Grade::accepted);
  EXPECT_EQ(grade_of(Expected::sound, Answer::defective), Grade::false_alarm);
  EXPECT_EQ(grade_of(Expected::sound, Answer::refused), Grade::refused_sound);
  EXPECT_EQ(grade_of(Expected::debatable, Answer::sound), Grade::debatable);
  EXPECT_EQ(grade_of(Expected::debatable, Answer::defective), Grade::debatable);
  EXPECT_EQ(grade_of(Expected::debatable, Answer::crashed), Grade::crashed);
  for (int g = 0; g < grade_count; ++g) {
    const auto grade = static_cast<Grade>(g);
    EXPECT_FALSE(is_finding(grade) && is_unasked(grade)) << name_of(grade);
  }
  EXPECT_TRUE(is_finding(Grade::missed) && is_finding(Grade::false_alarm) && is_finding(Grade::crashed));
  EXPECT_TRUE(is_unasked(Grade::slow) && is_unasked(Grade::not_held) && !is_unasked(Grade::seen));
}

}  // namespace
}  // namespace tetproof::corpus
