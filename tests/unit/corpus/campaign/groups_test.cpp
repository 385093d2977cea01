// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of failures: by preset, outcome and signature, worst first; the smallest surface first.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "corpus/campaign/case_run.hpp"
#include "corpus/fuzz_campaign.hpp"

namespace tetproof::corpus {
namespace {

CaseResult failing(std::uint64_t index, std::string mesher, std::int64_t triangles, Outcome outcome,
                   std::string signature) {
  return {.index = index,
          .mesher = std::move(mesher),
          .triangles = triangles,
          .outcome = outcome,
          .signature = std::move(signature),
          .failed = 1};
}

TEST(Groups, VariantsOfOnePresetAreOneGroup) {
  const auto groups = group_failures({failing(1, "tetgen,pq", 50, Outcome::crashed, "insertpoint"),
                                      failing(1, "tetgen,pY", 50, Outcome::crashed, "insertpoint"),
                                      failing(2, "tetgen,pq", 8, Outcome::crashed, "insertpoint"),
                                      failing(2, "gmsh,hxt", 8, Outcome::crashed, "insertpoint"),
                                      failing(3, "tetgen,pq", 4, Outcome::crashed, "locate"),
                                      failing(4, "tetgen,pq", 4, Outcome::wrong, "insertpoint")});
  ASSERT_EQ(groups.size(), 4u);
  EXPECT_EQ(groups[0].id(), "tetgen:wrong-answer:insertpoint");
  EXPECT_EQ(groups[1].id(), "tetgen:crashed:insertpoint");  // two surfaces: before those with one
  EXPECT_EQ(groups[2].id(), "gmsh:crashed:insertpoint");
  EXPECT_EQ(groups[3].id(), "tetgen:crashed:locate");
  EXPECT_EQ(groups[1].variants, (std::vector<std::string>{"tetgen,pY", "tetgen,pq"}));
  EXPECT_EQ(groups[1].surfaces, 2);
  ASSERT_EQ(groups[1].cases.size(), 3u);
  EXPECT_EQ(groups[1].cases[0].index, 2u);  // 8 triangles
  EXPECT_EQ(groups[1].cases[1].mesher, "tetgen,pY");
  EXPECT_EQ(groups[1].cases[2].mesher, "tetgen,pq");
}

TEST(Groups, OnlyFindings) {
  std::vector<CaseResult> cases;
  for (int o = 0; o < outcome_count; ++o) cases.push_back(failing(1, "m", 4, static_cast<Outcome>(o), ""));
  const auto groups = group_failures(cases);
  std::set<Outcome> grouped;
  for (const FailureGroup& group : groups) grouped.insert(group.outcome);
  EXPECT_EQ(grouped, (std::set<Outcome>{Outcome::wrong, Outcome::wrong_against_surface, Outcome::crashed,
                                        Outcome::refused_valid, Outcome::no_output, Outcome::no_tetrahedra,
                                        Outcome::unreadable}));
  EXPECT_EQ(groups.front().outcome, Outcome::wrong);
  EXPECT_TRUE(group_failures({}).empty());
}

TEST(Groups, TheOrderOfTheCasesDoesNotMatter) {
  std::vector<CaseResult> cases;
  for (std::uint64_t i = 0; i < 30; ++i)
    cases.push_back(failing(i, i % 2 ? "a,x" : "a,y", static_cast<std::int64_t>(i * 7 % 5), Outcome::crashed,
                            i % 3 ? "s" : "t"));
  const auto shown = [](const std::vector<FailureGroup>& groups) {
    std::string text;
    for (const FailureGroup& group : groups) {
      text += group.id();
      for (const CaseResult& one : group.cases) text += " " + std::to_string(one.index);
    }
    return text;
  };
  const std::string expected = shown(group_failures(cases));
  std::reverse(cases.begin(), cases.end());
  EXPECT_EQ(shown(group_failures(cases)), expected);
}

TEST(Groups, KnownOnesAreMarked) {
  const std::vector<CaseResult> cases{failing(1, "m,a", 4, Outcome::crashed, "f: x"),
                                      failing(2, "m,a", 4, Outcome::crashed, "g")};
  const auto groups = group_failures(cases, {"m:crashed:f: x", "m:crashed:h"});
  ASSERT_EQ(groups.size(), 2u);
  for (const FailureGroup& group : groups) EXPECT_EQ(group.known, group.signature == "f: x");
}

TEST(Groups, AnIdIsOneLine) {
  const auto groups = group_failures({failing(1, "m", 4, Outcome::crashed, "two\nlines\t \n")});
  EXPECT_EQ(groups.at(0).id(), "m:crashed:two lines");
}

TEST(Repeats, TheWorstCountsAndNothingIsLost) {
  const auto said = [](Outcome outcome, const char* signature) {
    return Judgement{.outcome = outcome, .signature = signature, .what = std::string("w-") + signature};
  };
  CaseResult result{.index = 5, .mesher = "m,a", .triangles = 9};
  add_up(result, {said(Outcome::sound, ""), said(Outcome::crashed, "f"), said(Outcome::slow, "cpu"),
                  said(Outcome::wrong, "overlap"), said(Outcome::wrong, "inverted"),
                  said(Outcome::wrong, "overlap"), said(Outcome::sound, "")});
  EXPECT_EQ(result.outcome, Outcome::wrong);
  EXPECT_EQ(result.signature, "overlap");
  EXPECT_EQ(result.what, "w-overlap");
  EXPECT_EQ(result.failed, 2);
  EXPECT_EQ(result.repeats, 7);
  ASSERT_EQ(result.further.size(), 3u);  // with the slow one, of which nothing is known
  const auto groups = group_failures({result});
  ASSERT_EQ(groups.size(), 3u);
  for (const char* id : {"m:wrong-answer:overlap", "m:wrong-answer:inverted", "m:crashed:f"})
    EXPECT_TRUE(std::any_of(groups.begin(), groups.end(), [&](const auto& group) {
      return group.id() == id;
    })) << id;
  EXPECT_EQ(groups.back().cases[0].failed, 1);
  EXPECT_EQ(groups.back().cases[0].what, "w-f");
}

TEST(Repeats, SoundIsZeroOfThem) {
  CaseResult result;
  add_up(result, {Judgement{}, Judgement{}});
  EXPECT_EQ(result.outcome, Outcome::sound);
  EXPECT_EQ(result.failed, 0);
  EXPECT_EQ(result.repeats, 2);
}

}  // namespace
}  // namespace tetproof::corpus
