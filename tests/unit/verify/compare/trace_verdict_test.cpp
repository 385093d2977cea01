// SPDX-License-Identifier: GPL-3.0-or-later
// What is said where two traces part, and how the check of each of them decides the verdict.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/unit/verify/compare/traces.hpp"

namespace tetproof::test {
namespace {

using namespace trace;
using Verdict = verify::TraceComparison::Verdict;
using Records = std::vector<Record>;
using verify::CheckedTrace;
using Notes = std::vector<std::string>;

TEST(DivergenceReport, SaysWhereAndWhatOfBoth) {
  const TestFiles files;
  Records other = small_trace();
  at<Insertion>(other, third_insertion_line).tet = {f, g, h, m};
  at<Insertion>(other, third_insertion_line).e_avg = 0.171;
  const verify::TraceComparison result = compare(files, other, small_trace());
  std::string text = verify::comparison_text(result);
  for (std::size_t at; (at = text.find(files.path(""))) != text.npos;) text.erase(at, files.path("").size());
  EXPECT_EQ(
      text,
      "unresolved: it is not known which of them is wrong\n"
      "they part at step (vi), eq. (3.5):\n"
      "insertion 3: reference splits the tetrahedron at (0.75, 0.375, 0.875) by row 4c, other the one at "
      "(1.25, 0.625, 0.875) by row 4c; "
      "E'avg 0.17 against 0.171\n"
      "  reference (reference.jsonl:23): row 4c, E'avg 0.17 (other never splits it): (0, 0, 1) (2, 0, 1) (0, "
      "1, 1) (1, 0.5, 0.5)\n"
      "  other (other.jsonl:23): row 4c, E'avg 0.171 (reference splits it as insertion 4, by row 2b): (2, 0, "
      "1) (0, 1, 1) (2, 1, 1) (1, 0.5, 0.5)\n"
      "  found the same: 2 insertions and 2 flips\n");
  const nlohmann::json json = nlohmann::json::parse(verify::comparison_json(result));
  EXPECT_EQ(json.at("compared"), "traces");
  EXPECT_EQ(json.at("verdict"), "unresolved");
  EXPECT_EQ(json.at("step"), "choice");
  EXPECT_EQ(json.at("place"), "step (vi), eq. (3.5)");
  EXPECT_EQ(json.at("insertion"), 3);
  EXPECT_EQ(json.at("what"), result.what);
  EXPECT_EQ(json.at("insertions"), 2);
  EXPECT_EQ(json.at("flips"), 2);
  EXPECT_EQ(json.at("reference").at("line"), 23);
  EXPECT_EQ(json.at("reference").at("record").at("row"), "4c");
  EXPECT_EQ(json.at("other").at("file"), files.path("other.jsonl"));
  EXPECT_EQ(json.at("other").at("record").at("e_avg"), 0.171);
  EXPECT_TRUE(json.at("wrong").is_null());
  EXPECT_EQ(json.at("ties"), 0);
  EXPECT_EQ(json.at("not_compared"), nlohmann::json::array());
}

// Compares a trace that splits another tetrahedron with the handmade one. The check says this of the two.
class CheckedTraces : public ::testing::Test {
 protected:
  verify::TraceComparison compare_checked(const CheckedTrace& other, const CheckedTrace& reference) {
    Records changed = small_trace();
    at<Insertion>(changed, third_insertion_line).tet = {f, g, h, m};
    checked.clear();
    return compare(files, changed, small_trace(), 1e-9, [&](const std::string& path) {
      checked.push_back(path);
      return path == files.path("other.jsonl") ? other : reference;
    });
  }
  std::string text(const verify::TraceComparison& result) const {
    std::string said = verify::comparison_text(result);
    for (std::size_t at; (at = said.find(files.path(""))) != said.npos;)
      said.erase(at, files.path("").size());
    return said;
  }

