// SPDX-License-Identifier: GPL-3.0-or-later
// The conformance vectors: reference/ answers all of them, they have not drifted from what makes them, and
// the runner finds what is wrong, in answers and in vectors.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

const std::string source = TETPROOF_SOURCE_DIR;
const std::string python = "/usr/bin/python3";
const std::string runner = source + "/corpus/vectors/run.py";
const std::vector<std::string> kinds{"table1",        "table2",  "table3",     "table4",
                                     "volume_law",    "weights", "choice",     "curvature_weight",
                                     "curvature",     "lattice", "indicators", "edge_points",
                                     "closest_point", "quality", "flips"};

Outcome run(std::vector<std::string> options, const std::string& mistake = "", bool with_command = true) {
  std::vector<std::string> command{python, runner};
  command.insert(command.end(), options.begin(), options.end());
  if (with_command) {
    command.insert(command.end(), {"--", VECTORS_ADAPTER});
    if (!mistake.empty()) command.push_back(mistake);
  }
  return run_program(command);
}

Json vectors(const std::string& kind) {
  std::ifstream file(source + "/corpus/vectors/" + kind + ".json");
  return Json::parse(file);
}

std::set<std::string> with_flag(const std::string& kind, const std::string& flag) {
  std::set<std::string> ids;
  const Json content = vectors(kind);
  for (const Json& one : content["cases"])
    for (const Json& f : one["flags"])
      if (f == flag) ids.insert(one["id"]);
  return ids;
}

std::set<std::string> failing(const std::string& text) {
  std::set<std::string> ids;
  const std::regex line("^FAIL ([^ :]+): .*$", std::regex::multiline);
  for (std::sregex_iterator each(text.begin(), text.end(), line), end; each != end; ++each)
    ids.insert((*each)[1]);
  return ids;
}

class Vectors : public testing::TestWithParam<std::string> {};

TEST_P(Vectors, TheReferenceAnswersAll) {
  const Outcome all = run({"--kind", GetParam()});
  EXPECT_EQ(all.exit_code, 0) << all;
  const std::size_t cases = vectors(GetParam())["cases"].size();
  EXPECT_THAT(all.out, HasSubstr(GetParam() + ": " + std::to_string(cases) + " passed\n")) << all;
}

INSTANTIATE_TEST_SUITE_P(Kinds, Vectors, testing::ValuesIn(kinds),
                         [](const auto& each) { return each.param; });

TEST(VectorFiles, AreConsistent) {
  const Outcome checked = run({}, "", false);
  EXPECT_EQ(checked.exit_code, 0) << checked;
  for (const std::string& kind : kinds)
    EXPECT_THAT(checked.out,
                HasSubstr(kind + ": " + std::to_string(vectors(kind)["cases"].size()) + " cases"));
}

TEST(VectorFiles, HaveNotDrifted) {
  const ScratchFolder folder;
  const Outcome made = run_program({python, "-B", source + "/tests/vectors/make_vectors.py", folder.path()});
  ASSERT_EQ(made.exit_code, 0) << made;
  ASSERT_EQ(folder.names().size(), kinds.size());
  for (const std::string& kind : kinds) {
    std::ifstream file(source + "/corpus/vectors/" + kind + ".json", std::ios::binary);
    const std::string shipped{std::istreambuf_iterator<char>(file), {}};
    EXPECT_TRUE(folder.read(kind + ".json") == shipped)
        << kind << ".json is not what tests/vectors/make_vectors.py makes";
  }
}

// A vector changed on purpose: the checks see that it contradicts itself.
struct Spoiled {
  const char *kind, *id, *pointer;
  Json value;
  const char* what;
};

