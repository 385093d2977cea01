// SPDX-License-Identifier: GPL-3.0-or-later
// The journal: what it keeps, what a kill may leave of its end, and what it refuses.
#include "corpus/campaign/journal.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "io/error.hpp"
#include "tests/support/run_program.hpp"

namespace tetproof::corpus {
namespace {

using tetproof::test::ScratchFolder;

CampaignSettings settings() {
  return {
      .seed = 5,
      .cases = 100,
      .shard = 1,
      .shards = 2,
      .limits = {.cpu_s = 0.1},
      .judge = {.check = {"flat"}},
      .meshers = {{.name = "m,a", .command = "m {surface}", .version = "1.5", .words = {"--mesher", "m,a"}},
                  {.name = "m,b"}},
      .version = "0.1"};
}

CaseResult result(std::uint64_t index, const std::string& mesher = "m,a") {
  return {.index = index,
          .mesher = mesher,
          .recipe = "cylinder(n=3)",
          .triangles = 12,
          .outcome = Outcome::wrong,
          .signature = "inverted",
          .what = "tetrahedron 3 \"is\"\nflat \\ \xC3\xA4",
          .repeats = 20,
          .failed = 3,
          .further = {{Outcome::crashed, "f", "g", 2}},
          .cpu_s = 0.1,
          .judge_s = 1e-300};
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const std::string name = journal_name(1, 2);

TEST(Journal, KeepsEverything) {
  const ScratchFolder folder;
  {
    Journal journal(folder.path(), settings());
    EXPECT_TRUE(journal.content().cases.empty());
    journal.append(result(1));
    journal.append(ShrunkCase{"g", 1, "m,a", 8, 20, 4, "steps", "recipe", "findings/x", 99, 1.5});
    journal.append(result(1, "m,b"));
  }
  const Journal journal(folder.path(), settings());
  const JournalContent& content = journal.content();
  ASSERT_EQ(content.cases.size(), 2u);
  const CaseResult& back = content.cases[0];
  const CaseResult wanted = result(1);
  EXPECT_EQ(back.index, wanted.index);
  EXPECT_EQ(back.mesher, wanted.mesher);
  EXPECT_EQ(back.recipe, wanted.recipe);
  EXPECT_EQ(back.triangles, wanted.triangles);
  EXPECT_EQ(back.outcome, wanted.outcome);
  EXPECT_EQ(back.signature, wanted.signature);
  EXPECT_EQ(back.what, wanted.what);
  EXPECT_EQ(back.repeats, wanted.repeats);
  EXPECT_EQ(back.failed, wanted.failed);
  ASSERT_EQ(back.further.size(), 1u);
  EXPECT_EQ(back.further[0].outcome, Outcome::crashed);
  EXPECT_EQ(back.further[0].failed, 2);
  EXPECT_EQ(back.cpu_s, wanted.cpu_s);
  EXPECT_EQ(back.judge_s, wanted.judge_s);
  ASSERT_EQ(content.shrunk.size(), 1u);
  EXPECT_EQ(content.shrunk[0].folder, "findings/x");
  EXPECT_EQ(content.shrunk[0].failed, 4);
}

TEST(Journal, TextThatIsNoUtf8IsReplacedBeforeAnyoneSeesIt) {
  CaseResult odd = result(1);
  odd.what = "latin \xE4";
  odd.signature = std::string(5000, 'x');
  const CaseResult kept = as_journalled(odd);
  EXPECT_EQ(kept.what, "latin \xEF\xBF\xBD");
  EXPECT_LT(kept.signature.size(), 1100u);
  EXPECT_EQ(as_journalled(kept).what, kept.what);
}

// Whatever part of the last line a kill left, the lines before it stay and the next ones follow them.
TEST(Journal, ATornEndIsDropped) {
  const ScratchFolder folder;
  std::size_t two = 0;
  {
    Journal journal(folder.path(), settings());
    journal.append(result(1));
    two = std::filesystem::file_size(folder / name);
    journal.append(result(3));
  }
  const std::string whole = folder.read(name);
  for (std::size_t size = whole.size() - 1; size > two; size -= 7) {
    for (const char* after : {"", "\n", "\n{\"case\":"}) {
      folder.write(name, whole.substr(0, size) + after);
      if (size + 1 == whole.size() && *after == '\n') continue;  // that is the whole line again
      {
        Journal journal(folder.path(), settings());
        ASSERT_EQ(journal.content().cases.size(), 1u) << size;
        journal.append(result(5));
      }
      const JournalContent read = read_journal(folder / name);
      ASSERT_EQ(read.cases.size(), 2u);
      EXPECT_EQ(read.cases[1].index, 5u);
    }
  }
}

TEST(Journal, WithATornFirstLineItBeginsAnew) {
  const ScratchFolder folder;
  { Journal journal(folder.path(), settings()); }
  const std::string first = folder.read(name);
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, first.size() / 2, first.size() - 1}) {
    folder.write(name, first.substr(0, size));
    Journal journal(folder.path(), settings());
    EXPECT_TRUE(journal.content().cases.empty());
    EXPECT_EQ(folder.read(name), first);
  }
}

TEST(Journal, DamageBeforeValidLinesIsNamed) {
  const ScratchFolder folder;
  {
    Journal journal(folder.path(), settings());
    journal.append(result(1));
    journal.append(result(3));
  }
  std::string text = folder.read(name);
  text[text.find("\"case\":1") + 2] = '"';
  folder.write(name, text);
  EXPECT_NE(message_of([&] { Journal(folder.path(), settings()); }).find(name + ":2: "), std::string::npos);
  EXPECT_EQ(folder.read(name), text);  // and nothing is changed
}

TEST(Journal, LinesOfAnotherCampaignAreNamed) {
  for (const CaseResult& foreign : {result(2), result(101), result(1, "other")}) {
    const ScratchFolder folder;
    {
      Journal journal(folder.path(), settings());
      journal.append(foreign);
      journal.append(result(3));
    }
    EXPECT_NE(message_of([&] { read_journal(folder / name); }).find("does not belong"), std::string::npos);
  }
  const ScratchFolder folder;
  {
    Journal journal(folder.path(), settings());
    journal.append(result(3));
    journal.append(result(3));
  }
  EXPECT_NE(message_of([&] { read_journal(folder / name); }).find("twice"), std::string::npos);
}

TEST(Journal, OtherSettingsAreRefusedByName) {
  const ScratchFolder folder;
  { Journal journal(folder.path(), settings()); }
  const std::string before = folder.read(name);
  const auto refusal = [&](const std::function<void(CampaignSettings&)>& change) {
    CampaignSettings other = settings();
    change(other);
    return message_of([&] { Journal(folder.path(), other); });
  };
  EXPECT_EQ(refusal([](CampaignSettings&) {}), "no error");
  const std::vector<std::pair<std::string, std::function<void(CampaignSettings&)>>> changes{
      {"seed: 5, not 6", [](auto& s) { s.seed = 6; }},
      {"cases: 100, not 200", [](auto& s) { s.cases = 200; }},
      {"surfaces.kinds: [], not [\"comb\"]", [](auto& s) { s.surfaces.kinds = {"comb"}; }},
      {"surfaces.modifiers: [], not [\"none\"]", [](auto& s) { s.surfaces.modifiers = {"none"}; }},
      {"surfaces.most_triangles", [](auto& s) { s.surfaces.most_triangles = 9; }},
      {"surfaces.extreme_sizes: false, not true", [](auto& s) { s.surfaces.extreme_sizes = true; }},
      {"limits.cpu_s: 0.1, not 0.2", [](auto& s) { s.limits.cpu_s = 0.2; }},
      {"limits.wall_s", [](auto& s) { s.limits.wall_s = 1; }},
      {"limits.memory_mb", [](auto& s) { s.limits.memory_mb = 1; }},
      {"judge.check: [\"flat\"], not []", [](auto& s) { s.judge.check = {}; }},
      {"judge.tolerance", [](auto& s) { s.judge.tolerance = 1; }},
      {"judge.seconds", [](auto& s) { s.judge.seconds = 1; }},
      {"repeats: 0, not 3", [](auto& s) { s.repeats = 3; }},
      {"version: '0.1', not '0.2'", [](auto& s) { s.version = "0.2"; }},
      {"m,a.version: '1.5', not '1.6'", [](auto& s) { s.meshers[0].version = "1.6"; }},
      {"m,a.command", [](auto& s) { s.meshers[0].command = "x"; }},
      {"meshers: m,a m,b, not m,a", [](auto& s) { s.meshers.pop_back(); }}};
  for (const auto& [expected, change] : changes) {
    const std::string message = refusal(change);
    EXPECT_NE(message.find(expected), std::string::npos) << expected << "\n" << message;
  }
  EXPECT_EQ(folder.read(name), before);
}

TEST(Journal, SettingsThatCannotBeAreRefused) {
  const ScratchFolder folder;
  { Journal journal(folder.path(), settings()); }
  const std::string text = folder.read(name);
  for (const char* shards : {"0", "1", "1000001", "\"two\"", "-1"}) {
    std::string changed = text;
    changed.replace(changed.find("\"shards\":2") + 9, 1, shards);
    folder.write(name, changed);
    EXPECT_NE(message_of([&] { read_journal(folder / name); }).find(name + ":1: "), std::string::npos)
        << shards;
  }
}

TEST(Journal, AnotherProgramsFileIsNotWrittenOver) {
  const ScratchFolder folder;
  folder.write(name, "my notes\n");
  EXPECT_NE(message_of([&] { Journal(folder.path(), settings()); }), "no error");
  EXPECT_EQ(folder.read(name), "my notes\n");
}

TEST(Journal, IsLocked) {
  const ScratchFolder folder;
  const Journal journal(folder.path(), settings());
  EXPECT_NE(message_of([&] { Journal(folder.path(), settings()); }).find("another process"),
            std::string::npos);
}

TEST(Journal, ManyThreadsAppendWholeLines) {
  const ScratchFolder folder;
  {
    CampaignSettings many = settings();
    many.cases = 100000;
    Journal journal(folder.path(), many);
    std::vector<std::jthread> threads;
    for (std::uint64_t t = 0; t < 8; ++t)
      threads.emplace_back([&, t] {
        for (std::uint64_t k = 0; k < 25; ++k) {
          const std::uint64_t index = 2 * (25 * t + k) + 1;
          journal.append(result(index));
          // What was appended is in the file when append returns.
          EXPECT_NE(folder.read(name).find("{\"case\":" + std::to_string(index) + ","), std::string::npos);
        }
      });
  }
  EXPECT_EQ(read_journal(folder / name).cases.size(), 200u);
}

}  // namespace
}  // namespace tetproof::corpus
