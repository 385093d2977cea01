// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-mesh --figure as users run it, and the pictures in the repository.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

Outcome mesh(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{
      program("tetproof-mesh"), "sphere:r=1,n=200", "--cells", "7", "--points", "50"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program(words);
}

TEST(FigureOption, WritesAPictureWithOrWithoutAGrid) {
  const ScratchFolder files;
  const Outcome with = mesh({"-o", files / "grid.msh", "--figure", files / "a.svg", "--plane", "x=0.1"});
  EXPECT_EQ(with.exit_code, 0) << with;
  const Outcome without = mesh({"--figure", files / "b.svg", "--plane", "x=0.1", "--threads", "1"});
  EXPECT_EQ(without.exit_code, 0) << without;
  EXPECT_EQ(files.read("a.svg"), files.read("b.svg"));
  EXPECT_THAT(files.read("a.svg"), StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_THAT(files.read("a.svg"), HasSubstr("<title>Unstructured grid inside sphere:r=1,n=200</title>"));
  EXPECT_THAT(files.read("a.svg"), HasSubstr(">x = 0.1: "));
  EXPECT_EQ(files.names(), (std::vector<std::string>{"a.svg", "b.svg", "grid.msh"}));
  // Without --plane, the plane passes through the middle of the surface.
  EXPECT_EQ(mesh({"--figure", files / "c.svg", "--colour", "quality"}).exit_code, 0);
  EXPECT_THAT(files.read("c.svg"), HasSubstr(">x = 0: "));
  EXPECT_THAT(files.read("c.svg"), HasSubstr("smallest solid angle"));
}

TEST(FigureOption, ViewDrawsTheGridCutOpen) {
  const ScratchFolder files;
  const Outcome drawn = mesh({"--figure", files / "a.svg", "--view", "3d", "--title", "A <ball> & \"more\""});
  EXPECT_EQ(drawn.exit_code, 0) << drawn;
  EXPECT_THAT(files.read("a.svg"), HasSubstr("<title>A &lt;ball&gt; &amp; \"more\"</title>"));
  EXPECT_THAT(files.read("a.svg"), HasSubstr(">Cut open at x = 0: "));  // the axis nearest to the view
  EXPECT_THAT(files.read("a.svg"), HasSubstr("seen from (1, -0.5, 0.45)"));
  EXPECT_EQ(mesh({"--figure", files / "b.svg", "--view", "0,-2,1", "--threads", "1"}).exit_code, 0);
  EXPECT_THAT(files.read("b.svg"), HasSubstr(">Cut open at y = 0: "));
  EXPECT_EQ(mesh({"--figure", files / "c.svg", "--view", "0,-2,1", "--plane", "z=0.2"}).exit_code, 0);
  EXPECT_THAT(files.read("c.svg"), HasSubstr(">Cut open at z = 0.2: "));
}

TEST(FigureOption, ANameThatIsNoXmlIsEscaped) {
  const ScratchFolder files;
  const std::string odd = files / "a&b<c>.obj";
  EXPECT_EQ(mesh({"--save-surface", odd}).exit_code, 0);
  const Outcome drawn = run_program({program("tetproof-mesh"), odd, "--cells", "5", "--points", "0",
                                     "--figure", files / "a.svg", "--view", "1,0,0"});
  EXPECT_EQ(drawn.exit_code, 0) << drawn;
  EXPECT_THAT(files.read("a.svg"), HasSubstr("<title>Unstructured grid inside a&amp;b&lt;c&gt;.obj</title>"));
}

TEST(FigureOption, NothingIsWrittenAfterAMistake) {
  const ScratchFolder files;
  const auto refused = [&](const std::string& what, const std::vector<std::string>& more) {
    std::vector<std::string> words{"-o", files / "grid.msh"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = mesh(words);
    EXPECT_EQ(outcome.exit_code, 2) << outcome;
    EXPECT_EQ(lines(outcome.err), 1u) << outcome;
    EXPECT_THAT(outcome.err, HasSubstr(what));
    EXPECT_TRUE(files.names().empty());
  };
  const std::string picture = files / "a.svg";
  refused("the plane x = 5 misses the grid", {"--figure", picture, "--plane", "x=5"});
  refused("--plane: expected an axis and a place", {"--figure", picture, "--plane", "w=5"});
  refused("--colour", {"--figure", picture, "--colour", "depth"});
  for (const char* view : {"0,0,0", "nan,1,0", "1,2", "front", "1,2,x", ""})
    refused("--view", {"--figure", picture, "--view", view});
  refused("there is no whole tetrahedron", {"--figure", picture, "--view", "3d", "--plane", "x=-5"});
  for (const char* option : {"--view", "--title", "--plane"}) refused("--figure", {option, "x"});
  refused("--figure", {"--colour", "quality"});
  refused("missing/a.svg", {"--figure", files / "missing/a.svg"});
}

// The options of each picture of the gallery, from corpus/gallery.sh.
std::map<std::string, std::vector<std::string>> gallery() {
  std::map<std::string, std::vector<std::string>> pictures;
  std::ifstream script(TETPROOF_SOURCE_DIR "/corpus/gallery.sh");
  for (std::string line; std::getline(script, line);) {
    if (!line.starts_with("figure ")) continue;
    std::istringstream rest(line.substr(7));
    std::string name;
    rest >> name;
    for (std::string word; rest >> std::quoted(word);) pictures[name].push_back(word);
  }
  return pictures;
}

const std::array<const char*, 8> picture_names{"sphere", "sphere-open", "torus", "torus-open",
                                               "wing",   "wing-open",   "skull", "skull-open"};

class GalleryPicture : public ::testing::TestWithParam<const char*> {};

// corpus/gallery.sh makes each picture again, byte by byte.
TEST_P(GalleryPicture, HasNotDrifted) {
  const ScratchFolder files;
  const std::string picture = std::string(GetParam()) + ".svg";
  std::vector<std::string> words = gallery()[GetParam()];
  words.insert(words.begin(), program("tetproof-mesh"));
  words.insert(words.end(), {"--region", "outside", "--improve", "aspect-ratio", "--voxels", "0", "--figure",
                             files / picture});
  const Outcome outcome = run_program(words, {.directory = TETPROOF_SOURCE_DIR, .timeout_s = 600});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  std::ifstream shown(TETPROOF_SOURCE_DIR "/corpus/gallery/" + picture, std::ios::binary);
  const std::string expected{std::istreambuf_iterator<char>(shown), {}};
  EXPECT_TRUE(files.read(picture) == expected) << "corpus/gallery.sh makes the pictures again";
}

INSTANTIATE_TEST_SUITE_P(Script, GalleryPicture, ::testing::ValuesIn(picture_names), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Gallery, HasThePicturesOfTheScript) {
  std::set<std::string> made, shown;
  for (const auto& [name, words] : gallery()) made.insert(name);
  for (const auto& entry : std::filesystem::directory_iterator(TETPROOF_SOURCE_DIR "/corpus/gallery"))
    if (entry.path().extension() == ".svg") shown.insert(entry.path().stem());
  EXPECT_EQ(made, shown);
  EXPECT_EQ(made, std::set<std::string>(picture_names.begin(), picture_names.end()));
}

// Another parser reads every picture as XML, and its size fits a page.
TEST(Gallery, IsXml) {
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(TETPROOF_SOURCE_DIR "/corpus/gallery")) {
    if (entry.path().extension() != ".svg") continue;
    EXPECT_LT(std::filesystem::file_size(entry), 600000u) << entry;
    const Outcome parsed =
        run_program({"python3", "-c",
                     "import sys, xml.etree.ElementTree as tree\n"
                     "root = tree.parse(sys.argv[1]).getroot()\n"
                     "print(root.tag, len(root.findall('.//{http://www.w3.org/2000/svg}path')) > 5)",
                     entry.path().string()});
    EXPECT_EQ(parsed.out, "{http://www.w3.org/2000/svg}svg True\n") << parsed;
    ++pictures;
  }
  EXPECT_EQ(pictures, 8);
}

}  // namespace
}  // namespace tetproof::test
