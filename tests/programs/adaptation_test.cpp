// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-mesh with adaptation, as a user runs it: natural ends, writing and following traces, the shipped
// traces.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using Words = std::vector<std::string>;

const std::string surfaces = TETPROOF_SOURCE_DIR "/corpus/surfaces/";
const std::string traces = TETPROOF_SOURCE_DIR "/corpus/vectors/traces/";

Outcome mesh(Words arguments) {
  arguments.insert(arguments.begin(), program("tetproof-mesh"));
  return run_program(arguments, {.timeout_s = 600});
}

Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// Every setting of the volume law and each way of improving, with and without curvature, comes to a natural
// end and has a certificate.
struct Setting {
  const char* name;
  Words options;
};
const Setting settings[] = {
    {"p1", {"--v0", "0.1", "--v1", "1"}},
    {"root", {"--v0", "0.2", "--v1", "2", "--p", "0.25"}},
    {"cubic", {"--v0", "0.1", "--v1", "1", "--p", "3", "--improve", "none"}},
    {"curvature", {"--v0", "0.2", "--v1", "2", "--curvature", "--improve", "aspect-ratio"}},
    {"outside", {"--v0", "0.1", "--v1", "1", "--region", "outside"}},
    {"snapped", {"--v0", "0.2", "--v1", "2", "--on-surface", "0.1", "--diagonals", "shortest"}},
};
const char* const adapted[] = {"sphere:n=2000", "torus:n=2000",    "wing:n=2000",
                               "spot.obj",      "plate_holes.STL", "Cray_left.obj"};

class NaturalEnd : public testing::TestWithParam<std::tuple<const char*, Setting>> {};

TEST_P(NaturalEnd, WithACertificate) {
  const auto& [surface, setting] = GetParam();
  const std::string file = std::string(surface).find(':') == std::string::npos ? surfaces + surface : surface;
  const ScratchFolder folder;
  const Outcome run = mesh(
      Words{file, "-o", folder / "g.msh", "--cells", "14", "--voxels", "0", "--json", "-"} + setting.options);
  const json report = json::parse(run.out);
  if (!report.contains("adaptation")) {  // nothing to adapt, and nothing to certify
    EXPECT_EQ(report["generation"]["first_grid"]["tets"], 0);
    EXPECT_TRUE(report["certificate"].is_null());
    EXPECT_EQ(run.exit_code, 1) << run;
    return;
  }
  ASSERT_EQ(run.exit_code, 0) << run;
  EXPECT_EQ(report["certificate"], true);
  const json& adaptation = report["adaptation"];
  EXPECT_THAT(adaptation["stopped"], testing::AnyOf("no-gain", "dilution", "stalled"));
  EXPECT_LE(adaptation["e_avg_last"], adaptation["e_avg_first"]);
  std::int64_t rows = 0;
  for (const auto& [row, count] : adaptation["rows"].items()) rows += count.get<std::int64_t>();
  EXPECT_EQ(rows, adaptation["insertions"]);
  EXPECT_EQ(adaptation["rows"].size(), 11u);
  EXPECT_EQ(adaptation["rows"]["2b"], 0) << "cannot occur in a generated grid";
  EXPECT_EQ(report["mesh"]["points"], report["generation"]["first_grid"]["points"].get<std::int64_t>() +
                                          adaptation["insertions"].get<std::int64_t>());
}
INSTANTIATE_TEST_SUITE_P(Surfaces, NaturalEnd,
                         testing::Combine(testing::ValuesIn(adapted), testing::ValuesIn(settings)),
                         [](const auto& each) {
                           const std::string surface = std::get<0>(each.param);
                           return surface.substr(0, surface.find_first_of(":._")) + "_" +
                                  std::get<1>(each.param).name;
                         });

TEST(Adaptation, IsTheSameOnAnyNumberOfThreads) {
  const ScratchFolder folder;
  for (const char* threads : {"1", "2", "5"})
    ASSERT_EQ(
        mesh({surfaces + "spot.obj", "-o", folder / (std::string(threads) + ".msh"), "--cells", "12",
              "--curvature", "--trace", folder / (std::string(threads) + ".jsonl"), "--threads", threads})
            .exit_code,
        0);
  for (const char* ending : {".msh", ".jsonl"}) {
    EXPECT_EQ(folder.read(std::string("1") + ending), folder.read(std::string("2") + ending));
    EXPECT_EQ(folder.read(std::string("1") + ending), folder.read(std::string("5") + ending));
  }
}

