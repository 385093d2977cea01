// SPDX-License-Identifier: GPL-3.0-or-later
// A campaign as a whole: order, threads, shards, merging, known groups, restarts, failures of our own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "io/error.hpp"
#include "tests/support/run_program.hpp"
#include "tests/unit/corpus/campaign/fake_campaign.hpp"

namespace tetproof::corpus {
namespace {

using namespace corpus::test;
using tetproof::test::ScratchFolder;

std::string all_reports(const CampaignResult& result) {
  return campaign_text(result) + campaign_json(result) + campaign_junit(result);
}

template <class Error>
std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Campaign, EveryCaseOnceInOrder) {
  const FakeMesher a("fake,a", usual_script), b("fake,b", usual_script);
  CampaignOptions options = fake_options(60);
  int reported = 0;
  options.progress = [&](const CaseResult&) { ++reported; };
  const CampaignResult result = run_campaign({&a, &b}, options);
  ASSERT_EQ(result.cases.size(), 120u);
  EXPECT_EQ(reported, 120);
  EXPECT_EQ(result.surfaces, 60);
  for (std::size_t c = 0; c < 120; ++c) {
    EXPECT_EQ(result.cases[c].index, c / 2);
    EXPECT_EQ(result.cases[c].mesher, c % 2 ? "fake,b" : "fake,a");
    EXPECT_EQ(result.cases[c].outcome, usual_script(c / 2, 0).failure.value_or(Outcome::sound)) << c / 2;
    EXPECT_EQ(result.cases[c].triangles, c / 2 % 3 == 0 ? 4 : c / 2 % 3 == 1 ? 6 : 8);
  }
}

TEST(Campaign, AWrongMeshIsFound) {
  const FakeMesher fills_too_little("fake", [](std::uint64_t, int) { return FakeRun{}; });
  const CampaignResult result = run_campaign({&fills_too_little}, fake_options(6));
  for (const CaseResult& one : result.cases)
    EXPECT_EQ(one.outcome == Outcome::sound, one.index % 3 == 0) << one.index << name_of(one.outcome);
  ASSERT_FALSE(result.groups.empty());
  EXPECT_EQ(result.groups[0].mesher, "fake");
}

TEST(Campaign, TheSameForAnyNumberOfThreads) {
  const FakeMesher mesher("fake,a", usual_script);
  std::set<std::string> reports;
  for (const int threads : {1, 2, 7}) {
    CampaignOptions options = fake_options(100);
    options.threads = threads;
    reports.insert(all_reports(run_campaign({&mesher}, options)));
  }
  EXPECT_EQ(reports.size(), 1u);
}

TEST(Campaign, ShardsTogetherAreTheWhole) {
  const FakeMesher a("fake,a", usual_script), b("fake,b", usual_script);
  const std::vector<std::string> known{"fake:crashed:g: SIGSEGV", "fake:crashed:never"};
  const ScratchFolder whole, parts, elsewhere;
  CampaignOptions options = fake_options(50, whole.path());
  options.known = known;
  const std::string expected = all_reports(run_campaign({&a, &b}, options));
  EXPECT_NE(expected.find("known, and did not occur: fake:crashed:never"), std::string::npos);
  for (std::uint64_t s = 0; s < 4; ++s) {
    CampaignOptions part = fake_options(50, s == 2 ? elsewhere.path() : parts.path());
    part.known = known;
    part.shard = s;
    part.shards = 4;
    const CampaignResult result = run_campaign({&a, &b}, part);
    for (const CaseResult& one : result.cases) EXPECT_EQ(one.index % 4, s);
  }
  EXPECT_EQ(all_reports(merge_campaign({whole.path()}, known)), expected);
  const CampaignResult merged = merge_campaign({parts.path(), elsewhere.path()}, known);
  EXPECT_TRUE(merged.missing.empty());
  EXPECT_EQ(all_reports(merged), expected);
  const CampaignResult some = merge_campaign({parts.path()}, known);
  EXPECT_EQ(some.missing, std::vector<std::string>{"shard 2 of 4 is missing"});
  EXPECT_NE(campaign_junit(some).find("shard 2 of 4 is missing"), std::string::npos);
}

TEST(Campaign, MergingNamesWhatIsNotDoneAndRefusesWhatDoesNotBelong) {
  const FakeMesher mesher("fake,a", usual_script);
  const ScratchFolder parts, other, empty, seeds;
  for (std::uint64_t s = 0; s < 3; ++s) {
    CampaignOptions part = fake_options(31, parts.path());
    part.shard = s;
    part.shards = 3;
    run_campaign({&mesher}, part);
  }
  // Shard 1 has 10 cases. It was killed while it wrote its fifth one: 1 + 4 lines are whole.
  std::string text = parts.read("journal-1-of-3.jsonl");
  std::size_t end = 0;
  for (int line = 0; line < 5; ++line) end = text.find('\n', end) + 1;
  parts.write("journal-1-of-3.jsonl", text.substr(0, end + 20));
  const CampaignResult merged = merge_campaign({parts.path()});
  EXPECT_EQ(merged.missing, std::vector<std::string>{"shard 1 of 3 lacks 6 of 10 cases"});
  EXPECT_EQ(merged.cases.size(), 25u);

  std::filesystem::copy_file(parts / "journal-0-of-3.jsonl", other / "journal-0-of-3.jsonl");
  EXPECT_NE(message_of<InputError>([&] {
              merge_campaign({parts.path(), other.path()});
            }).find("the same shard"),
            std::string::npos);
  EXPECT_NE(message_of<InputError>([&] { merge_campaign({empty.path()}); }).find("there is no journal"),
            std::string::npos);
  EXPECT_NE(message_of<InputError>([&] { merge_campaign({empty / "none"}); }).find("none"),
            std::string::npos);
  CampaignOptions another = fake_options(31, seeds.path());
  another.seed = 8;
  run_campaign({&mesher}, another);
  EXPECT_NE(message_of<InputError>([&] {
              merge_campaign({parts.path(), seeds.path()});
            }).find("seed: 8, not 7"),
            std::string::npos);
}

TEST(Campaign, MoreShardsThanCases) {
  const FakeMesher mesher("fake,a", usual_script);
  const ScratchFolder folder;
  for (std::uint64_t s = 0; s < 2; ++s) {
    CampaignOptions part = fake_options(2, folder.path());
    part.shard = s;
    part.shards = 5;
    run_campaign({&mesher}, part);
  }
  const CampaignResult merged = merge_campaign({folder.path()});
  EXPECT_TRUE(merged.missing.empty());
  EXPECT_EQ(merged.cases.size(), 2u);
}

TEST(Campaign, ARestartRunsOnlyWhatIsMissing) {
  const ScratchFolder folder;
  const FakeMesher mesher("fake,a", usual_script);
  const std::string expected = all_reports(run_campaign({&mesher}, fake_options(40, folder.path())));
  EXPECT_EQ(mesher.runs, 40 + 2);  // two groups, whose smallest case ran once more for the finding
  EXPECT_EQ(all_reports(run_campaign({&mesher}, fake_options(40, folder.path()))), expected);
  EXPECT_EQ(mesher.runs, 42);
  std::string text = folder.read("journal-0-of-1.jsonl");
  const std::size_t end = text.find('\n', text.size() / 2) + 1;
  const auto lines_left = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
  folder.write("journal-0-of-1.jsonl", text.substr(0, end + 5));
  EXPECT_EQ(all_reports(run_campaign({&mesher}, fake_options(40, folder.path()))), expected);
  EXPECT_EQ(mesher.runs, 42 + (40 - (lines_left - 1)) + 2);
}

TEST(Campaign, KnownGroupsAreCountedAndNotWritten) {
  const ScratchFolder folder;
  const FakeMesher mesher("fake,a", usual_script);
  CampaignOptions options = fake_options(40, folder.path());
  options.known = {"fake:crashed:f: Assertion `x > 0' failed", "fake:crashed:g: SIGSEGV"};
  const CampaignResult result = run_campaign({&mesher}, options);
  ASSERT_EQ(result.groups.size(), 2u);
  EXPECT_TRUE(result.groups[0].known && result.groups[1].known);
  EXPECT_EQ(mesher.runs, 40);
  EXPECT_TRUE(result.shrunk.empty());
  EXPECT_NE(campaign_junit(result).find("<skipped message=\"known\"/>"), std::string::npos);
  EXPECT_NE(campaign_junit(result).find("failures=\"0\""), std::string::npos);
}

// The journal replaces bytes that are no UTF-8: the same words from a new run still are the group's.
TEST(Campaign, AFailureInLatin1IsFoundAgain) {
  const ScratchFolder folder;
  const FakeMesher mesher("fake,a", [](std::uint64_t index, int) {
    return index == 3 ? FakeRun{Outcome::crashed, "ung\xFCltig"} : FakeRun{Outcome::refused, "no"};
  });
  const CampaignResult result = run_campaign({&mesher}, fake_options(5, folder.path()));
  ASSERT_EQ(result.shrunk.size(), 1u);
  EXPECT_GT(result.shrunk[0].failed, 0);
}

TEST(Campaign, NeverSoundOfWhatWasNotLookedAt) {
  const FakeMesher mesher("fake,a", [](std::uint64_t index, int) {
    return index % 2 ? FakeRun{Outcome::slow, "cpu"} : FakeRun{Outcome::not_judged, "20 s"};
  });
  const CampaignResult result = run_campaign({&mesher}, fake_options(10));
  const std::string text = campaign_text(result), first = text.substr(0, text.find('\n'));
  EXPECT_NE(first.find("0 sound"), std::string::npos) << first;
  EXPECT_NE(first.find("5 not-judged"), std::string::npos) << first;
  EXPECT_NE(first.find("5 slow"), std::string::npos) << first;
  EXPECT_NE(first.find("nothing is said of 10 cases"), std::string::npos) << first;
  const auto json = nlohmann::json::parse(campaign_json(result));
  EXPECT_EQ(json["unjudged"], 10);
  EXPECT_EQ(json["by_mesher"]["fake,a"]["slow"], 5);
  EXPECT_EQ(json["not_sound"].size(), 10u);
}

TEST(Campaign, RepeatsCountHowOften) {
  const FakeMesher mesher(
      "fake,a",
      [](std::uint64_t index, int run) {
        return index == 3 && run % 7 == 4 ? FakeRun{Outcome::crashed, "f"} : FakeRun{Outcome::refused, "no"};
      },
      20);
  const CampaignResult result = run_campaign({&mesher}, fake_options(6));
  EXPECT_EQ(mesher.runs, 120);
  ASSERT_EQ(result.groups.size(), 1u);
  EXPECT_EQ(result.groups[0].cases[0].failed, 3);
  EXPECT_EQ(result.groups[0].cases[0].repeats, 20);
  EXPECT_NE(campaign_text(result).find("3 of 20 runs"), std::string::npos) << campaign_text(result);
}

TEST(Campaign, ASurfaceThatIsNoneIsOurFailure) {
  const FakeMesher mesher("fake,a", usual_script);
  CampaignOptions options = fake_options(20);
  options.surface_of = [](std::uint64_t index) {
    FuzzSurface made{.surface = fake_surface(index), .recipe = {}};
    if (index == 13) made.surface.triangles.pop_back();
    return made;
  };
  const std::string open = message_of<std::logic_error>([&] { run_campaign({&mesher}, options); });
  EXPECT_NE(open.find("seed 7, index 13"), std::string::npos) << open;
  EXPECT_NE(open.find("open"), std::string::npos) << open;
  options.surface_of = [](std::uint64_t index) -> FuzzSurface {
    if (index == 4) throw InputError("no polygon");
    return {.surface = fake_surface(index), .recipe = {}, .genus = index == 4 ? 1 : 0};
  };
  EXPECT_NE(message_of<std::logic_error>([&] {
              run_campaign({&mesher}, options);
            }).find("index 4 is not valid: no polygon"),
            std::string::npos);
  options.surface_of = [](std::uint64_t index) {
    return FuzzSurface{.surface = fake_surface(index), .recipe = {}, .genus = index == 4 ? 1 : 0};
  };
  EXPECT_NE(message_of<std::logic_error>([&] { run_campaign({&mesher}, options); }).find("0 handles, not 1"),
            std::string::npos);
}

TEST(Campaign, UsageIsChecked) {
  const FakeMesher mesher("fake,a", usual_script);
  EXPECT_THROW(run_campaign({}, fake_options(1)), InputError);
  EXPECT_THROW(run_campaign({&mesher, &mesher}, fake_options(1)), InputError);
  CampaignOptions options = fake_options(1);
  options.shard = 2;
  options.shards = 2;
  EXPECT_THROW(run_campaign({&mesher}, options), InputError);
  EXPECT_THROW(run_campaign({&mesher}, fake_options(1, "/proc/none")), InputError);
}

TEST(Campaign, NothingIsLeftOfScratchFolders) {
  const ScratchFolder folder;
  const FakeMesher mesher("fake,a", [](std::uint64_t, int) { return FakeRun{Outcome::refused, "no"}; });
  std::filesystem::create_directories(folder / "scratch-0-of-1/17-0");  // of a run that was killed
  run_campaign({&mesher}, fake_options(5, folder.path()));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"journal-0-of-1.jsonl"});
}

}  // namespace
}  // namespace tetproof::corpus
