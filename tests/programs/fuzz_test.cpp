// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-fuzz as users run it, on a mesher with planted bugs.
#include <gmock/gmock.h>
#include <sys/types.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Words = std::vector<std::string>;

// Surfaces that the faulty mesher does not refuse.
const Words easy{"--kinds", "cylinder,bipyramid", "--modifiers", "none"};

class Fuzz : public ::testing::Test {
 protected:
  // Runs `options`, then the faulty mesher with a bug.
  static Outcome fuzz(Words options, const std::string& bug, const RunOptions& how = {}) {
    options.insert(options.begin(), program("tetproof-fuzz"));
    options.insert(options.end(), easy.begin(), easy.end());
    if (!bug.empty())
      options.insert(options.end(), {"--", program("tetproof-faulty-mesher"), bug, "{surface}", "{mesh}"});
    return run_program(options, how);
  }
  static Outcome plain(Words options, const RunOptions& how = {}) {
    options.insert(options.begin(), program("tetproof-fuzz"));
    return run_program(options, how);
  }
  static void expect_refused(const Outcome& outcome, const std::string& why) {
    EXPECT_EQ(outcome.exit_code, 2) << outcome;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines(outcome.err), 1u) << outcome;
    EXPECT_THAT(outcome.err, AllOf(StartsWith("tetproof-fuzz: "), HasSubstr(why)));
  }

  ScratchFolder files;
};

TEST_F(Fuzz, AMesherWithoutBugsHasNoFindings) {
  const Outcome run = fuzz({"--cases", "12", "--json", files / "report.json"}, "none");
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_EQ(run.err, "");
  const json report = json::parse(files.read("report.json"));
  EXPECT_EQ(report["findings"], 0);
  EXPECT_TRUE(report["groups"].empty());
  const json row = report["by_mesher"]["tetproof-faulty-mesher"];
  EXPECT_EQ(row["cases"], 12);
  EXPECT_GE(row["sound"].get<int>(), 6) << row;
  EXPECT_THAT(run.out, StartsWith("seed 1: 1 mesher on 12 surfaces: "));
}

TEST_F(Fuzz, FindsGroupsShrinksAndReplays) {
  const std::string out = files / "out";
  const Outcome run =
      fuzz({"--cases", "12", "--out", out, "--shrink", "4", "--junit", files / "fuzz.xml"}, "duplicate");
  EXPECT_EQ(run.exit_code, 1) << run;
  const json report = json::parse(files.read("out/report.json"));
  ASSERT_EQ(report["groups"].size(), 1u) << report.dump(1);
  const json group = report["groups"][0];
  const std::string id = group["id"];
  EXPECT_EQ(id, "tetproof-faulty-mesher:wrong-answer:duplicate-tet");
  EXPECT_THAT(run.out, HasSubstr(id));
  EXPECT_THAT(files.read("fuzz.xml"), HasSubstr("failures=\"1\""));
  const json shrunk = group["shrunk"];
  EXPECT_LE(shrunk["triangles"], group["cases"][0]["triangles"]);
  EXPECT_EQ(shrunk["failed"], 1);
  const std::string folder = shrunk["folder"];
  EXPECT_TRUE(files.has("out/" + folder + "/README.md"));
  EXPECT_TRUE(files.has("out/" + folder + "/surface.off"));
  EXPECT_EQ(files.read("out/report.txt"), run.out);

  // Once more: all is in the journal, and the report has the same bytes.
  const std::string journal = files.read("out/journal-0-of-1.jsonl");
  const Outcome again = fuzz({"--cases", "12", "--out", out, "--shrink", "4"}, "duplicate");
  EXPECT_EQ(again.out, run.out);
  EXPECT_EQ(files.read("out/journal-0-of-1.jsonl"), journal);

  // The case again, in every way to name it.
  const std::string index = std::to_string(group["cases"][0]["case"].get<int>());
  std::string command = group["replay"];
  ASSERT_THAT(command, StartsWith("tetproof-fuzz --replay 1:" + index));
  command.replace(0, 13, program("tetproof-fuzz"));
  for (const Outcome& replayed :
       {run_program({"sh", "-c", command}), plain({"--replay", out + "/" + index}),
        plain({"--replay", out + "/" + folder}), plain({"--replay", id, "--out", out})}) {
    EXPECT_EQ(replayed.exit_code, 1) << replayed;
    EXPECT_THAT(replayed.out, HasSubstr("tetproof-faulty-mesher: wrong-answer: duplicate-tet")) << replayed;
    EXPECT_EQ(replayed.err, "");
  }
}

