// SPDX-License-Identifier: GPL-3.0-or-later
// The shipped traces and what is shipped beside them: surfaces, schemas, and the table of what is covered.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using Words = std::vector<std::string>;

const std::string vectors = TETPROOF_SOURCE_DIR "/corpus/vectors/", traces = vectors + "traces/";
const std::string python = "/usr/bin/python3";

struct Shipped {
  std::string name;
  Words arguments;
  bool without_ties = false;

  std::string trace() const { return traces + name + ".jsonl"; }
};

// The lines of list.txt. Its last comment says that the traces below it have no ties.
std::vector<Shipped> shipped() {
  std::vector<Shipped> all;
  std::ifstream list(traces + "list.txt");
  bool without_ties = false;
  for (std::string line; std::getline(list, line);) {
    if (line.starts_with('#')) {
      without_ties |= line.find("have no ties") != line.npos;
      continue;
    }
    std::istringstream words(line);
    Shipped one{.name = "", .arguments = {}, .without_ties = without_ties};
    words >> one.name;
    for (std::string word; words >> word;) one.arguments.push_back(word);
    all.push_back(one);
  }
  return all;
}

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Outcome mesh(const Words& arguments) {
  return run_program(Words{program("tetproof-mesh")} + arguments + Words{"--voxels", "0", "--quiet"},
                     {.timeout_s = 600});
}

Json comparison(const std::string& other, const std::string& reference) {
  const ScratchFolder folder;
  run_program({program("tetproof-compare"), other, reference, "--json", folder / "c.json"});
  return Json::parse(folder.read("c.json"));
}

class Traces : public testing::TestWithParam<Shipped> {};

TEST_P(Traces, AreSmall) {
  EXPECT_LT(std::filesystem::file_size(GetParam().trace()), 300000u);
}

TEST_P(Traces, AreWhatThePageDecides) {
  const ScratchFolder folder;
  const Outcome run =
      mesh(GetParam().arguments + Words{"--engine", "paper", "--trace", folder / "page.jsonl"});
  ASSERT_EQ(run.exit_code, 0) << run;
  EXPECT_EQ(comparison(folder / "page.jsonl", GetParam().trace())["verdict"], "equal");
}

// Other rounding errors of distances, errors, gains and parametric points change no decision.
TEST_P(Traces, HaveNoTies) {
  if (!GetParam().without_ties) GTEST_SKIP() << "the symmetries of its surface bring ties";
  for (const char* seed : {"1", "2", "3"}) {
    const ScratchFolder folder;
    const Outcome run = run_program(Words{ROUNDED_PAGE, seed} + GetParam().arguments +
                                    Words{"--trace", folder / "rounded.jsonl"});
    ASSERT_EQ(run.exit_code, 0) << run;
    const Json compared = comparison(folder / "rounded.jsonl", GetParam().trace());
    EXPECT_EQ(compared["verdict"], "equal") << compared.dump(1);
    EXPECT_EQ(compared["ties"], 0) << compared.dump(1);
  }
}

TEST_P(Traces, HaveTheirSurfaceAsAFile) {
  const bool parametric = read(GetParam().trace()).find("\"parametric\":true") != std::string::npos;
  const std::string file = traces + GetParam().name + (parametric ? ".obj" : ".off");
  ASSERT_TRUE(std::filesystem::exists(file));
  const ScratchFolder folder;
  const std::string again = folder / std::filesystem::path(file).filename();
  const Outcome made = run_program({program("tetproof-convert"), GetParam().arguments[0], again, "--quiet"});
  ASSERT_EQ(made.exit_code, 0) << made;
  EXPECT_TRUE(read(again) == read(file)) << "corpus/vectors/traces.sh makes it anew";
  EXPECT_EQ(read(file).find("\nvt ") != std::string::npos, parametric);
  if (parametric) {
    const Outcome checked =
        run_program({python, "-B", vectors + "evaluate.py", GetParam().arguments[0], file});
    EXPECT_EQ(checked.exit_code, 0) << checked;
    return;
  }
  // Without the evaluator, the file makes the same trace, but for the surface's name.
  Words arguments = GetParam().arguments;
  arguments[0] = file;
  const Outcome run = mesh(arguments + Words{"--trace", folder / "file.jsonl"});
  ASSERT_EQ(run.exit_code, 0) << run;
  const std::string mine = folder.read("file.jsonl"), shipped = read(GetParam().trace());
  EXPECT_TRUE(mine.substr(mine.find('\n')) == shipped.substr(shipped.find('\n')));
}

