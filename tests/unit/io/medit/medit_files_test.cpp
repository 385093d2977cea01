// SPDX-License-Identifier: GPL-3.0-or-later
// Medit files, text and binary: written by hand, and samples of other programs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/binary_bytes.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/refused_file.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

const std::string four_points = "n 1 0 0 0\nn 2 1 0 0\nn 3 0 1 0\nn 4 0 0 1\n";

// Collects the numbers of a binary file in a byte order.
class Bytes {
 public:
  explicit Bytes(std::endian order) : order_(order) {}
  template <class T>
  Bytes& operator()(T value) {
    test::append(bytes_, value, order_);
    return *this;
  }
  // A keyword and the position behind its data, which have `size` bytes. The position has 4 or 8 bytes.
  Bytes& keyword(int code, int version, std::size_t size) {
    (*this)(std::int32_t{code});
    const std::size_t next = bytes_.size() + (version < 3 ? 4 : 8) + size;
    return version < 3 ? (*this)(static_cast<std::int32_t>(next)) : (*this)(static_cast<std::int64_t>(next));
  }
  Bytes& integer(int version, std::int64_t value) {
    return version == 4 ? (*this)(value) : (*this)(static_cast<std::int32_t>(value));
  }
  Bytes& real(int version, double value) {
    return version == 1 ? (*this)(static_cast<float>(value)) : (*this)(value);
  }
  const std::string& text() const { return bytes_; }

 private:
  std::endian order_;
  std::string bytes_;
};

// Four vertices, a tetrahedron with reference 7, a ridge, normals, and an unknown keyword.
std::string binary_file(int version, std::endian order) {
  Bytes bytes(order);
  const std::size_t i = version == 4 ? 8 : 4, r = version == 1 ? 4 : 8;
  bytes(std::int32_t{1})(std::int32_t{version}).keyword(3, version, 4)(std::int32_t{3});
  bytes.keyword(14, version, 2 * i).integer(version, 1).integer(version, 2);  // Ridges
  bytes.keyword(4, version, i + 4 * (3 * r + i)).integer(version, 4);
  for (const auto& p : {std::array{0, 0, 0, 0}, {1, 0, 0, 5}, {0, 1, 0, 0}, {0, 0, 1, -3}}) {
    for (int k = 0; k < 3; ++k) bytes.real(version, p[static_cast<std::size_t>(k)]);
    bytes.integer(version, p[3]);
  }
  bytes.keyword(9999, version, 3)('a')('b')('c');
  bytes.keyword(8, version, 6 * i).integer(version, 1);
  for (const int n : {1, 2, 3, 9, 7}) bytes.integer(version, n);
  bytes.keyword(5, version, 7 * i).integer(version, 2);
  for (const int n : {1, 2, 0, 2, 3, 4}) bytes.integer(version, n);
  bytes.keyword(60, version, i + 3 * r)
      .integer(version, 1)
      .real(version, 0.5)
      .real(version, 0)
      .real(version, -1);
  bytes.keyword(54, version, 0);
  return bytes.text();
}

TEST(MeditFiles, BinaryOfAllVersionsAndByteOrders) {
  const test::TestFiles files;
  for (const int version : {1, 2, 3, 4})
    for (const std::endian order : {std::endian::little, std::endian::big}) {
      const Document document = read_document(files.write("a.meshb", binary_file(version, order)));
      EXPECT_EQ(test::text_of(document, false),
                four_points +
                    "e 1 4 3/0 g7 p: 1 2 3 ?9\ne 2 1 1/0 g p: 1 2\ne 3 1 1/0 g4 p: 2 3\n"
                    "v nodes references 1: 0 5 0 -3\nv elements Ridges 1 at 3: 1\nS Normals [1\n0.5 0 -1]\n")
          << version;
      ASSERT_EQ(document.element_values.size(), 1U);
      EXPECT_EQ(document.element_values[0].at, std::vector<Index>{2});  // the second edge of the file
      EXPECT_TRUE(document.warnings.empty());
      ASSERT_EQ(document.dropped.size(), 1U);
      EXPECT_EQ(document.dropped[0].item, "keyword of code 9999");
    }
}

