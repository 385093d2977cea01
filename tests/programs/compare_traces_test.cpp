// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-compare on traces as users run it: traces that tetproof-mesh wrote, one of them changed.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Lines = std::vector<std::string>;

std::string joined(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

Lines split(const std::string& text) {
  Lines all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

bool is(const std::string& line, const std::string& kind) {
  return line.starts_with("{\"record\":\"" + kind + "\"");
}

// The position of the n-th record of a kind, from 1.
std::size_t find(const Lines& trace, const std::string& kind, int nth) {
  for (std::size_t i = 0; i < trace.size(); ++i)
    if (is(trace[i], kind) && --nth == 0) return i;
  ADD_FAILURE() << "the trace has too few records " << kind;
  return 0;
}

void edit(std::string& line, const std::function<void(json&)>& change) {
  json record = json::parse(line);
  change(record);
  const json kind = record.at("record");
  record.erase("record");
  line = R"({"record":)" + kind.dump() + "," + record.dump().substr(1);  // the kind stands first, for `is`
}

class CompareTraces : public ::testing::Test {
 protected:
  // The trace of this run.
  static Lines made(const std::string& arguments) {
    static std::map<std::string, Lines> known;
    if (const auto found = known.find(arguments); found != known.end()) return found->second;
    const ScratchFolder scratch;
    Lines words{program("tetproof-mesh")};
    std::istringstream stream(arguments);
    for (std::string word; stream >> word;) words.push_back(word);
    words.insert(words.end(), {"--trace", scratch / "trace.jsonl"});
    const Outcome outcome = run_program(words);
    EXPECT_LE(outcome.exit_code, 1) << outcome;
    return known[arguments] = split(scratch.read("trace.jsonl"));
  }
  static Lines torus() {
    return made(
        "torus:R=1,r=0.4,n=200 --cells 4,4,2 --curvature --v0 0.1 --v1 1 --improve-below 0.01 --points 80");
  }

  Outcome run(const std::string& other, const std::string& reference, const Lines& more = {},
              const RunOptions& options = {}) const {
    Lines words{program("tetproof-compare"), other, reference};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words, options);
  }
  json result(const std::string& other, const std::string& reference, const Lines& more = {}) const {
    Lines words = more;
    words.insert(words.end(), {"--json", "-"});
    return json::parse(run(other, reference, words).out);
  }
  // Expects that the file `wrong` is blamed at this position, in both orders of arguments.
  void expect_blamed(const std::string& wrong, std::size_t at, const std::string& right) const {
    for (const bool first : {true, false}) {
      const Outcome outcome = first ? run(wrong, right) : run(right, wrong);
      EXPECT_EQ(outcome.exit_code, 1) << outcome;
      EXPECT_THAT(outcome.out, StartsWith("they diverge\n"));
      EXPECT_THAT(outcome.out, HasSubstr("\n  wrong is " + wrong + ":" + std::to_string(at + 1) + ": "));
      const json said = first ? result(wrong, right) : result(right, wrong);
      EXPECT_EQ(said.at("verdict"), "diverges");
      EXPECT_EQ(said.at("wrong").at("file"), wrong);
      EXPECT_EQ(said.at("wrong").at("line"), at + 1);
    }
  }
  std::string write(const std::string& name, const Lines& trace) const {
    return files.write(name, joined(trace));
  }
  // A file of ../shared/cases/oracle, which only the customer's machines have; empty: it is not here.
  static std::string sample(const std::string& name) {
    const std::string path = std::string(TETPROOF_SOURCE_DIR) + "/../shared/cases/oracle/" + name;
    return std::filesystem::exists(path) ? path : "";
  }

  const ScratchFolder files;
};

TEST_F(CompareTraces, ATraceEqualsItself) {
  const std::string path = write("reference.jsonl", torus());
  const Outcome outcome = run(path, path);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(outcome.out, "equal: every decision, 80 insertions and 87 flips\n");
  EXPECT_EQ(outcome.err, "");
  const json said = result(path, path);
  EXPECT_EQ(said.at("compared"), "traces");
  EXPECT_EQ(said.at("verdict"), "equal");
  EXPECT_EQ(said.at("insertions"), 80);
  EXPECT_EQ(said.at("flips"), 87);
  EXPECT_EQ(said.at("count"), 0);
  EXPECT_EQ(said.at("ties"), 0);
  for (const char* key : {"step", "place", "insertion", "what", "wrong"})
    EXPECT_TRUE(said.at(key).is_null()) << key;
  for (const char* key : {"notes", "not_compared"}) EXPECT_EQ(said.at(key), json::array()) << key;
}

TEST_F(CompareTraces, ADivergenceIsNamedWithItsPlace) {
  Lines lines = torus();
  const std::string reference = write("reference.jsonl", lines);
  const std::size_t at = find(lines, "insertion", 17);
  const std::string row = json::parse(lines[at]).at("row"), wrong = row == "3b" ? "3a" : "3b";
  edit(lines[at], [&](json& record) { record["row"] = wrong; });
  const std::string other = write("other.jsonl", lines);
  const Outcome outcome = run(other, reference);
  EXPECT_THAT(outcome.out, StartsWith("they diverge\nthey part at step (vi), Table 4:\n"
                                      "insertion 17: both split the tetrahedron at ("));
  EXPECT_THAT(outcome.out, HasSubstr("reference by row " + row + " of Table 4, other by row " + wrong));
  EXPECT_THAT(outcome.out, HasSubstr("\n  other (" + other + ":" + std::to_string(at + 1) + "): "));
  EXPECT_THAT(outcome.out, HasSubstr("\n  found the same: 16 insertions and "));
  expect_blamed(other, at, reference);
  const json said = result(other, reference);
  EXPECT_EQ(said.at("step"), "table-4");
  EXPECT_EQ(said.at("place"), "step (vi), Table 4");
  EXPECT_EQ(said.at("insertion"), 17);
  EXPECT_EQ(said.at("count"), 1);
  EXPECT_EQ(said.at("other").at("line"), at + 1);
  EXPECT_EQ(said.at("other").at("record"), json::parse(lines[at]));
  EXPECT_EQ(said.at("reference").at("file"), reference);
  EXPECT_THAT(said.at("wrong").at("says").get<std::string>(), HasSubstr("of Table 4, not " + wrong));
}

TEST_F(CompareTraces, FlipsInAnotherOrder) {
  Lines lines = torus();
  const std::string reference = write("reference.jsonl", lines);
  std::size_t at = 0;
  for (int n = 1; !at || !is(lines[at + 1], "flip"); ++n) at = find(lines, "flip", n);
  std::swap(lines[at], lines[at + 1]);
  expect_blamed(write("other.jsonl", lines), at, reference);
}

TEST_F(CompareTraces, AFlipOfTheOtherKind) {
  Lines lines = torus();
  const std::string reference = write("reference.jsonl", lines);
  const std::size_t at = find(lines, "flip", 40);
  edit(lines[at], [](json& flip) { flip["kind"] = flip["kind"] == "2-3" ? "3-2" : "2-3"; });
  expect_blamed(write("other.jsonl", lines), at, reference);
}

TEST_F(CompareTraces, SamplesOfTheCustomer) {
  const std::string swapped = sample("swapped.jsonl"), kind = sample("flip-kind.jsonl"),
                    edited = sample("p025-edited.jsonl"), ours = sample("p025-ours.jsonl");
  if (swapped.empty() || kind.empty() || edited.empty() || ours.empty())
    GTEST_SKIP() << "the samples of ../shared/cases/oracle are not here";
  const std::string reference = write("torus.jsonl", torus());
  expect_blamed(swapped, 473, reference);
  expect_blamed(kind, 538, reference);
  EXPECT_EQ(run(edited, ours).exit_code, 0);
  EXPECT_THAT(run(ours, edited).out, StartsWith("equal: every decision, "));
}

// Where d is only rounding, V(d) may differ by what the root function makes of it.
TEST_F(CompareTraces, ADesiredVolumeWhereItIsSteep) {
  Lines lines = made(
      "groove:m=3,depth=1 --region outside --cells 3,4,2 --box-scale 1.3333333333333333 --on-surface 0.1 --p "
      "0.25 "
      "--v0 0.2 --v1 2 --points 5");
  const std::string reference = write("reference.jsonl", lines);
  const json law = json::parse(lines[find(lines, "first_grid", 1)]);
  const auto tiny = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
    return is(line, "weight") && json::parse(line).at("d") < 1e-12 && json::parse(line).at("d") > 0;
  });
  ASSERT_NE(tiny, lines.end());
  const auto at = static_cast<std::size_t>(tiny - lines.begin());
  const auto with = [&](double factor) {
    Lines changed = lines;
    edit(changed[at], [&](json& weight) {
      weight["d"] = weight.at("d").get<double>() * 2;
      const double t = std::pow(weight.at("d").get<double>() / law.at("d1").get<double>(), 0.25);
      const double desired = ((1 - t) * law.at("v0").get<double>() + t * law.at("v1").get<double>()) * factor;
      weight["desired"] = desired;
      weight["error"] = std::abs(weight.at("volume").get<double>() - desired);
    });
    return changed;
  };
  const std::string right = write("right.jsonl", with(1)), wrong = write("wrong.jsonl", with(1.1));
  EXPECT_EQ(run(right, reference).exit_code, 0);
  EXPECT_EQ(run(reference, right).exit_code, 0);
  expect_blamed(wrong, at, reference);
}