TEST_F(Fuzz, KnownGroupsAreNoFailure) {
  const std::string known = files.write("known",
                                        "# reported\ntetproof-faulty-mesher:wrong-answer:duplicate-tet\n"
                                        "tetproof-faulty-mesher:crashed:never\n");
  const Outcome run = fuzz({"--cases", "8", "--known", known, "--json", files / "report.json"}, "duplicate");
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_THAT(run.out, AllOf(HasSubstr("0 new groups and 1 known group"),
                             HasSubstr("known, and did not occur: tetproof-faulty-mesher:crashed:never")));
  const json report = json::parse(files.read("report.json"));
  EXPECT_EQ(report["groups"][0]["known"], true);
  EXPECT_GT(report["findings"], 0);
  EXPECT_EQ(report["new_groups"], 0);
  expect_refused(fuzz({"--cases", "1", "--known", files.write("bad", "duplicate\n")}, "duplicate"),
                 "bad:1: ");
}

TEST_F(Fuzz, WhatWasNotLookedAtIsNotSound) {
  const Outcome slow =
      plain({"--cases", "2", "--cpu", "0.1", "--", "sh", "-c", "while :; do :; done", "{surface}", "{mesh}"});
  EXPECT_EQ(slow.exit_code, 4) << slow;
  EXPECT_THAT(slow.out, AllOf(HasSubstr("0 sound"), HasSubstr("2 slow; nothing is said of 2 cases")));
}

TEST_F(Fuzz, ShardsMergedAreOneRun) {
  const Words cases{"--cases", "14"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), cases.begin(), cases.end());
    return more;
  };
  const Outcome whole =
      fuzz(with({"--json", files / "w.json", "--junit", files / "w.xml", "--out", files / "w"}), "duplicate");
  EXPECT_EQ(whole.exit_code, 1) << whole;
  EXPECT_EQ(fuzz(with({"--shard", "0/3", "--out", files / "a"}), "duplicate").exit_code, 1);
  EXPECT_EQ(fuzz(with({"--out", files / "a"}), "duplicate",
                 {.environment = {"GTEST_TOTAL_SHARDS=3", "GTEST_SHARD_INDEX=1"}})
                .exit_code,
            1);
  const Outcome part = plain({"--merge", files / "a"});
  EXPECT_EQ(part.exit_code, 1);
  EXPECT_THAT(part.err, HasSubstr("shard 2 of 3 is missing"));
  EXPECT_EQ(fuzz(with({"--shards", "3", "--out", files / "b"}), "duplicate",
                 {.environment = {"JOB_COMPLETION_INDEX=2"}})
                .exit_code,
            1);
  const Outcome merged =
      plain({"--json", files / "m.json", "--junit", files / "m.xml", "--merge", files / "a", files / "b"});
  EXPECT_EQ(merged.exit_code, 1) << merged;
  EXPECT_EQ(merged.err, "");
  EXPECT_EQ(merged.out, whole.out);
  EXPECT_EQ(files.read("m.json"), files.read("w.json"));
  EXPECT_EQ(files.read("m.xml"), files.read("w.xml"));
}