TEST(MeditFiles, TextInAnyOrder) {
  const test::TestFiles files;
  const Document document =
      read_document(files.write("a.mesh",
                                "# a comment\nMeshVersionFormatted 1 # of 32 bits?\nDimension\n2\n"
                                "RequiredVertices 2\n 3 9\nTriangles\n2 1 2 3 8 2\n1 3 0 Corners 1\n1\n"
                                "Vertices 3\n0 0 0 0.1d0 0 0 0 1e-3 0\n"
                                "Mine 3\n  # kept\n 1 2\n\nNormals\n1\n0 1\nEnd\n"));
  EXPECT_EQ(test::text_of(document, false),
            "n 1 0 0 0\nn 2 0.1 0 0\nn 3 0 0.001 0\ne 1 2 2/0 g8 p: 1 2 3\ne 2 2 2/0 g p: 2 1 3\n"
            "v nodes RequiredVertices 1 at 3 ?9: 1 1\nv nodes Corners 1 at 1: 1\nS Mine [3\n  # kept\n 1 "
            "2]\nS Normals "
            "[1\n0 1 0]\n");
  EXPECT_EQ(document.node_values[0].at, (std::vector<Index>{2, -1}));
  EXPECT_EQ(document.unknown, std::vector<std::int64_t>{9});
  ASSERT_EQ(document.warnings.size(), 1U);
  EXPECT_NE(document.warnings[0].find("a.mesh:13: the keyword Mine is not known"), std::string::npos)
      << document.warnings[0];
}

TEST(MeditFiles, AnOrderOfItsOwn) {
  const test::TestFiles files;
  const std::string head =
      "MeshVersionFormatted 2\nDimension 3\nVertices 3\n0 0 0 0\n1 0 0 0\n.5 0 0 0\nEdgesP2\n1\n";
  EXPECT_EQ(
      read_document(files.write("a.mesh", head + "1 3 2 0\nEdgesP2Ordering\n3\n0\n1\n2\nEnd\n")).connectivity,
      (std::vector<Index>{0, 1, 2}));
  const Document kept =
      read_document(files.write("b.mesh", head + "1 2 3 0\nEdgesP2Ordering\n3\n0\n1\n7\nEnd\n"));
  EXPECT_EQ(kept.connectivity, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(kept.warnings.size(), 1U);
}

using test::RefusedFile;

class MeditErrors : public testing::TestWithParam<RefusedFile> {};

TEST_P(MeditErrors, HaveOneLineWithThePlace) {
  test::expect_refusal(GetParam());
}

const std::string head = "MeshVersionFormatted 2\nDimension 3\n",
                  binary = binary_file(2, std::endian::little);

std::string changed(std::size_t at, std::int32_t value) {
  std::string bytes = binary;
  std::memcpy(bytes.data() + at, &value, 4);
  return bytes;
}

INSTANTIATE_TEST_SUITE_P(
    ByHand, MeditErrors,
    testing::Values(
        RefusedFile{"Empty", "a.mesh", "",
                    "a.mesh:1: expected MeshVersionFormatted, found the end of the file"},
        RefusedFile{"NoVersion", "a.mesh", "Dimension 3\n",
                    "a.mesh:1: expected MeshVersionFormatted, found 'Dimension'"},
        RefusedFile{"Version", "a.mesh", "MeshVersionFormatted 5\n",
                    "a.mesh:1: expected a version from 1 to 4, found 5"},
        RefusedFile{"FourDimensions", "a.mesh", "MeshVersionFormatted 2 Dimension 4",
                    "a.mesh:1: expected the dimension 2 or 3, found 4"},
        RefusedFile{"NoVertices", "a.mesh", head + "End\n",
                    "a.mesh:3: expected Vertices, found the end of the file"},
        RefusedFile{
            "TooMany", "a.mesh", head + "Vertices 1000\n0 0 0 0\n",
            "a.mesh:3: expected the number of vertices, found 1000, more than the 9 bytes left can hold"},
        RefusedFile{"OneTooManyInALine", "a.mesh", head + "Vertices 1\n0 0 0 0 0\nEnd\n",
                    "a.mesh:4: expected a keyword, found '0'"},
        RefusedFile{"NumbersBehindTheDimension", "a.mesh", head + "3\nVertices 1\n0 0 0 0\nEnd\n",
                    "a.mesh:3: expected a keyword, found '3'"},
        RefusedFile{"OneMissing", "a.mesh", head + "Vertices 1\n0 0 0 0\nTriangles 2\n1 1 1 0\nEnd\n",
                    "a.mesh:7: expected the number of a vertex, found 'End'"},
        RefusedFile{"BinaryVersion", "a.meshb", changed(4, 9),
                    "a.meshb: byte 8: expected a version from 1 to 4, found 9"},
        RefusedFile{"BinaryPlace", "a.meshb", changed(24, 5),
                    "a.meshb: byte 28: expected the place of the next keyword, from 28 to 283, found 5"},
        RefusedFile{
            "BinaryCount", "a.meshb", changed(44, 1 << 30),
            "a.meshb: byte 48: expected the number of vertices, found 1073741824; 112 bytes are left for it"},
        RefusedFile{"BinaryCut", "a.meshb", binary.substr(0, 20),
                    "a.meshb: byte 20: expected Vertices, found the end of the file"}),
    test::name_of);

// Gmsh and MMG pass over lines that a keyword does not announce. Elements among them are missing then.
TEST(MeditFiles, LinesBehindACountAreDropped) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.mesh", head + "Vertices\n3\n0 0 0 0\n1 0 0 0\n0 1 0 0\n# none\n0 0 1 0\n\nTriangles\n1\n1 2 3 5\n"
                       "2 1 3 5\n3 2 1 5\nEdges 1\n1 2 0\nSolAtVertices 3 1 1\n1\n2\n3\n4\nEnd\n"));
  EXPECT_EQ(document.points.size(), 3u);
  EXPECT_EQ(document.elements(), 2u);
  std::string dropped;
  for (const Loss& loss : document.dropped)
    dropped += fmt::format("{} {} ({}) {}\n", loss.count, loss.item, loss.example, loss.elements);
  EXPECT_EQ(dropped,
            "1 lines of Vertices behind those that it announces (line 9) false\n"
            "2 lines of Triangles behind those that it announces (line 14) true\n"
            "1 lines of SolAtVertices behind those that it announces (line 22) false\n");
}