TEST(Adaptation, ATinyV0EndsByDilutionAndGoesOnIfAsked) {
  const ScratchFolder folder;
  const Words tiny{
      "sphere:n=2000", "-o",   folder / "g.msh", "--cells", "12",     "--v0", "0.001", "--v1", "1",
      "--improve",     "none", "--parametric",   "off",     "--json", "-"};
  const Outcome ends = mesh(tiny);
  ASSERT_EQ(ends.exit_code, 0) << ends;
  const json first = json::parse(ends.out);
  EXPECT_EQ(first["adaptation"]["stopped"], "dilution");
  const Outcome goes_on = mesh(tiny + Words{"--past-dilution", "--points", "60000"});
  // The tetrahedra are tiny beside the others. All of them are judged.
  ASSERT_EQ(goes_on.exit_code, 0) << goes_on;
  const json past = json::parse(goes_on.out);
  EXPECT_EQ(past["not_judged"].size(), 0u);
  EXPECT_EQ(past["adaptation"]["insertions"], 60000);
  EXPECT_GT(past["adaptation"]["insertions"], first["adaptation"]["insertions"]);
  EXPECT_EQ(past["certificate"], true) << "nothing degenerates";
}

// A line of the list of traces: a name, and the arguments that make the trace.
struct Shipped {
  std::string name;
  Words arguments;
};
std::vector<Shipped> shipped_traces() {
  std::vector<Shipped> all;
  std::ifstream list(traces + "list.txt");
  for (std::string line; std::getline(list, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    Shipped one;
    words >> one.name;
    for (std::string word; words >> word;) one.arguments.push_back(word);
    all.push_back(one);
  }
  return all;
}

std::string read(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

class ShippedTraces : public testing::TestWithParam<Shipped> {};

TEST_P(ShippedTraces, HaveNotDrifted) {
  const ScratchFolder folder;
  const std::string file = traces + GetParam().name + ".jsonl";
  EXPECT_LT(std::filesystem::file_size(file), 300000u);
  const Outcome run =
      mesh(GetParam().arguments + Words{"--voxels", "0", "--trace", folder / "now.jsonl", "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run;
  EXPECT_TRUE(folder.read("now.jsonl") == read(file)) << "corpus/vectors/traces.sh makes them anew";
  const Outcome same = run_program({program("tetproof-compare"), folder / "now.jsonl", file});
  EXPECT_EQ(same.exit_code, 0) << same;
}

TEST_P(ShippedTraces, AreAdmissible) {
  const std::string file = traces + GetParam().name + ".jsonl";
  const Outcome run = mesh(GetParam().arguments + Words{"--voxels", "0", "--follow", file, "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run;
  const json report = json::parse(run.out);
  EXPECT_EQ(report["follow"]["admissible"], true);
  EXPECT_EQ(report["follow"]["ties"], 0);
  if (read(file).find("\"not-asked\"") == std::string::npos) {
    EXPECT_GT(report["adaptation"]["insertions"], 15);
  }
}

// The shipped traces are more than a record of the fast engine's own results: the page writes the same bytes.
TEST_P(ShippedTraces, AreWhatThePageWrites) {
  const ScratchFolder folder;
  const Outcome run = mesh(GetParam().arguments + Words{"--engine", "paper", "--voxels", "0", "--trace",
                                                        folder / "page.jsonl", "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run;
  EXPECT_TRUE(folder.read("page.jsonl") == read(traces + GetParam().name + ".jsonl"));
}

INSTANTIATE_TEST_SUITE_P(Corpus, ShippedTraces, testing::ValuesIn(shipped_traces()),
                         [](const auto& each) { return each.param.name; });

TEST(Follow, SaysWhereATraceDepartsAndExits1) {
  const ScratchFolder folder;
  std::string text = read(traces + "torus.jsonl");
  // The 30th insertion is changed to another row.
  const std::size_t at = text.find("\"row\"", text.find("\"n\":30,"));
  text.replace(at, text.find(',', at) - at, "\"row\":\"4b\"");
  const std::string other = folder.write("other.jsonl", text);
  Words arguments;
  for (const Shipped& one : shipped_traces())
    if (one.name == "torus") arguments = one.arguments;
  const Outcome run =
      mesh(arguments + Words{"--voxels", "0", "--follow", other, "--json", folder / "f.json"});
  EXPECT_EQ(run.exit_code, 1) << run;
  EXPECT_THAT(run.out, HasSubstr("insertion 30: the tetrahedron at "));
  EXPECT_THAT(run.out, HasSubstr("of Table 4, not 4b"));
  const json report = json::parse(folder.read("f.json"));
  EXPECT_EQ(report["follow"]["admissible"], false);
  EXPECT_EQ(report["adaptation"]["insertions"], 29);
  EXPECT_EQ(report["adaptation"]["stopped"], "diverged");
}

TEST(Follow, WhatIsNoTraceIsBadInput) {
  const ScratchFolder folder;
  for (const auto& [text, says] : std::vector<std::pair<std::string, std::string>>{
           {"solid cube\n", "no.jsonl:1: "}, {"", "the trace breaks off"}}) {
    const Outcome run = mesh({"sphere:n=100", "--cells", "4", "--follow", folder.write("no.jsonl", text)});
    EXPECT_EQ(run.exit_code, 2) << run;
    EXPECT_EQ(lines(run.err), 1u) << run;
    EXPECT_THAT(run.err, HasSubstr(says));
  }
}

}  // namespace
}  // namespace tetproof::test
