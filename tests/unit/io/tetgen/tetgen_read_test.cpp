// SPDX-License-Identifier: GPL-3.0-or-later
// Reads TetGen's files of a mesh: a few lines for each rule, by hand, after the manual's section 5.
#include <map>

#include "io/mesh_files.hpp"
#include "tests/support/tetgen_text.hpp"

namespace tetproof {
namespace {

using Files = std::vector<std::pair<std::string, std::string>>;

const std::string nodes1 = "4 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n",
                  nodes0 = "4 3\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n";
const std::string n1 = "n 1 0 0 0\nn 2 1 0 0\nn 3 0 1 0\nn 4 0 0 1\n",
                  n0 = "n 0 0 0 0\nn 1 1 0 0\nn 2 0 1 0\nn 3 0 0 1\n";
const std::string ele1 = "1 4\n1 1 2 3 4\n", tet1 = "b 4 4 1\ne 1: 1 2 3 4\n";
// A second-order tetrahedron whose nodes have Gmsh's numbers.
const std::string nodes10 =
    "10 3\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n4 .5 0 0\n5 .5 .5 0\n6 0 .5 0\n7 0 0 .5\n8 0 .5 .5\n9 .5 0 "
    ".5\n";
const std::string n10 =
    "n 0 0 0 0\nn 1 1 0 0\nn 2 0 1 0\nn 3 0 0 1\nn 4 0.5 0 0\nn 5 0.5 0.5 0\nn 6 0 0.5 0\nn 7 0 0 0.5\nn 8 0 "
    "0.5 0.5\n"
    "n 9 0.5 0 0.5\n";
const std::string ele10 = "1 10\n0 0 1 2 3 8 7 4 5 9 6\n", tet10 = "b 11 10 1\ne 0: 0 1 2 3 4 5 6 7 8 9\n";

struct Case {
  std::string name, file;
  Files files;
  std::string expected;
  std::vector<std::string> warnings{};

