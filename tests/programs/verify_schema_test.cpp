// SPDX-License-Identifier: GPL-3.0-or-later
// verify/reports/report.schema.json, tested with another validator: it accepts what tetproof-verify --json
// writes for all kinds of meshes, and refuses everything that deviates.
#include <gmock/gmock.h>

#include <set>
#include <sstream>

#include "tests/support/verify_files.hpp"

namespace tetproof::test {
namespace {

constexpr const char* python = "/usr/bin/python3";  // the one that Debian's packages belong to
constexpr const char* schema = TETPROOF_SOURCE_DIR "/verify/reports/report.schema.json";
constexpr const char* script = TETPROOF_SOURCE_DIR "/tests/programs/schema.py";

class VerifySchema : public Verify {
 protected:
  VerifySchema() {
    // A small oblique tetrahedron that overlaps the cube. The exact point in both is not a double.
    files.write("overlap.node",
                std::string("12") + (cube_node + 1) +
                    "9 -0.1 -0.1 -0.1\n10 0.2 0.1 -0.07\n11 0.1 0.3 0.01\n12 0.03 0.07 0.31\n");
    files.write("overlap.ele", std::string("7") + (cube_ele + 1) + "7 9 10 11 12\n");
    // One of the cube's six tetrahedra has its own points.
    files.write("cracked.node",
                std::string("12") + (cube_node + 1) + "9 -1 -1 -1\n10 1 -1 -1\n11 1 1 -1\n12 1 1 1\n");
    files.write("cracked.ele", std::string("6 4 0\n1 9 10 11 12\n") + (cube_ele + 16));
    // The diagonal of the cube's bottom is divided at its midpoint, on one side only.
    files.write("hanging.node", std::string("9") + (cube_node + 1) + "9 0 0 -1\n");
    files.write("hanging.ele", std::string("7 4 0\n1 1 2 9 8\n7 9 2 4 8\n") + (cube_ele + 16));
    files.write("nan.node", std::string("9") + (cube_node + 1) + "9 nan inf 1e308\n");
    files.write("nan.ele", std::string("7") + (cube_ele + 1) + "7 1 2 4 9\n");
    files.write("far.node", "4 3\n1 -1e308 0 0\n2 1e308 0 0\n3 0 1e308 0\n4 0 0 1e308\n");
    files.write("far.ele", "1 4\n1 1 2 3 4\n");
    files.write("far.off",
                "OFF\n4 4 0\n1e12 0 0\n1.000000000001e12 0 0\n1e12 1 0\n1e12 0 1\n"
                "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
    // Two regions that share a face.
    files.write("regions.node", "5 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n");
    files.write("regions.ele", "2 4 1\n1 1 2 3 4 7\n2 2 5 3 4 -9\n");
  }
  void SetUp() override {
    if (run_program({python, "-c", "import jsonschema"}).exit_code != 0)
      GTEST_SKIP() << "Python's jsonschema is not installed";
  }
};

TEST_F(VerifySchema, TakesReportsOfAllKinds) {
  const std::vector<std::vector<std::string>> runs{
      {"cube.node"},
      {"cube.node", "--timings"},
      {"cube.node", "--skip", "inverted,overlap"},
      {"cube.node", "--check", "duplicate-point"},
      {"cube.node", "cube.off", "--fidelity", "0", "--voxels", "16"},
      {"cube.node", "cube.off", "--voxels", "0", "--timings"},
      {"cube.node", "sphere:r=1,n=500", "--voxels", "32"},
      {"cube.node", "sphere:r=1,n=500", "--region", "none"},
      {"cube.node", "sphere:r=0.5,n=500", "--region", "outside", "--strict-topology", "--voxels", "32"},
      {"bad.node"},
      {"bad.node", "cube.off", "--voxels", "16"},
      {"bad.node", "--check", "inverted"},
      {"overlap.node"},
      {"cracked.node"},
      {"hanging.node"},
      {"nan.node"},
      {"nan.node", "cube.off", "--voxels", "16"},
      {"far.node"},
      {"far.node", "cube.off", "--voxels", "16"},
      {"regions.node"},
      {"cube.node", "far.off", "--check", "inverted,volume-voxel", "--voxels", "16"},
      {TETPROOF_SOURCE_DIR "/corpus/bad-meshes/copy-in-place.msh"},
      {TETPROOF_SOURCE_DIR "/corpus/bad-meshes/blocks-side-by-side.msh", "--allow",
       "non-conforming-interface"},
  };
  std::vector<std::string> command{python, script, "validate", schema};
  std::set<std::string> verdicts, failed;
  std::set<std::string> of_mesh;
  bool exact_point = false, regions = false;
  for (const auto& arguments : runs) {
    const std::string name = files / (std::to_string(command.size()) + ".json");
    std::vector<std::string> words = arguments;
    words.insert(words.end(), {"--json", name});
    const Outcome outcome = run(words);
    ASSERT_THAT(outcome.exit_code, testing::AnyOf(0, 1, 4)) << outcome;
    command.push_back(name);
    const json report = json::parse(files.read(std::filesystem::path(name).filename()));
    for (const json& check : report["checks"]) {
      verdicts.insert(check["verdict"]);
      if (check["verdict"] == "fail") failed.insert(check["id"]);
      for (const json& finding : check["findings"]) exact_point |= !finding["point_exact"].is_null();
    }
    regions |= !report["regions"].empty();
    of_mesh.insert(report["verdict"]);
  }
  const Outcome validated = run_program(command);
  EXPECT_EQ(validated.exit_code, 0) << validated;
  EXPECT_EQ(validated.out, "");
  // The reports that were validated are of many kinds.
  EXPECT_THAT(verdicts, testing::IsSupersetOf({"pass", "warning", "fail", "skipped"}));
  EXPECT_THAT(failed, testing::IsSupersetOf({"index-range", "finite-coordinates", "inverted", "duplicate-tet",
                                             "overlap", "crack", "hanging-node", "volume-surface"}));
  EXPECT_TRUE(exact_point && regions);
  EXPECT_EQ(of_mesh, (std::set<std::string>{"defective", "incomplete", "sound"}));
}

TEST_F(VerifySchema, RefusesWhatDeviates) {
  run({"overlap.node", "sphere:r=1,n=500", "--voxels", "16", "--timings", "--json", files / "rich.json"});
  run({"regions.node", "--json", files / "regions.json"});
  run({"cube.node", "far.off", "--check", "inverted,volume-voxel", "--voxels", "16", "--json",
       files / "far.json"});
  for (const char* report : {"rich.json", "regions.json", "far.json"}) {
    ASSERT_TRUE(files.has(report));
    const Outcome mutilated = run_program({python, script, "mutilate", schema, files / report});
    ASSERT_EQ(mutilated.exit_code, 0) << mutilated;
    // The names of phases are not fixed by the schema, and some keys are not in every report.
    std::istringstream rest(mutilated.out);
    std::string line, last;
    for (; std::getline(rest, line); last = line) {
      if (line.find(':') == line.npos) continue;
      EXPECT_THAT(line, testing::MatchesRegex("(seconds.*|fidelity|volume/missing|volume/excess): .*"));
    }
    EXPECT_GT(std::stoi(last), 200) << mutilated;  // the number of mutants
  }
}

TEST_F(VerifySchema, KnowsEveryCheck) {
  const json ids = json::parse(std::ifstream(schema))["$defs"]["id"]["enum"];
  const json whole = report({"cube.node"}, 0);
  EXPECT_EQ(ids.size(), whole["checks"].size());
  EXPECT_EQ(json::parse(std::ifstream(schema))["$defs"]["checks"]["minItems"], ids.size());
  for (const json& check : whole["checks"])
    EXPECT_NE(std::find(ids.begin(), ids.end(), check["id"]), ids.end()) << check["id"];
}

}  // namespace
}  // namespace tetproof::test
