// SPDX-License-Identifier: GPL-3.0-or-later
// The page and the fast engine write the same trace, to the byte, for every clean surface of corpus/surfaces
// and of ../shared/surfaces.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "corpus/surfaces.hpp"
#include "tests/property/both_engines.hpp"

namespace tetproof::test {
namespace {

const std::filesystem::path shared = std::filesystem::path(TETPROOF_SOURCE_DIR) / "../shared/surfaces";
const std::filesystem::path shipped = std::filesystem::path(TETPROOF_SOURCE_DIR) / "corpus/surfaces";

const std::vector<std::string> clean{
    "1002_tray_bottom.STL", "BONESkull.stl",   "Cray_left.obj", "NACA0012.obj", "ct_skull.off",
    "hull-body.obj",        "plate_holes.STL", "spot.obj",      "torus.STL",    "unit_sphere.STL"};

class EnginesOnSurfaces : public testing::TestWithParam<std::tuple<std::string, reference::Region>> {};

// Many bodies are thinner than six cells, and their inside grid is empty. The outside grid never is.
TEST_P(EnginesOnSurfaces, WriteTheSameTrace) {
  const auto& [name, region] = GetParam();
  const auto file = std::filesystem::exists(shipped / name) ? shipped / name : shared / name;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "neither corpus/surfaces nor ../shared/surfaces has it";
  const BothEngines both =
      run_both(corpus::open_surface(file.string()),
               {.region = region, .cells = {6, 0, 0}, .adapt = reference::AdaptOptions{}});
  EXPECT_EQ(both.fault, "");
  EXPECT_TRUE(both.equal) << both.ties << " ties";
  if (region == reference::Region::outside) {
    EXPECT_FALSE(both.page.made.mesh().tets.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Clean, EnginesOnSurfaces,
                         testing::Combine(testing::ValuesIn(clean),
                                          testing::Values(reference::Region::inside,
                                                          reference::Region::outside)),
                         [](const auto& each) {
                           std::string name = std::get<0>(each.param);
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           const bool inside = std::get<1>(each.param) == reference::Region::inside;
                           return name + (inside ? "_inside" : "_outside");
                         });

TEST(EnginesOnSurfacesList, NamesEveryCleanSurface) {
  if (!std::filesystem::exists(shared)) GTEST_SKIP() << shared << " is not there";
  std::ifstream facts(shared / "manifest.json");
  const nlohmann::json manifest = nlohmann::json::parse(facts);
  std::set<std::string> expected;
  for (const auto& row : manifest["files"])
    if (row["class"] == "clean") expected.insert(row["file"]);
  EXPECT_EQ(std::set<std::string>(clean.begin(), clean.end()), expected);
}

}  // namespace
}  // namespace tetproof::test
