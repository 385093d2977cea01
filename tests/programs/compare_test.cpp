// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-compare as users run it: traces and grids that tetproof-mesh wrote, one of them changed.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// A trace and a grid, made once for all tests.
class Compare : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    files = new ScratchFolder;
    const Outcome made = run_program({program("tetproof-mesh"), "random:seed=7", "--cells", "5", "-o",
                                      *files / "reference.msh", "--trace", *files / "reference.jsonl"});
    ASSERT_EQ(made.exit_code, 0) << made;
  }
  static void TearDownTestSuite() {
    delete files;
    files = nullptr;
  }

  static std::vector<std::string> trace() {
    std::vector<std::string> all;
    std::istringstream stream(files->read("reference.jsonl"));
    for (std::string line; std::getline(stream, line);) all.push_back(line);
    return all;
  }
  static std::string write(const std::string& name, const std::vector<std::string>& trace) {
    std::string text;
    for (const std::string& line : trace) text += line + "\n";
    return files->write(name, text);
  }
  static std::size_t find(const std::vector<std::string>& trace, const std::string& kind, int nth) {
    for (std::size_t i = 0; i < trace.size(); ++i)
      if (trace[i].starts_with("{\"record\":\"" + kind + "\"") && --nth == 0) return i;
    ADD_FAILURE() << "the trace has too few records " << kind;
    return 0;
  }
  static Outcome run(const std::string& other, const std::string& reference,
                     const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{program("tetproof-compare"), other, reference};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words);
  }

  static ScratchFolder* files;
};
ScratchFolder* Compare::files = nullptr;

TEST_F(Compare, ATraceEqualsItself) {
  const std::string path = *files / "reference.jsonl";
  const Outcome outcome = run(path, path);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_THAT(outcome.out, StartsWith("equal: every decision, "));
  EXPECT_EQ(outcome.err, "");
  const json result = json::parse(run(path, path, {"--json", "-"}).out);
  EXPECT_EQ(result.at("compared"), "traces");
  EXPECT_EQ(result.at("verdict"), "equal");
  EXPECT_GT(result.at("insertions"), 100);
  for (const char* key : {"step", "place", "insertion", "what"}) EXPECT_TRUE(result.at(key).is_null()) << key;
  EXPECT_EQ(result.at("notes"), json::array());
}

TEST_F(Compare, ADivergenceIsNamedWithItsPlace) {
  std::vector<std::string> lines = trace();
  const std::size_t at = find(lines, "insertion", 17);
  json record = json::parse(lines[at]);
  const std::string row = record.at("row"), wrong = row == "3b" ? "3a" : "3b";
  record["row"] = wrong;
  lines[at] = record.dump();
  const std::string other = write("other.jsonl", lines);
  const Outcome outcome = run(other, *files / "reference.jsonl");
  EXPECT_EQ(outcome.exit_code, 1) << outcome;
  EXPECT_THAT(outcome.out,
              StartsWith("they diverge, step (vi), Table 4:\ninsertion 17: both split the tetrahedron at ("));
  EXPECT_THAT(outcome.out, HasSubstr("reference by row " + row + " of Table 4, other by row " + wrong));
  EXPECT_THAT(outcome.out, HasSubstr("\n  other (" + other + ":" + std::to_string(at + 1) + "): "));
  const json result = json::parse(run(other, *files / "reference.jsonl", {"--json", "-"}).out);
  EXPECT_EQ(result.at("verdict"), "diverges");
  EXPECT_EQ(result.at("step"), "table-4");
  EXPECT_EQ(result.at("insertion"), 17);
  EXPECT_EQ(result.at("other").at("line"), at + 1);
  EXPECT_EQ(result.at("other").at("record"), record);
  EXPECT_EQ(result.at("reference").at("file"), *files / "reference.jsonl");
}

