// SPDX-License-Identifier: GPL-3.0-or-later
// Reads TetGen's .poly and .smesh: a few lines for each rule, by hand, after the manual's sections 5.2.2 and
// 5.2.3.
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "tests/support/tetgen_text.hpp"

namespace tetproof {
namespace {

using Files = std::vector<std::pair<std::string, std::string>>;

const std::string nodes = "5 3\n1 0 0 0\n2 2 0 0\n3 2 2 0\n4 0 2 0\n5 1 1 1\n";
const std::string n = "n 1 0 0 0\nn 2 2 0 0\nn 3 2 2 0\nn 4 0 2 0\nn 5 1 1 1\n";

struct Case {
  std::string name, file;
  Files files;
  std::string expected;
  std::vector<std::string> warnings{};

  friend void PrintTo(const Case& test, std::ostream* out) { *out << test.name; }
};

const std::vector<Case> cases{
    {"FacetsHolesRegions",
     "a.poly",
     {{"a.poly",
       "# by hand\n" + nodes +
           "3 1\n1 0 -4 # a square\n4 1 2 3 4\n3 1 9\n4 1 2 3 4\n2 1 3\n1 5\n1 1.5 0.5 0\n1\n3 1 2 5\n"
           "1\n1 0.5 0.5 0.5\n2\n1 .1 .1 .1 2.25 1e-3\n2 .2 .2 .2 -7\n"}},
     n + "b 3 4 1 boundary\ne 1: 1 2 3 4\nb 3 4 1 boundary group 9\ne 2: 1 2 3 4\nb 1 2 1 boundary group "
         "9\ne 3: 1 3\nb 15 1 1 boundary group 9\ne 4: "
         "5\n"
         "b 2 3 1 boundary\ne 5: 1 2 5\nv element markers 1 at 0: -4\nfacet 1 3\n  hole 1.5 0.5 0\n"
         "hole 0.5 0.5 0.5\nregion 0.1 0.1 0.1 2.25 0.001\nregion 0.2 0.2 0.2 -7 -7\n"},
    {"PolygonsOverLines",
     "a.poly",
     {{"a.poly", nodes + "1\n1\n5 1 2 # and\n\n3 4\n5\n0\n"}},
     n + "b 34 5 1 boundary\ne 1: 1 2 3 4 5\n"},
    {"PointsBesideIt",
     "a.poly",
     {{"a.poly", "0 3\n1\n1\n3 0 1 2\n0\n"}, {"a.node", "3 3 0 1\n0 0 0 0 5\n1 1 0 0\n2 0 1 0\n"}},
     "n 0 0 0 0\nn 1 1 0 0\nn 2 0 1 0\nb 2 3 1 boundary\ne 0: 0 1 2\nv node markers 1 from 0: 5 0 0\n"},
    {"Smesh",
     "a.smesh",
     {{"a.smesh", nodes + "3 1\n4 1 2 3 4 7\n3 1 2\n9 -8\n3 2 3 5\n0\n0\n"}},
     n + "b 3 4 1 boundary group 7\ne 1: 1 2 3 4\nb 2 3 2 boundary\ne 2: 1 2 ?9\ne 3: 2 3 5\n"
         "v element markers 1 at 1: -8\n"},
    {"EdgesSizesAndBoundsButNoMesh",
     "a.smesh",
     {{"a.smesh", nodes + "1\n3 1 2 5\n0\n"},
      {"a.edge", "1 1\n1 3 4 2\n"},
      {"a.mtr", "5 1\n1\n2\n3\n4\n5\n"},
      {"a.var", "1\n1 7 0.5\n"},
      {"a.ele", "this is read with a.node only"},
      {"a.node", "and this not at all"}},
     n + "b 2 3 1 boundary\ne 1: 1 2 5\nb 1 2 1 group 2\ne 2: 3 4\nv node sizes 1 from 0: 1 2 3 4 5\n"
         "area 7 0.5\n"},
    {"Warnings",
     "a.smesh",
     {{"a.smesh", nodes + "1\n3 1 2 5 7\n"}, {"a.poly", "TetGen prefers this"}},
     n + "b 2 3 1 boundary\ne 1: 1 2 5\n",
     {"a.smesh: there is a.poly too, which TetGen would read instead",
      "a.smesh: there is no number of holes"}},
};

class TetgenPlc : public testing::TestWithParam<Case> {};

TEST_P(TetgenPlc, SaysWhatTheFilesSay) {
  const test::TestFiles files;
  for (const auto& [name, bytes] : GetParam().files) files.write(name, bytes);
  const Document document = read_document(files.path(GetParam().file));
  EXPECT_EQ(test::tetgen_text(document), GetParam().expected);
  EXPECT_EQ(test::warnings_of(document, files), GetParam().warnings);
}

INSTANTIATE_TEST_SUITE_P(ByHand, TetgenPlc, testing::ValuesIn(cases),
                         [](const auto& test) { return test.param.name; });

TEST(TetgenPlc, ErrorsHaveOneLineWithThePlace) {
  const test::TestFiles files;
  const auto message = [&](const std::string& ending, const std::string& rest) {
    files.write("a" + ending, nodes + rest);
    return files.message([&] { read_document(files.path("a" + ending)); });
  };
  EXPECT_EQ(message(".poly", ""), "a.poly:7: expected the number of facets, found the end of the file");
  EXPECT_EQ(message(".poly", "2\n1\n3 1 2 3\n"),
            "a.poly:10: expected 2 facets, found 1 and the end of the file");
  EXPECT_EQ(message(".poly", "1\n0\n0\n"), "a.poly:8: expected at least one polygon in a facet, found 0");
  EXPECT_EQ(message(".poly", "1\n1\n0\n0\n"), "a.poly:9: expected at least one corner of a polygon, found 0");
  EXPECT_EQ(message(".poly", "1\n1\n4 1 2 3\n"),
            "a.poly:10: expected a corner of the polygon, found the end of the file");
  EXPECT_EQ(message(".poly", "1\n2\n3 1 2 3\n"), "a.poly:10: expected a polygon, found the end of the file");
  EXPECT_EQ(message(".poly", "1\n1 1\n3 1 2 3\n1 0 0\n0\n"),
            "a.poly:10: expected a coordinate, found the end of the line");
  EXPECT_EQ(message(".poly", "1\n1\n1000000 1 2 3\n0\n"),
            "a.poly:9: expected the number of a polygon's corners, found 1000000, more than the 9 bytes left "
            "can hold");
  EXPECT_EQ(message(".smesh", "1\n3 1 2 x\n"), "a.smesh:8: expected the number of a node, found 'x'");
  EXPECT_EQ(message(".smesh", "0\n1\n1 0 0\n"),
            "a.smesh:9: expected a coordinate, found the end of the line");
  EXPECT_EQ(message(".smesh", "0\n0\n1\n1 0 0 0\n"),
            "a.smesh:10: expected the attribute of a region, found the end of the line");
  files.write("b.poly", "0 3\n0\n0\n");
  EXPECT_EQ(files.message([&] { read_document(files.path("b.poly")); }),
            "b.node: cannot open: No such file or directory");
}

TEST(TetgenPlc, IsASurface) {
  const test::TestFiles files;
  const std::string walls = "3 1 2 5\n3 2 3 5\n3 3 4 5\n3 4 1 5\n0\n";
  const TriangleSurface surface = read_surface(files.write("a.smesh", nodes + "5\n4 4 3 2 1\n" + walls));
  EXPECT_EQ(surface.vertices.size(), 5u);
  EXPECT_EQ(surface.triangles, (std::vector<std::array<Index, 3>>{
                                   {3, 2, 1}, {3, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}));
  const auto refused = [&](const std::string& facets) {
    files.write("a.poly", nodes + facets);
    return files.message([&] { read_surface(files.path("a.poly")); });
  };
  EXPECT_EQ(refused("2\n1\n3 1 2 3\n2\n4 1 2 3 4\n2 1 9\n0\n"),
            "a.poly:11: face of a facet of 2 polygons and 0 holes names node 9, which does not exist");
  EXPECT_EQ(refused("1\n2\n4 1 2 3 4\n4 1 3 2 4\n0\n"),
            "a.poly:9: face of a facet of 2 polygons and 0 holes crosses itself");
  EXPECT_EQ(refused("1\n1\n3 1 2 8\n0\n"), "a.poly:9: face names vertex 8, expected 1 to 5");
  EXPECT_EQ(refused("1\n1\n2 1 2\n0\n"), "a.poly:9: face has 2 corners, expected at least 3");
}

}  // namespace
}  // namespace tetproof