// On a symmetric surface several splits are equally good: here the first two are made in the other order.
TEST_F(CompareTraces, AProvenTie) {
  Lines lines = made("sphere:r=1,n=128 --parametric off --cells 4 --v1 1 --improve none --points 20");
  const std::string reference = write("reference.jsonl", lines);
  const std::size_t first = find(lines, "insertion", 1), second = find(lines, "insertion", 2);
  const auto exchange = [&](const char* key) {
    json of_first = json::parse(lines[first]).at(key), of_second = json::parse(lines[second]).at(key);
    edit(lines[first], [&](json& record) { record[key] = of_second; });
    edit(lines[second], [&](json& record) { record[key] = of_first; });
  };
  for (const char* key : {"tet", "row", "replaced", "point"}) exchange(key);
  const std::string other = write("other.jsonl", lines);
  for (const auto& [one, two] : {std::pair(other, reference), std::pair(reference, other)}) {
    const Outcome outcome = run(one, two);
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    EXPECT_THAT(outcome.out,
                StartsWith("equal but for 1 proven tie: each is admissible to its end\n"
                           "they part at step (vi), eq. (3.5):\ninsertion 1: reference splits "));
    const json said = result(one, two);
    EXPECT_EQ(said.at("verdict"), "tie");
    EXPECT_EQ(said.at("ties"), 1);
    EXPECT_EQ(said.at("insertion"), 1);
    EXPECT_TRUE(said.at("wrong").is_null());
  }
  // A mistake after the tie is found, too.
  const std::size_t later = find(lines, "insertion", 15);
  edit(lines[later], [](json& record) { record["e_avg"] = record.at("e_avg").get<double>() * 1.001; });
  expect_blamed(write("wrong.jsonl", lines), later, reference);
}