INSTANTIATE_TEST_SUITE_P(Corpus, Traces, testing::ValuesIn(shipped()),
                         [](const auto& each) { return each.param.name; });

// The formulas of SURFACES.md, as evaluate.py has them, give the vertices of every generator.
TEST(Surfaces, AreWhatTheirFormulasSay) {
  for (const char* spec :
       {"sphere:r=2,n=200,x=0.3", "torus:R=2,r=0.7,n=500,z=-1", "shells:n=300,count=3,inner=0.4",
        "random:seed=9007199254740992,n=500", "random:seed=5,waves=4,roughness=0.9,n=200,y=3",
        "wing:naca=4412,n=300", "wing:naca=0006,n=200,chord=2,span=1"}) {
    const ScratchFolder folder;
    ASSERT_EQ(run_program({program("tetproof-convert"), spec, folder / "s.obj", "--quiet"}).exit_code, 0);
    const Outcome checked = run_program({python, "-B", vectors + "evaluate.py", spec, folder / "s.obj"});
    EXPECT_EQ(checked.exit_code, 0) << spec << checked;
    const Outcome other =
        run_program({python, "-B", vectors + "evaluate.py", "torus:R=3,r=1", folder / "s.obj"});
    EXPECT_EQ(other.exit_code, 1) << other;
  }
}

TEST(Coverage, IsCompleteAndHasNotDrifted) {
  const Outcome checked = run_program({python, "-B", vectors + "coverage.py", "--check"});
  EXPECT_EQ(checked.exit_code, 0) << checked;
}

// A copy of corpus/vectors.
struct Copy {
  ScratchFolder folder;
  Copy() {
    std::filesystem::copy(
        vectors, folder.path(),
        std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
  }
  void replace(const std::string& name, const std::string& what, const std::string& with) {
    std::string text = read(folder / name);
    const std::size_t at = text.find(what);
    ASSERT_NE(at, text.npos) << what;
    folder.write(name, text.replace(at, what.size(), with));
  }
  Outcome check() { return run_program({python, "-B", folder / "coverage.py", "--check"}); }
};

TEST(Coverage, NamesWhatIsMetByNone) {
  Copy without_steps;
  without_steps.replace("traces/list.txt", "\nsteps", "\n#teps");
  const Outcome traces_missing = without_steps.check();
  EXPECT_EQ(traces_missing.exit_code, 1) << traces_missing;
  EXPECT_THAT(traces_missing.out, HasSubstr("Table 4, 4e: met by no trace"));
  EXPECT_THAT(traces_missing.out, HasSubstr("Readings, E4, V0 above V1: met by no trace"));
  EXPECT_THAT(traces_missing.out, HasSubstr("COVERAGE.md has drifted"));

  Copy without_union;
  std::filesystem::remove(without_union.folder / "traces/list.txt");
  without_union.folder.write("traces/list.txt", read(traces + "list.txt"));
  Json edges = Json::parse(read(vectors + "edge_points.json"));
  for (Json& each : edges["cases"])
    each["flags"].erase(std::remove(each["flags"].begin(), each["flags"].end(), "union"),
                        each["flags"].end());
  without_union.folder.write("edge_points.json", edges.dump());
  const Outcome cases_missing = without_union.check();
  EXPECT_EQ(cases_missing.exit_code, 1) << cases_missing;
  EXPECT_THAT(cases_missing.out,
              HasSubstr("Readings, D6, parts along the edge are united: met by no case of edge_points"));
}

TEST(Schemas, TakeAllFilesAndRefuseWhatDeviates) {
  const Outcome checked =
      run_program({python, "-B", TETPROOF_SOURCE_DIR "/tests/vectors/check_schemas.py", vectors});
  if (checked.exit_code == 77) GTEST_SKIP() << "Python's jsonschema is not installed";
  EXPECT_EQ(checked.exit_code, 0) << checked;
  EXPECT_THAT(checked.out, HasSubstr("15 files of vectors"));
}

}  // namespace
}  // namespace tetproof::test