// Everything that the format holds, as text and as binary, also with numbers beyond 32 bits.
TEST(MeditFiles, RoundTrips) {
  Document document;
  document.points = {{0, -0.0, 5e-324}, {0.1 + 0.2, 1e300, 1.0 / 3}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  document.tag_sets = {{}, {3}, {-4'000'000'000}};
  document.blocks = {
      {.type = 1, .dim = 1, .nodes_each = 2, .count = 2},
      {.type = 2, .dim = 2, .groups = 1, .nodes_each = 3, .count = 1, .first = 2, .nodes = 4},
      {.type = 4, .dim = 3, .groups = 2, .nodes_each = 4, .count = 1, .first = 3, .nodes = 7},
      {.type = 4, .dim = 3, .groups = 1, .nodes_each = 4, .count = 1, .first = 4, .nodes = 11}};
  document.connectivity = {0, 1, 1, 2, 0, 1, 2, 0, 1, 2, 3, -1, 2, 3, 4};
  document.unknown = {77};
  document.node_values.push_back({.name = "references", .integers = {0, 1, -7, 0, 2}});
  document.node_values.push_back({.name = "Corners", .integers = {1, 1}, .at = {4, 0}});
  document.element_values.push_back({.name = "RequiredEdges", .integers = {1}, .at = {1}});
  document.element_values.push_back({.name = "RequiredTriangles", .integers = {1}, .at = {2}});
  document.sections.push_back({.name = "NormalAtVertices", .body = "2\n1 1\n3 1", .format = "medit"});
  document.sections.push_back({.name = "Normals", .body = "1\n0.1 -0 5e-324", .format = "medit"});
  const test::TestFiles files;
  for (const char* name : {"a.mesh", "a.meshb"})
    for (const bool wide : {true, false}) {
      if (!wide) document.tag_sets[2][0] = -4;
      const std::string path = files.path(name);
      EXPECT_TRUE(losses(path, document).empty()) << losses(path, document)[0].item;
      write_document(path, document);
      const Document back = read_document(path);
      EXPECT_EQ(test::text_of(back, false), test::text_of(document, false)) << name;
      EXPECT_TRUE(back.warnings.empty());
      EXPECT_EQ(back.node_values[1].at, document.node_values[1].at);
      EXPECT_EQ(back.element_values[0].at, document.element_values[0].at);
      EXPECT_TRUE(std::signbit(back.points[0].y()));
      document.tag_sets[2][0] = -4'000'000'000;
    }
}

TEST(MeditFiles, ReferencesOfVertices) {
  const auto values = [](std::vector<double> reals, std::vector<std::int64_t> integers) {
    return Values{.name = "references", .reals = std::move(reals), .integers = std::move(integers)};
  };
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  struct Case {
    Values values;
    bool in_text, in_binary;
  };
  const Case cases[] = {{values({}, {most, (std::int64_t{1} << 53) + 1, -most - 1}), true, true},
                        {values({}, {0, 0, 0}), false, false},
                        {values({0.5, -0.0, 8e15}, {}), true, false},
                        {values({0.5, 1, 1e16}, {}), false, false},
                        {values({0.5, nan, 1}, {}), false, false},
                        {values({0.5, -inf, 1}, {}), false, false},
                        {values({1, 2, 3}, {}), false, false}};
  const test::TestFiles files;
  for (const Case& one : cases) {
    Document document;
    document.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    document.node_values.push_back(one.values);
    for (const char* name : {"a.mesh", "a.meshb"}) {
      const std::string path = files.path(name);
      write_document(path, document);
      const Document back = read_document(path);
      const bool comes_back = name == std::string("a.mesh") ? one.in_text : one.in_binary;
      EXPECT_EQ(losses(path, document).empty(), comes_back);
      ASSERT_EQ(back.node_values.size(), comes_back ? 1U : 0U) << test::text_of(document, false);
      if (comes_back) {
        EXPECT_EQ(test::text_of(back, false), test::text_of(document, false));
      }
    }
  }
}

// A group below 0 is another thing in Gmsh, so TetGen's are values. Medit's references may be below 0.
TEST(MeditFiles, TakeTetGensMarkersBelowZeroAsReferences) {
  const test::TestFiles files;
  const std::string nodes = "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n",
                    faces = "4 1\n1 1 2 3 5\n2 1 2 4 -3\n3 2 3 4 0\n4 1 3 4 -3\n";
  for (const auto& [markers, expected] : {std::pair(faces, "1 2 3 5\n1 2 4 -3\n2 3 4 0\n1 3 4 -3\n"),
                                          {"2 1\n1 1 2 3 -1\n2 1 2 4 0\n", "1 2 3 -1\n1 2 4 0\n"}}) {
    files.write("a.face", markers);
    const Document document = read_document(files.write("a.node", nodes));
    for (const char* to : {"b.mesh", "b.meshb"}) {
      for (const Loss& loss : losses(files.path(to), document)) ADD_FAILURE() << to << ": " << loss.item;
      write_document(files.path(to), document);
      write_document(files.path("c.mesh"), read_document(files.path(to)));
      const std::string text = files.read(files.path("c.mesh"));
      const std::size_t from = text.find("Triangles\n") + 12;
      EXPECT_EQ(text.substr(from, text.find("\nEnd") - from), expected) << to;
      write_document(files.path("c.node"), read_document(files.path(to)));
      const std::string again = files.read(files.path("c.face"));
      EXPECT_EQ(again.substr(0, markers.size()), markers) << to;
    }
  }
  // Numbers above 0 beside those below stay values: they are of elements in groups, say.
  files.write("a.face", faces);
  Document both = read_document(files.write("a.node", nodes));
  both.element_values.at(0).integers.at(0) = 7;
  EXPECT_EQ(losses("b.mesh", both).at(0).item, "values \"markers\" of elements");
}

TEST(MeditFiles, TheEndingTellsTheForm) {
  const test::TestFiles files;
  const Document document =
      document_of(TetMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}});
  EXPECT_EQ(files.message([&] { write_document(files.path("a.mesh"), document, {.binary = true}); }),
            "a.mesh: Medit .mesh and .meshb is binary if the name ends in .meshb, and only then");
  EXPECT_EQ(files.message([&] { write_document(files.path("a.meshb"), document, {.binary = false}); }),
            "a.meshb: Medit .mesh and .meshb is binary if the name ends in .meshb, and only then");
  write_document(files.path("a.mesh"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.mesh")),
            "MeshVersionFormatted 2\n\nDimension 3\n\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n\n"
            "Tetrahedra\n1\n1 2 3 4 0\n\nEnd\n");
}

TEST(MeditFiles, SamplesOfOtherPrograms) {
  const auto folder = std::filesystem::path(TETPROOF_SOURCE_DIR) / ".." / "shared" / "formats";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  const Document gmsh = read_document(folder / "gmsh484_out/g.mesh");
  EXPECT_EQ(gmsh.points.size(), 62U);
  EXPECT_EQ(gmsh.elements(), 188U);  // 2 + 28 + 158; Gmsh leaves out the point
  EXPECT_EQ(tet_mesh(gmsh).tets.size(), 158U);
  const Document cube = read_document(folder / "tetgen150_out/cube_attr.1.mesh");
  EXPECT_EQ(cube.node_values[0].reals, (std::vector<double>{1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5}));
  EXPECT_EQ(cube.node_values[1].name, "Corners");
  EXPECT_EQ(cube.node_values[1].at.size(), 8U);
  EXPECT_EQ(cube.elements(), 36U);
  EXPECT_EQ(cube.warnings.size(), 1U);
  // TetGen wrote the same mesh in its own format.
  const Document nodes = read_document(folder / "tetgen150_out/example.1.node"),
                 mesh = read_document(folder / "tetgen150_out/example.1.mesh");
  EXPECT_EQ(mesh.points, nodes.points);
  EXPECT_EQ(tet_mesh(mesh).tets.size(), tet_mesh(nodes).tets.size());
}

}  // namespace
}  // namespace tetproof
