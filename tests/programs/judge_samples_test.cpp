// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-verify on the files that an early version judged wrongly: ../shared/cases/judge, which only the
// customer's machines have. The unit tests have meshes of the same kinds.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using nlohmann::json;

struct Sample {
  std::vector<std::string> arguments;  // file names of that folder, and options
  int exit_code;
  std::string first_line;          // a part of it
  std::vector<std::string> roots;  // the ids of all failed checks that are no mere consequences
};

const std::vector<Sample> samples{
    {{"underflow_overlap.ele"}, 1, "DEFECTIVE", {"boundary-self-intersection"}},
    {{"mixed_609.ele"}, 0, "sound: certified: 3 tetrahedra", {}},
    {{"mixed.msh"}, 4, "incomplete: certified: 6 tetrahedra; not judged: 1 hexahedron", {}},
    {{"mixed.msh", "mixed.off"}, 4, "incomplete: certified: 6 tetrahedra; not judged: 1 hexahedron", {}},
    {{"mixed.msh", "--only-tets"}, 0, "sound: certified: 6 tetrahedra", {}},
    {{"mixed2.msh"}, 4, "incomplete: certified: 7 tetrahedra; not judged: 1 hexahedron", {}},
    {{"touching_blocks.msh"}, 1, "(non-conforming-interface)", {"non-conforming-interface"}},
    {{"touching_blocks.msh", "--allow", "non-conforming-interface"},
     0,
     "except for what is allowed (1 non-conforming-interface)",
     {}},
    {{"tw.msh"}, 1, "(duplicate-tet)", {"duplicate-tet"}},
    {{"regs.msh"}, 0, "sound: certified: 12 tetrahedra", {}},
    {{"slow/chazelle-far3.1.ele", "slow/chazelle-far3.off", "--fidelity", "1e-9"},
     0,
     "fills the surface",
     {}},
    {{"slow/coplanar-f32.1.ele", "slow/coplanar-f32.off", "--fidelity", "1e-6"}, 0, "fills the surface", {}},
    {{"slow/thinvoxel-far6.1.ele", "slow/thinvoxel-far6.off", "--fidelity", "1e-9"},
     0,
     "fills the surface",
     {}},
};

TEST(JudgeSamples, AreJudgedRight) {
  const std::string folder = TETPROOF_SOURCE_DIR "/../shared/cases/judge/";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the samples of ../shared/cases/judge are not here";
  for (const Sample& sample : samples) {
    std::vector<std::string> command{program("tetproof-verify")};
    for (const std::string& word : sample.arguments)
      command.push_back(std::filesystem::exists(folder + word) ? folder + word : word);
    const Outcome text = run_program(command);
    SCOPED_TRACE(text);
    EXPECT_EQ(text.exit_code, sample.exit_code);
    EXPECT_THAT(text.out.substr(0, text.out.find('\n')), testing::HasSubstr(sample.first_line));
    command.insert(command.end(), {"--json", "-"});
    const json report = json::parse(run_program(command).out);
    std::vector<std::string> roots;
    for (const json& check : report["checks"])
      if (check["verdict"] == "fail" && check["count"] > 0) roots.push_back(check["id"]);
    EXPECT_EQ(roots, sample.roots);
    if (sample.arguments[0] == "regs.msh") {
      ASSERT_EQ(report["regions"].size(), 2u);
      std::vector<std::string> kinds{report["regions"][0]["kind"], report["regions"][1]["kind"]};
      EXPECT_THAT(kinds, testing::UnorderedElementsAre("physical", "entity"));
    }
  }
}

}  // namespace
}  // namespace tetproof::test