  friend void PrintTo(const Case& test, std::ostream* out) { *out << test.name; }
};

const std::vector<Case> cases{
    {"TheWholeSetFromAnyOfItsFiles",
     "a.1.vol",
     {{"a.1.node", nodes0},
      {"a.1.ele", "1 4\n0 0 1 2 3\n"},
      {"a.1.face", "2 1\n0 0 1 2 -7\n1 0 1 3\n"},
      {"a.1.edge", "1 1\n0 3 0 5 # of a crease\n"},
      {"a.1.neigh", "1 4\n0 -1 -1 7 -1\n"},
      {"a.1.t2f", "0 0 1 2 3\n"},
      {"a.1.t2e", "0 5 4 3 2 1 0\n"},
      {"a.1.f2e", "0 1 2 3\n1 4 5 6\n"},
      {"a.1.vol", "1\n0 0.125\n"},
      {"a.1.mtr", "4 1\n0.5\n1e-3\n2\n3 \n"},
      {"a.1.var", "1\n0 -7 0.25\n1\n0 3 0 1e-2\n"}},
     n0 + "b 4 4 1\ne 0: 0 1 2 3\nb 2 3 2\ne 1: 0 1 2\ne 2: 0 1 3\nb 1 2 1 group 5\ne 3: 3 0\nv node sizes 1 "
          "from 0: "
          "0.5 0.001 2 3\n"
          "v element markers 1 from 1: -7 0\nv element neighbours 4 from 0: "
          "-1 -1 7 -1\n"
          "v element faces 4 from 0: 0 1 2 3\nv element edges 6 from 0: 5 4 3 2 1 0\nv element edges 3 from "
          "1: 1 2 3 4 5 6\n"
          "v element volume bounds 1 from 0: 0.125\narea -7 0.25\nlength 3 0 0.01\n"},
    {"TetrahedraAtFacesAndEdges",  // -nn
     "a.face",
     {{"a.node", nodes1}, {"a.ele", ele1}, {"a.face", "1 1\n1 1 2 3 9 1 -1\n"}, {"a.edge", "1 0\n1 1 2 1\n"}},
     n1 + tet1 +
         "b 2 3 1 group 9\ne 2: 1 2 3\nb 1 2 1\ne 3: 1 2\nv element neighbours 2 from "
         "1: 1 -1\n"
         "v element neighbours 1 from 2: 1\n"},
    {"FacesWithoutTetrahedra",
     "a.face",
     {{"a.node", nodes1}, {"a.face", "1\n1 1 2 8\n"}},
     n1 + "b 2 3 1\ne 1: 1 2 ?8\n"},
    {"SecondOrder",
     "a.ele",
     {{"a.node", nodes10},
      {"a.ele", ele10},
      {"a.face", "1 1\n0 0 1 2 4 5 6 -3\n"},
      {"a.edge", "2 1\n0 0 1 4 7\n1 2 3 8 7\n"}},
     n10 + tet10 +
         "b 9 6 1\ne 1: 0 1 2 4 5 6\nb 8 3 2 group 7\ne 2: 0 1 4\ne 3: 2 3 8\nv element markers 1 from 1: "
         "-3\n"},
    {"SecondOrderFacesAsWithF",  // with -f each node is opposite to its corner
     "a.ele",
     {{"a.node", nodes10},
      {"a.ele", ele10},
      {"a.face", "2 1\n0 0 1 2 5 6 4 0 0 -1\n1 3 1 0 4 7 9 2 -1 0\n"},
      {"a.edge", "1 1\n0 0 1 4 7 0\n"}},
     n10 + tet10 +
         "b 9 6 1\ne 1: 0 1 2 4 5 6\nb 9 6 1 group 2\ne 2: 3 1 0 9 4 7\nb 8 3 1 group 7\ne 3: 0 1 4\n"
         "v element neighbours 2 from 1: 0 -1 -1 0\nv element neighbours 1 "
         "from 3: 0\n"},
    {"SecondOrderFacesAloneAsWithF",
     "a.face",
     {{"a.node", nodes10}, {"a.face", "1\n0 0 1 2 5 6 4\n"}, {"a.edge", "1\n0 0 1 4\n"}},
     n10 + "b 9 6 1\ne 0: 0 1 2 4 5 6\nb 8 3 1\ne 1: 0 1 4\n"},
    {"FirstOrderBesideSecondOrder",
     "a.ele",
     {{"a.node", nodes10}, {"a.ele", ele10}, {"a.face", "1 1\n0 0 1 2 -3\n"}, {"a.edge", "1 1\n0 0 1 7\n"}},
     n10 + tet10 + "b 2 3 1\ne 1: 0 1 2\nb 1 2 1 group 7\ne 2: 0 1\nv element markers 1 from 1: -3\n"},
    {"SecondOrderOfTheOppositeOrientation",  // corners 0 and 1 are exchanged, the nodes between corners are
                                             // not
     "a.ele",
     {{"a.node", nodes10}, {"a.ele", "1 10\n0 1 0 2 3 8 7 4 5 9 6\n"}},
     n10 + "b 11 10 1\ne 0: 1 0 2 3 4 6 5 9 8 7\n"},
    {"NumbersOfFacesComeAfterThoseOfTetrahedra",
     "a.ele",
     {{"a.node", nodes1}, {"a.ele", "2 4\n7 1 2 3 4\n3 1 2 4 3\n"}, {"a.face", "2\n1 1 2 3\n5 1 2 4\n"}},
     n1 + "b 4 4 2\ne 7: 1 2 3 4\ne 3: 1 2 4 3\nb 2 3 2\ne 8: 1 2 3\ne 9: 1 2 4\n",
     {"a.ele:2: tetrahedron 7 stands where tetrahedron 1 is due; TetGen goes by the order of the lines (the "
      "first such)",
      "a.face:3: face 5 stands where face 2 is due; TetGen goes by the order of the lines (the first such)"}},
    {"BoundsThatAreNotThere",
     "a.ele",
     {{"a.node", nodes1},
      {"a.ele", ele1},
      {"a.vol", "1\n1\n"},
      {"a.var", "0\n"},
      {"a.mtr", "4\n1\n2\n3\n4\n"}},
     n1 + tet1 + "v node sizes 1 from 0: 1 2 3 4\nv element volume bounds 1 from 0: -1\n"},
    {"Tensors",
     "a.mtr",
     {{"a.node", "1 3\n1 0 0 0\n"}, {"a.mtr", "1 6\n1 2 3 4 5 6\n"}},
     "n 1 0 0 0\nv node sizes 6 from 0: 1 2 3 4 5 6\n",
     {"a.node: there is no a.ele beside it: nodes only"}},
    {"MoreThanIsAnnounced",
     "a.ele",
     {{"a.node", nodes1 + "5 0 0 0\n# no record\n"},
      {"a.ele", "1 4\n1 1 2 3 4 8 # one column\n"},
      {"a.t2f", "1 1 2 3 4\n2"}},
     n1 + tet1 + "v element faces 4 from 0: 1 2 3 4\n"},
    {"OfTetrahedraThatAreNotThere",
     "a.node",
     {{"a.node", nodes1}, {"a.neigh", "1 4\n1 -1 -1 -1 -1\n"}},
     n1,
     {"a.node: there is no a.ele beside it: nodes only",
      "a.neigh: there is no a.ele beside it, without which it means nothing"}},
    {"NamesInCapitals", "a.ELE", {{"a.node", nodes1}, {"a.ELE", ele1}}, n1 + tet1},
    {"Voronoi",
     "a.v.face",
     {{"a.node", nodes1},
      {"a.v.node", "2 3 0 0\n1 0.5 0.5 0.5\n2 1 1 1\n"},
      {"a.v.edge", "2 0\n1 1 2\n2 2 -1 0 0 -1.5\n"},
      {"a.v.face", "2 0\n1 1 2 2 1 2\n2 3 4 2 2 -1\n"},
      {"a.v.cell", "2\n1 2 1 2\n2 2 1 -1\n"}},
     n1 + "vn 0.5 0.5 0.5\nvn 1 1 1\nve 0 1 0 0 0\nve 1 -1 0 0 -1.5\nvf 0 1: 0 1\nvf 2 3: 1 -1\nvc 0 1\nvc 0 "
          "-1\n",
     {"a.node: there is no a.ele beside it: nodes only"}},
    {"TheLeastAndTheLargestMarker",
     "a.face",
     {{"a.node", nodes1},
      {"a.ele", ele1},
      {"a.face", "2 1\n1 1 2 3 -9223372036854775808\n2 1 2 4 9223372036854775807\n"}},
     n1 + "b 4 4 1\ne 1: 1 2 3 4\nb 2 3 2\ne 2: 1 2 3\ne 3: 1 2 4\n"
          "v element markers 1 from 1: -9223372036854775808 9223372036854775807\n"},
    {"AMeshThatIsCalledV", "a.v.node", {{"a.v.node", nodes1}, {"a.v.ele", ele1}}, n1 + tet1},
};

class TetgenRead : public testing::TestWithParam<Case> {};

TEST_P(TetgenRead, SaysWhatTheFilesSay) {
  const test::TestFiles files;
  for (const auto& [name, bytes] : GetParam().files) files.write(name, bytes);
  const Document document = read_document(files.path(GetParam().file));
  EXPECT_EQ(test::tetgen_text(document), GetParam().expected);
  EXPECT_EQ(test::warnings_of(document, files), GetParam().warnings);
}

INSTANTIATE_TEST_SUITE_P(ByHand, TetgenRead, testing::ValuesIn(cases),
                         [](const auto& test) { return test.param.name; });

struct ErrorCase {
  std::string name, file;
  Files files;
  std::string message;