TEST_F(CompareTraces, RowsWithAnotherNameForTheSameTetrahedra) {
  Lines lines = torus();
  const std::string reference = write("reference.jsonl", lines);
  const std::size_t at = find(lines, "rows", 5);
  edit(lines[at], [](json& record) { record["rows"][0] = record["rows"][0] == "10a" ? "10d" : "10a"; });
  const std::string other = write("other.jsonl", lines);
  EXPECT_THAT(result(other, reference).at("what").get<std::string>(),
              ::testing::EndsWith("; the tetrahedra of the first grid are the same"));
  expect_blamed(other, at, reference);
}

TEST_F(CompareTraces, ATraceThatBreaksOff) {
  const Lines lines = torus();
  const std::string reference = write("reference.jsonl", lines);
  const auto broken = [&](std::size_t length) {
    return write("other.jsonl", Lines(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(length)));
  };
  const std::size_t insertion = find(lines, "insertion", 30);
  expect_blamed(broken(insertion), insertion - 1, reference);
  for (const std::size_t length :
       {find(lines, "cut", 9), find(lines, "first_grid", 1), find(lines, "weight", 9)}) {
    const Outcome outcome = run(broken(length), reference);
    EXPECT_EQ(outcome.exit_code, 2) << outcome;
    EXPECT_THAT(outcome.err, HasSubstr("other.jsonl:" + std::to_string(length) + ": expected "));
  }
}

TEST_F(CompareTraces, WhatATraceLeavesOutIsNotCompared) {
  Lines lines = torus();
  const std::string reference = write("reference.jsonl", lines);
  std::erase_if(lines, [](const std::string& line) { return is(line, "rows"); });
  const std::string other = write("other.jsonl", lines);
  const Outcome outcome = run(other, reference);
  EXPECT_EQ(outcome.exit_code, 4) << outcome;
  EXPECT_EQ(outcome.out,
            "equal: every decision, 80 insertions and 87 flips\n"
            "  not compared: rows of Table 2: other has none\n");
  EXPECT_EQ(result(other, reference).at("not_compared"), json({"rows of Table 2: other has none"}));
}

TEST_F(CompareTraces, OtherSettingsBlameNobody) {
  Lines lines = torus();
  const std::string reference = write("reference.jsonl", lines);
  edit(lines[0], [](json& settings) { settings["p"] = 2; });
  const Outcome outcome = run(write("other.jsonl", lines), reference);
  EXPECT_EQ(outcome.exit_code, 1) << outcome;
  EXPECT_THAT(outcome.out, HasSubstr("the settings differ: p is 1 in reference, 2 in other"));
  EXPECT_THAT(outcome.out, ::testing::Not(HasSubstr("wrong is")));
}