// Two insertions are made a tie: both get the same E_avg, and their order is exchanged.
TEST_F(Compare, ATieIsNoDivergence) {
  std::vector<std::string> reference = trace();
  const std::size_t first = find(reference, "insertion", 3), second = find(reference, "insertion", 4);
  ASSERT_EQ(second, first + 1) << "no flips between the two";
  std::vector<std::string> other = reference;
  json one = json::parse(reference[first]), two = json::parse(reference[second]);
  std::swap(one["n"], two["n"]), std::swap(one["e_avg"], two["e_avg"]);
  other[first] = two.dump(), other[second] = one.dump();
  Outcome outcome = run(write("other.jsonl", other), *files / "reference.jsonl");
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_THAT(outcome.out, HasSubstr(", 2 of them in another order within ties"));
  other.resize(second), reference.resize(second);  // the traces end within the tie
  outcome = run(write("other.jsonl", other), write("short.jsonl", reference));
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_THAT(outcome.out, StartsWith("a tie, step (vi), eq. (3.5):\ninsertion 3: reference splits"));
  EXPECT_THAT(outcome.out, HasSubstr("tetproof-mesh --follow checks the rest"));
  const json result = json::parse(run(*files / "other.jsonl", *files / "short.jsonl", {"--json", "-"}).out);
  EXPECT_EQ(result.at("verdict"), "tie");
  EXPECT_EQ(result.at("insertions"), 2);
}

TEST_F(Compare, GridsAreComparedAcrossFormats) {
  const std::string grid = *files / "reference.msh";
  for (const char* name : {"copy.1.node", "copy.msh"})
    ASSERT_EQ(run_program({program("tetproof-convert"), grid, *files / name}).exit_code, 0);
  Outcome outcome = run(*files / "copy.1.ele", grid);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_THAT(outcome.out, StartsWith("equal up to numbering: "));

  // Moves node 1 of the copy.
  std::string nodes = files->read("copy.1.node");
  const std::size_t line = nodes.find("\n1 ") + 1;
  nodes.replace(line, nodes.find('\n', line) - line, "1 7 8 9");
  files->write("copy.1.node", nodes);
  outcome = run(*files / "copy.1.node", grid);
  EXPECT_EQ(outcome.exit_code, 1) << outcome;
  EXPECT_THAT(outcome.out, StartsWith("the grids differ:\nonly in " + grid + ": "));
  EXPECT_THAT(outcome.out, HasSubstr("\n  point 1: (7, 8, 9)\n"));
  const json result = json::parse(run(*files / "copy.1.node", grid, {"--json", "-"}).out);
  EXPECT_EQ(result.at("compared"), "grids");
  EXPECT_EQ(result.at("verdict"), "diverges");
  EXPECT_EQ(result.at("other").at("points_only_here"), 1);
  EXPECT_EQ(result.at("other").at("first_points").at(0),
            json::parse(R"({"number":1,"point":[7.0,8.0,9.0]})"));
  EXPECT_EQ(result.at("other").at("tets_only_here"), result.at("reference").at("tets_only_here"));

  outcome = run(*files / "copy.1.node", grid, {"--tolerance", "0.1"});  // wider than the tetrahedra
  EXPECT_NE(outcome.exit_code, 3) << outcome;
}

TEST_F(Compare, WhatCannotBeComparedIsRefused) {
  const std::string grid = *files / "reference.msh", good = *files / "reference.jsonl";
  const auto refused = [&](const std::string& other, const std::string& reference, const std::string& what,
                           const std::vector<std::string>& more = {}) {
    const Outcome outcome = run(other, reference, more);
    EXPECT_EQ(outcome.exit_code, 2) << outcome;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines(outcome.err), 1u) << outcome;
    EXPECT_THAT(outcome.err, HasSubstr(what));
  };
  refused(grid, good, good + " is a trace, and " + grid + " is not: two traces or two grids are compared");
  refused(good, grid, good + " is a trace, and " + grid + " is not");
  refused(files->write("trace.txt", files->read("reference.jsonl")), grid, "trace.txt is a trace");
  refused(files->write("empty.jsonl", ""), good, "expected a lattice record");
  refused(files->write("text.jsonl", "hello\n"), good,
          "text.jsonl:1: expected a record as JSON in one line, found 'hello'");
  refused(*files / "missing.jsonl", good, "missing.jsonl: cannot open");
  refused(files->path(), good, "a trace, and");
  std::filesystem::create_directories(*files / "folder.jsonl");
  refused(*files / "folder.jsonl", good, "Is a directory");
  refused(files->write("surface.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), grid,
          "surface.off: holds no tetrahedra");
  refused(good, good, "--tolerance", {"--tolerance", "-1"});
  refused(good, good, "--tolerance", {"--tolerance", "nan"});
}

TEST_F(Compare, TracesComeThroughPipes) {
  const Outcome outcome = run_program({"bash", "-c", "\"$0\" <(cat \"$1\") \"$1\"; echo $?",
                                       program("tetproof-compare"), *files / "reference.jsonl"});
  EXPECT_THAT(outcome.out, ::testing::EndsWith("\n0\n")) << outcome;
}

}  // namespace
}  // namespace tetproof::test