TEST(VectorFiles, ContradictionsAreFound) {
  const Spoiled spoiled[] = {
      {"table1", "table1-+0--", "/expected/edges/0/1", 1, "exactly where its ends lie on different sides"},
      {"table2", "table2-lowest-zyx/++0-", "/expected/tetrahedra/0/0/0", 2.5, "cover the inside part"},
      {"table2", "table2-lowest-zyx/++0-", "/expected/tetrahedra/1", nullptr, "cover the inside part"},
      {"table3", "table3-row3b-3", "/expected/cuts/0/point/0", 0.75, "closest to the exterior end"},
      {"table3", "table3-settled-low-5", "/expected/indicators/0", 1, "vertex 0 is settled"},
      {"table4", "table4-3b-abc", "/expected/point/0", 9, "the mean of the corners"},
      {"table4",
       "table4-4c-abd-abc",
       "/expected/replaced",
       {0, 2},
       "edge or face that another tetrahedron has"},
      {"volume_law", "volume-p1/3-law2-t1/16", "/expected/volume", 1.0, "eq. (3.1) does not hold"},
      {"weights", "weights-triangle-below", "/expected/tetrahedra/0/d", 1, "eq. (3.2) does not hold"},
      {"choice", "choice-mixed-tie", "/expected/tet", 3, "not the smallest average"},
      {"curvature_weight", "weight-range1-3/8", "/expected/weight", 0.5, "eq. (3.6) does not hold"},
      {"lattice", "lattice-brick-12", "/expected/cells/1", 9, "the cells come closest to cubes"},
      {"lattice", "lattice-cube-3-4-5", "/expected/points/2/0", 0.3, "eq. (2.1) does not hold"},
      {"indicators", "indicators-cube-within", "/expected/indicators/3", 1, "0 exactly on the surface"},
      {"indicators", "indicators-shell-cavity", "/expected/indicators/0", 1, "no others"},
      {"edge_points", "edge-shell-four", "/expected/points/2", nullptr, "the open edge"},
      {"edge_points", "edge-cube-face", "/expected/points/0/2", 2.5,
       "the ends of what the edge has in common"},
      {"closest_point", "closest-cube-0", "/expected/point", {2, 1, 1}, "as close and lexicographically"},
      {"quality", "quality-right", "/expected/solid_angle", 0.0625, "solid_angle is not"},
      {"flips", "flips-gain-0", "/expected/flip", nullptr, "a flip gains, and none is made"},
      {"flips", "flips-two-0-aspect", "/expected/flip/quality/1", 0.5, "the qualities are wrong"},
  };
  for (const Spoiled& one : spoiled) {
    const ScratchFolder folder;
    Json content = vectors(one.kind);
    Json spoiled_case;
    for (Json& each : content["cases"])
      if (each["id"] == one.id) {
        const Json::json_pointer at(one.pointer);
        ASSERT_TRUE(each.contains(at)) << one.id << one.pointer;
        if (one.value.is_null() && each[at.parent_pointer()].is_array())
          each[at.parent_pointer()].erase(std::stoul(at.back()));
        else
          each[at] = one.value;
        spoiled_case = each;
      }
    ASSERT_FALSE(spoiled_case.is_null()) << one.id;
    folder.write("one.json", content.dump());
    const Outcome checked = run({"--folder", folder.path()}, "", false);
    EXPECT_EQ(checked.exit_code, 1) << one.id << checked;
    EXPECT_THAT(checked.out, HasSubstr(one.what)) << one.id;
    EXPECT_EQ(failing(checked.out), std::set<std::string>{one.id}) << checked;
  }
}

// A mistake that a flag hunts makes exactly the cases with this flag fail.
TEST(Runner, NamesWhatAMistakeBreaks) {
  const std::vector<std::array<std::string, 3>> mistakes{
      {"14-cases", "table1", "not-printed"},
      {"l-plus-3", "choice", "l-plus-3"},
      {"cells-cut-off", "lattice", "rounded"},
      {"half-even", "lattice", "half"},
      {"about-origin", "lattice", "centre"},
      {"stray-counts", "lattice", "unused-vertex"},
      {"counts-twice", "indicators", "line-meets-edge"},
      {"open-triangles", "indicators", "on-edge-or-vertex"},
      {"tolerance", "indicators", "near"},
      {"same-signs", "indicators", "outside-region"},
      {"triangles-not-points", "edge_points", "several-triangles"},
      {"no-union", "edge_points", "union"},
      {"ends-count", "edge_points", "ends"},
      {"foot-in-plane", "closest_point", "beyond-the-plane"},
      {"nearest-vertex", "closest_point", "no-vertex"},
      {"last-of-ties", "closest_point", "tie"},
      {"first-angle", "quality", "smallest"},
      {"smallest-face", "quality", "largest-face"},
      {"any-gain", "flips", "no-gain"},
      {"whole-grid", "flips", "within-the-set"},
      {"quality-not-gain", "flips", "gain-not-quality"},
      {"other-criterion", "flips", "criterion"}};
  for (const auto& [mistake, kind, flag] : mistakes) {
    const Outcome broken = run({"--show", "1000"}, mistake);
    EXPECT_EQ(broken.exit_code, 1) << broken;
    EXPECT_EQ(failing(broken.out), with_flag(kind, flag)) << mistake << broken;
    EXPECT_GE(with_flag(kind, flag).size(), 3u);
    EXPECT_THAT(broken.out, HasSubstr(vectors(kind)["flags"][flag].get<std::string>()));
    EXPECT_THAT(broken.out, HasSubstr("\n  expected  "));
    EXPECT_THAT(broken.out, HasSubstr("\n  found     "));
  }
}