// The surface is looked for where the program runs, beside the trace, and under the name that is given.
class CompareOnASurface : public CompareTraces {
 protected:
  CompareOnASurface() {
    files.write("part.off",
                "OFF\n6 8 0\n1 0 0\n-1 0 0\n0 1.1 0\n0 -1 0\n0 0 1.3\n0 0 -1\n3 0 2 4\n3 2 1 4\n3 1 3 4\n"
                "3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n");
    const Outcome outcome = run_program({program("tetproof-mesh"), "part.off", "--cells", "5", "--v0", "0.2",
                                         "--v1", "1", "--points", "9", "--trace", "reference.jsonl"},
                                        {.directory = files.path()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    Lines lines = split(files.read("reference.jsonl"));
    at = find(lines, "insertion", 4);
    edit(lines[at], [](json& record) { record["e_avg"] = record.at("e_avg").get<double>() * 1.01; });
    write("other.jsonl", lines);
  }
  const std::string other = files / "other.jsonl", reference = files / "reference.jsonl";
  std::size_t at = 0;
};

TEST_F(CompareOnASurface, WhereTheProgramRunsOrBesideTheTrace) {
  expect_blamed(other, at, reference);
  const ScratchFolder elsewhere;
  elsewhere.write("other.jsonl", files.read("other.jsonl"));
  const Outcome outcome = run(elsewhere / "other.jsonl", "reference.jsonl", {}, {.directory = files.path()});
  EXPECT_EQ(outcome.exit_code, 1) << outcome;
  EXPECT_THAT(outcome.out, HasSubstr("wrong is " + elsewhere / "other.jsonl" + ":" + std::to_string(at + 1)));
}

TEST_F(CompareOnASurface, NotFound) {
  std::filesystem::rename(files / "part.off", files / "other-name.off");
  Outcome outcome = run(other, reference);
  EXPECT_EQ(outcome.exit_code, 4) << outcome;
  EXPECT_THAT(outcome.out, StartsWith("unresolved: it is not known which of them is wrong\n"));
  EXPECT_THAT(outcome.out,
              HasSubstr("  note: " + other +
                        " could not be checked: its surface, 'part.off', is not found; --surface FILE "
                        "says where it is\n"));
  const json said = result(other, reference);
  EXPECT_EQ(said.at("verdict"), "unresolved");
  EXPECT_TRUE(said.at("wrong").is_null());
  EXPECT_EQ(said.at("notes").size(), 2u);

  outcome = run(other, reference, {"--surface", files / "other-name.off"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome;
  EXPECT_THAT(outcome.out, HasSubstr("\n  wrong is " + other + ":" + std::to_string(at + 1) + ": "));
  outcome = run(other, reference, {"--surface", files / "missing.off"});
  EXPECT_EQ(outcome.exit_code, 4) << outcome;
  EXPECT_THAT(outcome.out, HasSubstr("missing.off"));
}

TEST_F(CompareOnASurface, StandardInputAndPipes) {
  const auto piped = [&](const std::string& name, const Lines& arguments) {
    Lines words{program("tetproof-compare")};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run_program(words, {.input = files.read(name)});
  };
  EXPECT_EQ(piped("reference.jsonl", {"-", reference}).exit_code, 0);
  EXPECT_EQ(piped("reference.jsonl", {reference, "-"}).exit_code, 0);
  const Outcome blamed = piped("reference.jsonl", {other, "-"});  // the file is the wrong one
  EXPECT_EQ(blamed.exit_code, 1) << blamed;
  const Outcome outcome = piped("other.jsonl", {"-", reference});
  EXPECT_EQ(outcome.exit_code, 4) << outcome;
  EXPECT_THAT(outcome.out, HasSubstr("standard input can be read only once"));
  const Outcome pipe = run_program(
      {"bash", "-c", "\"$0\" <(cat \"$1\") \"$1\"; echo $?", program("tetproof-compare"), reference});
  EXPECT_THAT(pipe.out, ::testing::EndsWith("\n0\n")) << pipe;
  const Outcome differs = run_program(
      {"bash", "-c", "\"$0\" <(cat \"$1\") \"$2\"; echo $?", program("tetproof-compare"), other, reference});
  EXPECT_THAT(differs.out, ::testing::EndsWith("\n4\n")) << differs;
  EXPECT_THAT(differs.out, HasSubstr("a pipe can be read only once"));
}

}  // namespace
}  // namespace tetproof::test