  const TestFiles files;
  std::vector<std::string> checked;
};

TEST_F(CheckedTraces, TheOtherIsWrong) {
  const auto result = compare_checked({.admissible = false, .line = 23, .what = "it splits a worse one"}, {});
  EXPECT_EQ(result.verdict, Verdict::diverges);
  EXPECT_EQ(result.wrong.file, files.path("other.jsonl"));
  EXPECT_EQ(result.wrong.line, 23);
  EXPECT_EQ(result.wrong.says, "it splits a worse one");
  EXPECT_EQ(text(result).substr(0, 13), "they diverge\n");
  EXPECT_NE(text(result).find("\n  wrong is other.jsonl:23: it splits a worse one\n"), std::string::npos);
  const nlohmann::json json = nlohmann::json::parse(verify::comparison_json(result));
  EXPECT_EQ(json.at("verdict"), "diverges");
  EXPECT_EQ(json.at("wrong").at("file"), files.path("other.jsonl"));
  EXPECT_EQ(json.at("wrong").at("line"), 23);
  EXPECT_EQ(json.at("wrong").at("says"), "it splits a worse one");
  EXPECT_EQ(checked, (Notes{files.path("other.jsonl"), files.path("reference.jsonl")}));
}

TEST_F(CheckedTraces, TheReferenceIsWrong) {
  const auto result = compare_checked({}, {.admissible = false, .line = 7, .what = "moved elsewhere"});
  EXPECT_EQ(result.verdict, Verdict::diverges);
  EXPECT_EQ(result.wrong.file, files.path("reference.jsonl"));
  EXPECT_EQ(result.wrong.line, 7);
}

TEST_F(CheckedTraces, BothAreWrong) {
  const auto result = compare_checked({.admissible = false, .line = 23, .what = "one thing"},
                                      {.admissible = false, .line = 7, .what = "another"});
  EXPECT_EQ(result.verdict, Verdict::diverges);
  EXPECT_EQ(result.wrong.file, files.path("other.jsonl"));
  EXPECT_EQ(result.notes, Notes{files.path("reference.jsonl") + ":7 is not admissible either: another"});
}

// They agree up to line 22. If both are wrong before, the method has another surface than they.
TEST_F(CheckedTraces, BothAreWrongBeforeTheyPart) {
  const CheckedTrace wrong{.admissible = false, .line = 5, .what = "the box is larger"};
  const auto result = compare_checked(wrong, wrong);
  EXPECT_EQ(result.verdict, Verdict::unresolved);
  EXPECT_EQ(result.wrong.file, "");
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_NE(result.notes[0].find("other.jsonl:5: the box is larger"), std::string::npos) << result.notes[0];
  CheckedTrace later = wrong;
  later.line = 23;
  EXPECT_EQ(compare_checked(wrong, later).verdict, Verdict::diverges);
}

TEST_F(CheckedTraces, ATieIsProvenByBoth) {
  const auto result = compare_checked({.ties = 2}, {.ties = 1});
  EXPECT_EQ(result.verdict, Verdict::tie);
  EXPECT_EQ(result.ties, 2);
  EXPECT_EQ(text(result).substr(0, 62), "equal but for 2 proven ties: each is admissible to its end\nthe");
  EXPECT_EQ(result.wrong.file, "");
  EXPECT_EQ(compare_checked({.ties = 1}, {}).ties, 1);
  EXPECT_EQ(text(compare_checked({}, {.ties = 1})).substr(0, 27), "equal but for 1 proven tie:");
  const nlohmann::json json = nlohmann::json::parse(verify::comparison_json(result));
  EXPECT_EQ(json.at("verdict"), "tie");
  EXPECT_EQ(json.at("ties"), 2);
}

// Each is the best choice by its own last digits, so that neither differs from the method.
TEST_F(CheckedTraces, ATieThatEachDecidesByItsOwnRounding) {
  const auto result = compare_checked({}, {});
  EXPECT_EQ(result.verdict, Verdict::tie);
  EXPECT_EQ(result.ties, 1);
}

TEST_F(CheckedTraces, WhatIsNoChoiceIsNotExplainedByATie) {
  Records other = small_trace();
  at<Insertion>(other, third_insertion_line).e_avg *= 1.001;
  const auto result =
      compare(files, other, small_trace(), 1e-9, [](const std::string&) { return CheckedTrace{}; });
  EXPECT_EQ(result.verdict, Verdict::unresolved);
  EXPECT_EQ(result.notes, Notes{"the method allows every decision of both without a tie: the difference is "
                                "smaller than what it tells apart"});
}

TEST_F(CheckedTraces, WhatCannotBeCheckedDecidesNothing) {
  const CheckedTrace not_found{.cannot = "its surface is not found"};
  for (const auto& [other, reference, file] :
       {std::tuple{not_found, CheckedTrace{}, "other.jsonl"},
        std::tuple{CheckedTrace{.ties = 1}, not_found, "reference.jsonl"}}) {
    const auto result = compare_checked(other, reference);
    EXPECT_EQ(result.verdict, Verdict::unresolved);
    EXPECT_EQ(result.notes, Notes{files.path(file) + " could not be checked: its surface is not found"});
  }
  // But the other one may be found wrong.
  const auto result = compare_checked({.admissible = false, .line = 23, .what = "wrong"}, not_found);
  EXPECT_EQ(result.verdict, Verdict::diverges);
  EXPECT_EQ(result.wrong.line, 23);
}

TEST_F(CheckedTraces, WhatATraceLeavesOutIsNotCompared) {
  const auto result = compare_checked({.ties = 1, .not_checked = {"settings"}}, {});
  EXPECT_EQ(result.verdict, Verdict::tie);
  EXPECT_EQ(result.not_compared, Notes{"settings: " + files.path("other.jsonl") + " has none"});
  EXPECT_NE(text(result).find("\n  not compared: settings: other.jsonl has none\n"), std::string::npos);
}

TEST_F(CheckedTraces, WhatIsLeftOutIsToldOnce) {
  Records other = small_trace();
  std::erase_if(other, [](const Record& record) { return std::holds_alternative<Rows>(record); });
  at<Insertion>(other, third_insertion_line - 2).e_avg = 0.171;  // two lines are gone
  const auto result = compare(files, other, small_trace(), 1e-9, [&](const std::string& path) {
    return path == files.path("other.jsonl") ? CheckedTrace{.not_checked = {"rows of Table 2", "settings"}}
                                             : CheckedTrace{};
  });
  EXPECT_EQ(result.not_compared, (Notes{"rows of Table 2: other has none",
                                        "settings: " + files.path("other.jsonl") + " has none"}));
}

// Neither is asked for where the traces are equal, were asked for different things, or one contradicts
// itself.
TEST_F(CheckedTraces, AreCheckedOnlyWhereTheyPart) {
  const auto never = [](const std::string& path) -> CheckedTrace {
    ADD_FAILURE() << "checks " << path;
    return {};
  };
  Records other = small_trace();
  EXPECT_EQ(compare(files, other, small_trace(), 1e-9, never).verdict, Verdict::equal);
  at<Settings>(other, settings_line).p = 2;
  EXPECT_EQ(compare(files, other, small_trace(), 1e-9, never).verdict, Verdict::diverges);
  other = small_trace();
  at<Flip>(other, flip_line).quality_before *= 1.001;
  EXPECT_EQ(compare(files, other, small_trace(), 1e-9, never).verdict, Verdict::diverges);
}

// Volumes are asked for; the check tells whether the weights follow from them.
TEST_F(CheckedTraces, OtherVolumesAskedFor) {
  Records other = small_trace();
  at<FirstGrid>(other, first_grid_line).v0 = 0.06;
  const auto verdict = [&](const CheckedTrace& checked_other) {
    return compare(files, other, small_trace(), 1e-9, [&](const std::string& path) {
      return path == files.path("other.jsonl") ? checked_other : CheckedTrace{};
    });
  };
  verify::TraceComparison result = verdict({});
  EXPECT_EQ(result.verdict, Verdict::diverges);
  EXPECT_EQ(result.step, "volume-law");
  EXPECT_EQ(result.wrong.file, "");
  EXPECT_EQ(result.notes,
            Notes{"each is admissible for the volumes that it states: they were asked for others"});
  result = verdict({.admissible = false, .line = in_file(first_grid_line), .what = "V0"});
  EXPECT_EQ(result.wrong.file, files.path("other.jsonl"));
}

}  // namespace
}  // namespace tetproof::test