  friend void PrintTo(const ErrorCase& test, std::ostream* out) { *out << test.name; }
};

Files with_tet(Files files) {
  files.insert(files.end(), {{"a.node", nodes1}, {"a.ele", ele1}});
  return files;
}

const std::vector<ErrorCase> errors{
    {"NeighboursOfMore", "a.ele", with_tet({{"a.neigh", "2 4\n1 1 1 1 1\n2 1 1 1 1\n"}}),
     "a.neigh:1: expected 1 tetrahedron as in a.ele, found 2"},
    {"FiveNeighbours", "a.ele", with_tet({{"a.neigh", "1 5\n1 1 1 1 1\n"}}),
     "a.neigh:1: expected 4 neighbours a tetrahedron, found 5"},
    {"NeighboursAlone",
     "a.neigh",
     {{"a.node", nodes1}, {"a.neigh", "0 4\n"}},
     "a.neigh: there is no a.ele beside it, without which it means nothing"},
    {"NoLineOfFaces", "a.ele", with_tet({{"a.t2f", "# none\n"}}),
     "a.t2f:2: expected 1 tetrahedron as in a.ele, found 0 and the end of the file"},
    {"ShortLineOfEdges", "a.ele", with_tet({{"a.t2e", "1 1 2 3 4 5\n"}}),
     "a.t2e:1: expected a number, found the end of the line"},
    {"VolumesOfLess", "a.ele", with_tet({{"a.vol", "0\n"}}),
     "a.vol:1: expected 1 tetrahedron as in a.ele, found 0"},
    {"SizesOfMore", "a.ele", with_tet({{"a.mtr", "5 1\n"}}),
     "a.mtr:1: expected 4 nodes as in a.node, found 5"},
    {"TwoSizes", "a.ele", with_tet({{"a.mtr", "4 2\n1 1\n1 1\n1 1\n1 1\n"}}),
     "a.mtr:1: expected 1, 3 or 6 sizes a node, found 2"},
    {"NoSize", "a.ele", with_tet({{"a.mtr", "4 1\n1\n2\nx\n4\n"}}), "a.mtr:4: expected a size, found 'x'"},
    {"FewerFaces", "a.face", with_tet({{"a.face", "2\n1 1 2 3\n"}}),
     "a.face:3: expected 2 faces, found 1 and the end of the file"},
    {"FaceOfTwoCorners", "a.face", with_tet({{"a.face", "1\n1 1 2\n"}}),
     "a.face:2: expected the number of a node, found the end of the line"},
    {"EdgesBeyondTheFile", "a.ele", with_tet({{"a.edge", "1000000000000\n"}}),
     "a.edge:1: expected the number of edges, found 1000000000000, more than the 1 byte left can hold"},
    {"AreaWithoutValue", "a.ele", with_tet({{"a.var", "1\n1 7\n"}}),
     "a.var:2: expected an area, found the end of the line"},
    {"LengthsThatAreMissing", "a.ele", with_tet({{"a.var", "0\n2\n1 1 2 3\n"}}),
     "a.var:4: expected a bound of a length, found the end of the file"},
    {"VoronoiPointThatIsNotThere",
     "a.v.cell",
     {{"a.node", nodes1},
      {"a.v.node", "1 3\n1 0 0 0\n"},
      {"a.v.edge", "1\n1 1 2\n"},
      {"a.v.face", "0\n"},
      {"a.v.cell", "0\n"}},
     "a.v.edge:2: expected a point, 1 to 1 or -1, found 2"},
    {"NoneInTheMiddle",
     "a.v.cell",
     {{"a.node", nodes1},
      {"a.v.node", "1 3\n1 0 0 0\n"},
      {"a.v.edge", "1\n1 1 1\n"},
      {"a.v.face", "1\n1 1 2 2 -1 1\n"},
      {"a.v.cell", "0\n"}},
     "a.v.face:2: expected an edge, 1 to 1, found -1"},
    {"VoronoiInPart",
     "a.v.cell",
     {{"a.node", nodes1}, {"a.v.node", "0\n"}, {"a.v.cell", "0\n"}},
     "a.v.edge: cannot open: No such file or directory"},
    {"VoronoiWithoutNodes",
     "a.v.cell",
     {{"a.v.node", "0\n"}, {"a.v.edge", "0\n"}, {"a.v.face", "0\n"}, {"a.v.cell", "0\n"}},
     "a.node: cannot open: No such file or directory"},
    {"MarkerBelowTheLeast", "a.face", with_tet({{"a.face", "1 1\n1 1 2 3 -9223372036854775809\n"}}),
     "a.face:2: expected a boundary marker, found '-9223372036854775809'"},
    {"CellOfNothing", "a.cell", {{"a.cell", "0\n"}}, "a.cell: expected .v.cell, found .cell"},
    {"NamedButNotThere", "a.edge", with_tet({}), "a.edge: cannot open: No such file or directory"},
};

class TetgenErrors : public testing::TestWithParam<ErrorCase> {};

TEST_P(TetgenErrors, HaveOneLineWithThePlace) {
  const test::TestFiles files;
  for (const auto& [name, bytes] : GetParam().files) files.write(name, bytes);
  EXPECT_EQ(files.message([&] { read_document(files.path(GetParam().file)); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(ByHand, TetgenErrors, testing::ValuesIn(errors),
                         [](const auto& test) { return test.param.name; });

// Long files are read by several threads if their lines are plain, with the same result.
TEST(TetgenRead, PlainLinesAndOthersAlike) {
  constexpr int count = 3000;
  std::map<std::string, std::string> set{
      {".node", fmt::format("{} 3\n", count)},  {".ele", fmt::format("{} 4\n", count)},
      {".face", fmt::format("{} 1\n", count)},  {".edge", fmt::format("{} 1\n", count)},
      {".neigh", fmt::format("{} 4\n", count)}, {".t2f", ""},
      {".vol", fmt::format("{}\n", count)},     {".mtr", fmt::format("{} 1\n", count)}};
  for (int i = 0; i < count; ++i) {
    const int j = (i * 7 + 1) % count, k = (i * 5 + 2) % count, l = (i * 3 + 1) % count;
    set[".node"] += fmt::format("{} {} {} {}\n", i, i * 0.1, -i, 1e-3 * i);
    set[".ele"] += fmt::format("{} {} {} {} {}\n", i, i, j, k, l);
    set[".face"] += fmt::format("{} {} {} {} {} {} -1\n", i, i, j, k, i % 5 - 2, l);
    set[".edge"] += fmt::format("{} {} {} {} {}\n", i, i, j, i % 3, k);
    set[".neigh"] += fmt::format("{} {} {} {} -1\n", i, j, k, l);
    set[".t2f"] += fmt::format("{} {} {} {} {}\n", i, i, l, k, j);
    set[".vol"] += fmt::format("{} {}\n", i, 0.5 * i);
    set[".mtr"] += fmt::format("{}\n", 0.25 * i);
  }
  const auto read = [&] {
    const test::TestFiles files;
    for (const auto& [ending, bytes] : set) files.write("a" + ending, bytes);
    const Document document = read_document(files.path("a.ele"));
    EXPECT_TRUE(document.warnings.empty());
    return test::tetgen_text(document);
  };
  const std::string plain = read();
  EXPECT_NE(plain.find("e 8999: 2999 2994\n"), plain.npos);
  for (auto& [ending, bytes] : set) bytes.insert(bytes.rfind('\n', bytes.size() - 2) + 1, "# a comment\n");
  EXPECT_EQ(plain == read(), true);
}

}  // namespace
}  // namespace tetproof
