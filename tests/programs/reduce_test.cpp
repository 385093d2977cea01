// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-mesh --reduce as a user runs it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

TEST(Reduce, TheGridIsThatOfTheReducedSurface) {
  const ScratchFolder folder;
  const auto run = [&](const std::string& surface, const std::string& triangles) {
    return run_program({program("tetproof-mesh"), surface, "--reduce", triangles, "--cells", "12", "-o",
                        folder / "grid.msh", "--json", "-"});
  };
  const Outcome spot = run(TETPROOF_SOURCE_DIR "/corpus/surfaces/spot.obj", "600");
  ASSERT_EQ(spot.exit_code, 0) << spot;
  const json report = json::parse(spot.out);
  EXPECT_EQ(report["verdict"], "sound");
  EXPECT_EQ(report["certificate"], true);
  EXPECT_EQ(report["surface"]["triangles"], 600);
  EXPECT_EQ(report["generation"]["surface"]["triangles"], 600);
  EXPECT_EQ(report["generation"]["surface"]["reduced_from"], 5856);
  EXPECT_THAT(spot.err, HasSubstr("spot.obj: reduced from 5856 to 600 triangles\n"));

  const Outcome torus = run("torus:n=2000", "300");
  ASSERT_EQ(torus.exit_code, 0) << torus;
  EXPECT_THAT(torus.err, HasSubstr("to 300 triangles; its parametric definition is not followed\n"));

  const Outcome shell = run(TETPROOF_SOURCE_DIR "/corpus/surfaces/Cray_left.obj", "100");
  ASSERT_EQ(shell.exit_code, 0) << shell;
  EXPECT_THAT(shell.err,
              HasSubstr("reduced from 576 to 576 triangles; with fewer its topology would change, or "
                        "it would intersect itself\n"));

  const Outcome few = run("torus:n=500", "1000");
  ASSERT_EQ(few.exit_code, 0) << few;
  EXPECT_THAT(few.err, HasSubstr("torus:n=500: not reduced, it has "));
  EXPECT_THAT(few.err, Not(HasSubstr("parametric")));
}

TEST(Reduce, RefusesInOneLine) {
  const ScratchFolder folder;
  for (const char* triangles : {"3", "0", "-5", "many"}) {
    const Outcome run =
        run_program({program("tetproof-mesh"), "sphere", "--reduce", triangles, "-o", folder / "grid.msh"});
    EXPECT_EQ(run.exit_code, 2) << run;
    EXPECT_EQ(lines(run.err), 1u) << run;
    EXPECT_THAT(run.err, HasSubstr("--reduce"));
  }
  // A surface that does not bound a solid is refused for that reason, before it is reduced.
  const Outcome open =
      run_program({program("tetproof-mesh"), TETPROOF_SOURCE_DIR "/corpus/surfaces/sphereWithHole.stl",
                   "--reduce", "100", "-o", folder / "grid.msh"});
  EXPECT_EQ(open.exit_code, 2) << open;
  EXPECT_THAT(open.err, HasSubstr("the surface is open"));
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace tetproof::test