TEST(Runner, NegativeTetrahedraAreFound) {
  const Outcome broken =
      run({"--show", "1000", "--kind", "table2", "--skip-flag", "cut-at-vertex"}, "orientation");
  EXPECT_EQ(broken.exit_code, 1) << broken;
  const auto expected = with_flag("table2", "orientation");
  std::size_t found = 0;
  for (const std::string& id : failing(broken.out)) {
    EXPECT_TRUE(expected.contains(id)) << id;
    ++found;
  }
  EXPECT_GT(found, 50u);
  EXPECT_THAT(broken.out, HasSubstr("is not positive"));
}

TEST(Runner, ACommandThatFailsIsAFailure) {
  const std::string eighth = vectors("table3")["cases"][7]["id"];
  const auto only = [](const std::string& mistake) {
    return run({"--kind", "table3", "--timeout", "20"}, mistake);
  };
  const Outcome silent = only("silent");
  EXPECT_EQ(silent.exit_code, 1) << silent;
  EXPECT_EQ(failing(silent.out), std::set<std::string>{eighth});
  EXPECT_THAT(silent.out, HasSubstr(eighth + ": no answer"));

  const Outcome garbage = only("garbage");
  EXPECT_EQ(garbage.exit_code, 1) << garbage;
  EXPECT_THAT(garbage.out, HasSubstr("answer to number 7"));

  const Outcome crash = only("crash");
  EXPECT_EQ(crash.exit_code, 1) << crash;
  EXPECT_THAT(crash.out, HasSubstr("the command ended with signal 6"));

  const Outcome hang = run({"--kind", "table3", "--timeout", "2"}, "hang");
  EXPECT_EQ(hang.exit_code, 1) << hang;
  EXPECT_THAT(hang.out, HasSubstr("ended after 2 seconds"));
}

TEST(Runner, SkippedCasesAreCounted) {
  const Outcome some = run({"--kind", "table1"}, "skipping");
  EXPECT_EQ(some.exit_code, 0) << some;
  EXPECT_THAT(some.out, HasSubstr("table1: 41 passed, 40 skipped\n"));
}

TEST(Runner, BadUsageIsOneLine) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--kind", "table5"}, "--kind: expected one of"},
      {{"--flag", "nonsense"}, "no case has the flag nonsense"},
      {{"--id", "nonsense"}, "no case is left"},
      {{"--folder", "/nowhere"}, "no vectors there"}};
  for (const auto& [options, message] : cases) {
    const Outcome bad = run(options);
    EXPECT_EQ(bad.exit_code, 2) << bad;
    EXPECT_EQ(lines(bad.err), 1u) << bad;
    EXPECT_THAT(bad.err, HasSubstr(message));
  }
  const Outcome missing = run_program({python, runner, "--", "/nowhere/adapter"});
  EXPECT_EQ(missing.exit_code, 2) << missing;
  EXPECT_THAT(missing.err, HasSubstr("/nowhere/adapter: No such file"));
}

TEST(Runner, ListsCases) {
  const Outcome list = run({"--list", "--kind", "table4", "--flag", "fallback"}, "", false);
  EXPECT_EQ(list.exit_code, 0) << list;
  EXPECT_EQ(lines(list.out), with_flag("table4", "fallback").size()) << list;
}

}  // namespace
}  // namespace tetproof::test
