// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-mesh --save-surface, and tetproof-convert with a generated surface as IN.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using Words = std::vector<std::string>;

const std::string surfaces = TETPROOF_SOURCE_DIR "/corpus/surfaces/";

Outcome mesh(Words arguments) {
  arguments.insert(arguments.begin(), program("tetproof-mesh"));
  return run_program(arguments);
}

Outcome convert(Words arguments) {
  arguments.insert(arguments.begin(), program("tetproof-convert"));
  return run_program(arguments);
}

std::size_t count(const std::string& text, const std::string& line_start) {
  std::size_t found = text.starts_with(line_start);
  for (std::size_t at = 0; (at = text.find("\n" + line_start, at)) != text.npos; ++at) ++found;
  return found;
}

TEST(SaveSurface, AGeneratedOneWithItsParameters) {
  const ScratchFolder folder;
  const Outcome run = mesh({"torus:R=1,r=0.4,n=200", "--cells", "8", "--points", "0", "--voxels", "0",
                            "--save-surface", folder / "torus.obj"});
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_EQ(run.err, "");
  const std::string text = folder.read("torus.obj");
  EXPECT_EQ(count(text, "v "), 102u);
  EXPECT_EQ(count(text, "vt "), 126u);  // two seams: 18 x 7 instead of 17 x 6
  EXPECT_EQ(count(text, "f "), 204u);
  EXPECT_THAT(text, HasSubstr("f 1/1 7/2 8/3\n"));
}

TEST(SaveSurface, ReadsBackEqual) {
  const ScratchFolder folder;
  for (const char* name : {"random:seed=3,n=72", "wing:n=60", "shells:n=100", "terrain:seed=2"}) {
    ASSERT_EQ(mesh({name, "--cells", "3", "--points", "0", "--voxels", "0", "--save-surface",
                    folder / "one.obj", "--quiet", "--parametric", "off", "--trace", folder / "one.jsonl"})
                  .exit_code,
              0);
    ASSERT_EQ(mesh({folder / "one.obj", "--cells", "3", "--points", "0", "--voxels", "0", "--save-surface",
                    folder / "two.off", "--quiet", "--trace", folder / "two.jsonl"})
                  .exit_code,
              0);
    ASSERT_EQ(convert({name, folder / "three.off", "--quiet"}).exit_code, 0);
    EXPECT_EQ(folder.read("two.off"), folder.read("three.off")) << name;
    const std::string one = folder.read("one.jsonl"), two = folder.read("two.jsonl");
    EXPECT_EQ(one.substr(one.find('\n')), two.substr(two.find('\n'))) << name;
  }
}

TEST(SaveSurface, SaysThatParametersAreLost) {
  const ScratchFolder folder;
  const Outcome run = mesh({"sphere:n=32", "--cells", "3", "--points", "0", "--voxels", "0", "--save-surface",
                            folder / "sphere.off"});
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_THAT(run.err, HasSubstr("lost: "));
  EXPECT_THAT(run.err, HasSubstr("texture"));
}

TEST(SaveSurface, TheReducedOne) {
  const ScratchFolder folder;
  const Outcome run = mesh({surfaces + "spot.obj", "--reduce", "400", "--cells", "8", "--points", "0",
                            "--voxels", "0", "--save-surface", folder / "spot.off"});
  ASSERT_EQ(run.exit_code, 0) << run;
  const std::string text = folder.read("spot.off");
  EXPECT_THAT(text, StartsWith("OFF\n"));
  EXPECT_EQ(count(text, "3 "), 400u);
}

TEST(SaveSurface, IsNoInputAndNoOtherOutput) {
  const ScratchFolder folder;
  ASSERT_EQ(convert({"sphere:n=32", folder / "s.off", "--quiet"}).exit_code, 0);
  const std::string before = folder.read("s.off");
  const Outcome input = mesh({folder / "s.off", "--save-surface", folder / "s.off"});
  EXPECT_EQ(input.exit_code, 2) << input;
  EXPECT_EQ(lines(input.err), 1u) << input;
  EXPECT_EQ(folder.read("s.off"), before);
  const Outcome output = mesh({"sphere:n=32", "-o", folder / "g.msh", "--save-surface", folder / "g.msh"});
  EXPECT_EQ(output.exit_code, 2) << output;
  const Outcome ending = mesh({"sphere:n=32", "--save-surface", folder / "s.xyz"});
  EXPECT_EQ(ending.exit_code, 2) << ending;
}

TEST(ConvertGenerated, ToEveryFormatOfSurfaces) {
  const ScratchFolder folder;
  for (const char* ending : {"off", "obj", "ply", "stl", "msh", "vtu", "smesh"}) {
    const std::string file = folder / (std::string("s.") + ending);
    ASSERT_EQ(convert({"sphere:r=1,n=32", file, "--quiet"}).exit_code, 0) << ending;
    const Outcome info = convert({"--info", file});
    EXPECT_EQ(info.exit_code, 0) << info;
    EXPECT_THAT(info.out, HasSubstr("32 ")) << ending;
  }
}

TEST(ConvertGenerated, SaysWhatItIs) {
  const ScratchFolder folder;
  const Outcome info = convert({"--info", "sphere:r=1,n=32"});
  EXPECT_EQ(info.exit_code, 0) << info;
  EXPECT_THAT(info.out, StartsWith("sphere:r=1,n=32: generated\n"));
  const Outcome strict = convert({"sphere:r=1,n=32", folder / "s.off", "--strict"});
  EXPECT_EQ(strict.exit_code, 1) << strict;
  EXPECT_FALSE(std::filesystem::exists(folder / "s.off"));
  EXPECT_EQ(convert({"sphere:r=1,n=32", folder / "s.obj", "--strict"}).exit_code, 0);
}

TEST(ConvertGenerated, BadSpecificationsAreBadInput) {
  const ScratchFolder folder;
  const Outcome key = convert({"sphere:q=1", folder / "s.off"});
  EXPECT_EQ(key.exit_code, 2) << key;
  EXPECT_THAT(key.err, HasSubstr("unknown key 'q'"));
  const Outcome from = convert({"sphere:r=1", folder / "s.off", "--from", "off"});
  EXPECT_EQ(from.exit_code, 2) << from;
  EXPECT_THAT(from.err, HasSubstr("--from needs an IN that is a file"));
}

}  // namespace
}  // namespace tetproof::test