TEST_F(Fuzz, MissingShardsOfASoundMesherAreNotSound) {
  fuzz({"--cases", "4", "--shard", "0/2", "--out", files / "a"}, "none");
  const Outcome part = plain({"--merge", files / "a"});
  EXPECT_EQ(part.exit_code, 4) << part;
  EXPECT_THAT(part.out,
              AllOf(HasSubstr("not all cases were run"), HasSubstr("missing: shard 1 of 2 is missing")));
}

TEST_F(Fuzz, AnotherProcessOnTheSameJournalIsRefused) {
  const Words slow{"--cases", "1",  "--out",    files / "out", "--",
                   "sh",      "-c", "sleep 20", "{surface}",   "{mesh}"};
  const pid_t first = ::fork();
  ASSERT_GE(first, 0);
  if (first == 0) {
    Words all = slow;
    all.insert(all.begin(), program("tetproof-fuzz"));
    std::vector<char*> words;
    for (std::string& word : all) words.push_back(word.data());
    words.push_back(nullptr);
    ::execv(words[0], words.data());
    ::_exit(127);
  }
  for (int k = 0; k < 500 && !files.has("out/scratch-0-of-1"); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  expect_refused(plain(slow), "another process is running this shard");
  ::kill(first, SIGKILL);
  ::waitpid(first, nullptr, 0);
  // The lock went with the process, and with all that it had started.
  const Outcome after = fuzz({"--cases", "1", "--out", files / "out"}, "none");
  expect_refused(after, "other settings: ");
}

// Kills the program itself, with the processes that it started; see also
// tests/unit/corpus/campaign/kill_test.cpp.
TEST_F(Fuzz, GoesOnAfterKills) {
  const std::string bug = "duplicate";
  const auto start = std::chrono::steady_clock::now();
  const Outcome whole = fuzz({"--cases", "40", "--out", files / "whole"}, bug);
  const std::chrono::duration<double> needed = std::chrono::steady_clock::now() - start;
  int kills = 0;
  for (int k = 0; k < 5; ++k, ++kills) {
    const Outcome killed =
        run_program({"timeout", "-s", "KILL", std::to_string(needed.count() / 8), program("tetproof-fuzz"),
                     "--cases", "40", "--out", files / "out", easy[0], easy[1], easy[2], easy[3], "--",
                     program("tetproof-faulty-mesher"), bug, "{surface}", "{mesh}"});
    if (killed.exit_code != 124 && killed.signal != SIGKILL && killed.exit_code != 137) break;  // it was done
  }
  EXPECT_GT(kills, 0);
  const Outcome last = fuzz({"--cases", "40", "--out", files / "out"}, bug);
  EXPECT_EQ(last.exit_code, 1) << last;
  EXPECT_EQ(last.out, whole.out);
  EXPECT_EQ(files.read("out/report.json"), files.read("whole/report.json"));
  EXPECT_FALSE(files.has("out/scratch-0-of-1"));
}

TEST_F(Fuzz, ACampaignWithoutOneMeshIsNotSound) {
  const Outcome run =
      plain({"--cases", "2", "--", "sh", "-c", "echo 'Error: no licence'; exit 1", "{surface}", "{mesh}"});
  EXPECT_EQ(run.exit_code, 4) << run;
  EXPECT_THAT(run.out, HasSubstr("2 refused; not one mesh was judged"));
}

TEST_F(Fuzz, SaysByWhichChecksItJudged) {
  EXPECT_THAT(fuzz({"--check", "flat", "--cases", "2"}, "none").out, HasSubstr("; judged by flat only"));
  EXPECT_THAT(fuzz({"--cases", "2"}, "none").out, ::testing::Not(HasSubstr("judged by")));
}

// What STL's floats round is no fault of the mesher.
TEST_F(Fuzz, ComparesWithTheSurfaceThatTheMesherGot) {
  const Outcome run = plain({"--cases", "20", "--kinds", "cylinder,uv-sphere,bipyramid", "--modifiers",
                             "rotate", "--surface-format", "stl", "--", program("tetproof-faulty-mesher"),
                             "none", "{surface}", "{mesh}"});
  EXPECT_NE(run.exit_code, 1) << run;
  EXPECT_THAT(run.out, ::testing::Not(HasSubstr(": 0 sound")));
}

// The examples of --help: a mesher that puts its mesh beside the surface needs no {mesh}.
TEST_F(Fuzz, TakesACommandWithoutAPlaceForItsMesh) {
  const Outcome run = plain({"--cases", "2", "--surface-format", "smesh", "--mesh-ending", ".1.ele", "--",
                             "sh", "-c", "echo 'Error: no'; exit 1", "{surface}"});
  EXPECT_EQ(run.exit_code, 4) << run;
}

TEST_F(Fuzz, WrongUsageIsOneLine) {
  expect_refused(plain({"--merge", files / "none", "--shrink", "3"}), "--merge runs nothing");

  expect_refused(plain({}), "--mesher NAME, or -- COMMAND");
  expect_refused(plain({"--", "tetgen", "{surface}"}), "{mesh}");
  expect_refused(plain({"--", "tetgen", "{mesh}"}), "{surface}");
  expect_refused(plain({"--mesher", "tetgen", "--", "m", "{surface}", "{mesh}"}), "found both");
  expect_refused(plain({"--mesher", "no-such-mesher"}), "no-such-mesher");
  expect_refused(plain({"--no-such-option"}), "--no-such-option");
  expect_refused(fuzz({"--cases", "0"}, "none"), "--cases");
  expect_refused(fuzz({"--shrink", "3"}, "none"), "--out");
  expect_refused(fuzz({"--shard", "4/4", "--out", files / "x"}, "none"), "4 of 4");
  expect_refused(fuzz({"--shard", "1/4"}, "none"), "--out");
  expect_refused(fuzz({"--check", "no-such-check"}, "none"), "no-such-check");
  expect_refused(plain({"--kinds", "no-such-kind", "--", "m", "{surface}", "{mesh}"}), "no-such-kind");
  expect_refused(plain({"--surface-format", "doc", "--", "m", "{surface}", "{mesh}"}), "doc");
  expect_refused(plain({"--merge", files / "none"}), "none");
  expect_refused(plain({"--replay", "nonsense", "--mesher", "tetgen"}), "nonsense");
  expect_refused(fuzz({"--json", files / "none/x.json", "--cases", "1"}, "none"), "none/x.json");
  expect_refused(fuzz({"--json", "-", "--junit", "-"}, "none"), "standard output");
  EXPECT_TRUE(files.names().empty());
}

TEST_F(Fuzz, TheSameBytesForAnyNumberOfThreads) {
  const std::string one = fuzz({"--cases", "8", "--threads", "1", "--json", "-"}, "duplicate").out;
  EXPECT_EQ(json::parse(one)["by_mesher"].size(), 1u);
  EXPECT_EQ(fuzz({"--cases", "8", "--threads", "3", "--json", "-"}, "duplicate").out, one);
}

TEST_F(Fuzz, ListsKindsAndPresets) {
  const Outcome kinds = plain({"--list-kinds"}), presets = plain({"--print-preset"});
  EXPECT_EQ(kinds.exit_code, 0);
  EXPECT_THAT(kinds.out, AllOf(HasSubstr("chazelle"), HasSubstr("offset")));
  EXPECT_EQ(presets.exit_code, 0);
  EXPECT_THAT(presets.out, AllOf(HasSubstr("tetgen"), HasSubstr("hxt"), HasSubstr("{surface}")));
}

TEST_F(Fuzz, HelpAndVersion) {
  const Outcome help = plain({"--help"}), version = plain({"--version"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, AllOf(StartsWith("Examples:\n"), HasSubstr("--shard"), HasSubstr("COMMAND"),
                              HasSubstr("{size}")));
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, AllOf(HasSubstr("tetproof-fuzz "), HasSubstr("CGAL ")));
}

}  // namespace
}  // namespace tetproof::test
