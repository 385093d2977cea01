// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-compare on grids as users run it, and what it refuses. Traces: compare_traces_test.cpp.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

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

  static Outcome run(const std::string& other, const std::string& reference,
                     const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{program("tetproof-compare"), other, reference};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words);
  }

  static ScratchFolder* files;
};
ScratchFolder* Compare::files = nullptr;

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

}  // namespace
}  // namespace tetproof::test
