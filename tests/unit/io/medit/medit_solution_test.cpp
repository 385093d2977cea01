// SPDX-License-Identifier: GPL-3.0-or-later
// Solutions beside Medit's meshes: read with the mesh, or named; written where nodes have values.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <string>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "io/writing.hpp"
#include "tests/support/binary_bytes.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

const std::string head = "MeshVersionFormatted 2\n\nDimension 3\n\n";
const std::string mesh = head + "Vertices\n2\n0 0 0 0\n1 0 0 0\n\nEdges\n1\n1 2 5\n\nEnd\n";
const std::string sol = head +
                        "SolAtVertices\n2\n4 1 2 3 4\n"
                        "0.5 1 2 3 11 21 22 31 32 33 1 2 3 4 5 6 7 8 9\n"
                        "-1 4 5 6 1 2 3 4 5 6 9 8 7 6 5 4 3 2 1\n\nEnd\n";
const std::string values =
    "v nodes solution 1: 0.5 -1\nv nodes solution 2 3: 1 2 3 4 5 6\n"
    "v nodes solution 3 9: 11 21 31 21 22 32 31 32 33 1 2 4 2 3 5 4 5 6\n"
    "v nodes solution 4 9: 1 2 3 4 5 6 7 8 9 9 8 7 6 5 4 3 2 1\n";

std::string values_of(const Document& document) {
  const std::string text = test::text_of(document, false);
  const std::size_t at = text.find("v ");
  return at == text.npos ? "" : text.substr(at);
}

// The same as `sol`, with one field of each kind, in binary.
std::string solb(int version, std::endian order) {
  std::string bytes;
  const auto integer = [&](std::int32_t value) { test::append(bytes, value, order); };
  const auto real = [&](double value) {
    version == 1 ? test::append(bytes, static_cast<float>(value), order) : test::append(bytes, value, order);
  };
  const auto next = [&](std::size_t size) {
    const std::size_t place = bytes.size() + (version < 3 ? 4 : 8) + size;
    version < 3 ? integer(static_cast<std::int32_t>(place))
                : test::append(bytes, static_cast<std::int64_t>(place), order);
  };
  integer(1), integer(version), integer(3), next(4), integer(3);
  const std::size_t each = version == 1 ? 4 : 8;
  integer(62), next((version == 4 ? 8 : 4) + 5 * 4 + 2 * 19 * each);
  version == 4 ? test::append(bytes, std::int64_t{2}, order) : integer(2);
  for (const int number : {4, 1, 2, 3, 4}) integer(number);
  for (const double number :
       {.5,  1., 2., 3., 11., 21., 22., 31., 32., 33., 1., 2., 3., 4., 5., 6., 7., 8., 9.,
        -1., 4., 5., 6., 1.,  2.,  3.,  4.,  5.,  6.,  9., 8., 7., 6., 5., 4., 3., 2., 1.})
    real(number);
  integer(54), version < 3 ? integer(0) : test::append(bytes, std::int64_t{0}, order);
  return bytes;
}

TEST(MeditSolutions, AreReadBesideTheMeshOrNamed) {
  const test::TestFiles files;
  files.write("a.mesh", mesh), files.write("a.sol", sol);
  for (const char* name : {"a.mesh", "a.sol"}) {
    const Document document = read_document(files.path(name));
    EXPECT_EQ(document.points.size(), 2u) << name;
    EXPECT_EQ(values_of(document), values) << name;
    EXPECT_TRUE(document.warnings.empty() && document.dropped.empty()) << name;
  }
}

TEST(MeditSolutions, BinaryOfAllVersionsAndByteOrders) {
  for (const int version : {1, 2, 3, 4})
    for (const std::endian order : {std::endian::little, std::endian::big}) {
      const test::TestFiles files;
      files.write("a.mesh", mesh), files.write("a.solb", solb(version, order));
      EXPECT_EQ(values_of(read_document(files.path("a.mesh"))), values) << version;
      EXPECT_EQ(values_of(read_document(files.path("a.solb"))), values) << version;
    }
}

TEST(MeditSolutions, InTheMeshItselfAndOfElements) {
  const test::TestFiles files;
  const std::string own = head +
                          "Vertices 2\n0 0 0 0\n1 0 0 0\nEdges 1\n1 2 0\nSolAtEdges 1\n1 1 7\n"
                          "SolAtVertices 2\n1 1 3 4\nTriangles 1\n1 2 2 0\nSolAtTriangles 1 1 2 1 2 3\nEnd\n";
  EXPECT_EQ(values_of(read_document(files.write("a.mesh", own))),
            "v nodes solution 1: 3 4\nv elements solution 1 at 1: 7\nv elements solution 3 at 2: 1 2 3\n");
}

TEST(MeditSolutions, OfThePlaneGetAThirdComponent) {
  const test::TestFiles files;
  files.write("a.mesh", "MeshVersionFormatted 2 Dimension 2 Vertices 1 5 6 0 End");
  files.write("a.sol",
              "MeshVersionFormatted 2 Dimension 2 SolAtVertices 1 3 2 3 4  1 2  11 21 22  1 2 3 4 End");
  EXPECT_EQ(values_of(read_document(files.path("a.mesh"))),
            "v nodes solution 3: 1 2 0\nv nodes solution 2 9: 11 21 0 21 22 0 0 0 0\n"
            "v nodes solution 3 9: 1 2 0 3 4 0 0 0 0\n");
}

TEST(MeditSolutions, OfOtherMeshesAreDroppedAndSaid) {
  const test::TestFiles files;
  files.write("a.mesh", mesh);
  files.write("a.sol", head + "SolAtVertices\n3\n1 1\n1\n2\n3\nEnd\n");
  const Document other = read_document(files.path("a.mesh"));
  ASSERT_EQ(other.dropped.size(), 1u);
  EXPECT_EQ(other.dropped[0].item, "values of SolAtVertices, since their number is another one");
  EXPECT_EQ(other.dropped[0].example, "3 in place of 2");

  files.write("a.sol", head + "SolAtVertices\n2\n1 9\n1\n2\nEnd\n");
  const Document broken = read_document(files.path("a.mesh"));
  ASSERT_EQ(broken.dropped.size(), 1u);
  EXPECT_NE(broken.dropped[0].example.find("a.sol:7: expected the type of a field, 1 to 4, found 9"),
            std::string::npos)
      << broken.dropped[0].example;
  EXPECT_EQ(files.message([&] { read_document(files.path("a.sol")); }),
            "a.sol:7: expected the type of a field, 1 to 4, found 9");

  files.write("a.sol", "the solution of an equation\n");
  const Document foreign = read_document(files.path("a.mesh"));
  EXPECT_TRUE(foreign.dropped.empty());
  ASSERT_EQ(foreign.warnings.size(), 1u);
  EXPECT_NE(foreign.warnings[0].find("a.sol: no solution as Medit has them"), std::string::npos);

  std::filesystem::remove(files.path("a.mesh"));
  files.write("a.sol", sol);
  EXPECT_EQ(files.message([&] { read_document(files.path("a.sol")); }),
            "a.sol: expected its mesh beside it, a.mesh or a.meshb; found none");
}

TEST(MeditSolutions, AreWrittenAndComeBack) {
  const test::TestFiles files;
  files.write("a.mesh", mesh), files.write("a.sol", sol);
  const Document document = read_document(files.path("a.mesh"));
  for (const auto& [name, beside] : {std::pair("b.mesh", "b.sol"), {"b.meshb", "b.solb"}}) {
    PlannedFile file(files.path(name), document);
    EXPECT_TRUE(file.losses().empty()) << file.losses()[0].item;
    EXPECT_EQ(file.files(), (std::vector<std::string>{files.path(name), files.path(beside)}));
    EXPECT_NE(file.warning().find(fmt::format("{}: is written too", beside)), std::string::npos)
        << file.warning();
    file.write();
    EXPECT_EQ(test::text_of(read_document(files.path(name)), false), test::text_of(document, false));
    EXPECT_NE(write_warning(files.path(name), document).find(fmt::format("{}: is replaced too", beside)),
              std::string::npos);
  }
  EXPECT_EQ(files.read(files.path("b.sol")), sol);  // as MMG has it
}

TEST(MeditSolutions, LoseNamesAndValuesOfSomeNodes) {
  const test::TestFiles files;
  Document document =
      document_of(TetMesh{.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .tets = {{0, 1, 2, 3}}});
  document.node_values.push_back({.name = "some", .reals = {1}, .at = {2}});
  document.node_values.push_back({.name = "heat", .reals = {1, 2, 3, 4}});
  document.node_values.push_back({.name = "labels", .integers = {1, 2, 3, 4}});
  std::string lost;
  for (const Loss& loss : losses(files.path("a.mesh"), document))
    lost += fmt::format("{} ({})\n", loss.item, loss.example);
  EXPECT_EQ(lost,
            "values \"some\" of nodes (1)\nnames of values of nodes (\"heat\" becomes \"solution\")\n"
            "values \"labels\" of nodes (1)\n");
  write_document(files.path("a.mesh"), document);
  EXPECT_EQ(values_of(read_document(files.path("a.mesh"))), "v nodes solution 1: 1 2 3 4\n");

  // A solution of an earlier mesh stays, and would be read.
  document.node_values.clear();
  EXPECT_NE(write_warning(files.path("a.mesh"), document).find("a.sol: is there already"), std::string::npos);
  EXPECT_EQ(write_warning(files.path("new.mesh"), document), "");
}

std::string items_of(const std::vector<Loss>& losses) {
  std::string text;
  for (const Loss& loss : losses) text += fmt::format("{} {} ({})\n", loss.count, loss.item, loss.example);
  return text;
}

// Values of elements stand in the mesh itself if there are none of vertices, which programs expect in a .sol.
TEST(MeditSolutions, OfElementsAreWrittenAndComeBack) {
  const test::TestFiles files;
  const std::string own = head +
                          "Vertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTriangles 2\n1 2 3 5\n1 2 4 6\n"
                          "Tetrahedra 1\n1 2 3 4 0\n";
  const std::string fields =
      "\nSolAtTriangles\n2\n2 1 2\n5 1 2 3\n6 4 5 6\n\nSolAtTetrahedra\n1\n1 3\n"
      "11 21 22 31 32 33\n";
  const std::string as_read =
      "v elements solution 1 at 1 2: 5 6\nv elements solution 2 3 at 1 2: 1 2 3 4 5 6\n"
      "v elements solution 9 at 3: 11 21 31 21 22 32 31 32 33\n";
  const Document document = read_document(files.write("a.mesh", own + fields + "End\n"));
  EXPECT_EQ(values_of(document), as_read);
  for (const std::string out : {"b.mesh", "b.meshb"}) {
    PlannedFile file(files.path(out), document);
    EXPECT_EQ(items_of(file.losses()), "") << out;
    EXPECT_EQ(file.files(), std::vector<std::string>{files.path(out)});
    file.write();
    const Document back = read_document(files.path(out));
    EXPECT_EQ(items_of(back.dropped), "") << out;
    EXPECT_EQ(test::text_of(back, false), test::text_of(document, false)) << out;
  }
  EXPECT_NE(files.read(files.path("b.mesh")).find(fields), std::string::npos)
      << files.read(files.path("b.mesh"));

  // A name is lost, and what some elements of a kind have has no place.
  Document other = document;
  other.element_values[0].name = "heat";
  other.element_values[1].at = {0}, other.element_values[1].reals = {1, 2, 3};
  EXPECT_EQ(items_of(losses(files.path("c.mesh"), other)),
            "1 names of values of elements (\"heat\" becomes \"solution\")\n"
            "3 values \"solution 2\" of elements (1)\n");
  write_document(files.path("c.mesh"), other);
  EXPECT_EQ(values_of(read_document(files.path("c.mesh"))),
            "v elements solution 1 at 1 2: 5 6\nv elements solution 9 at 3: 11 21 31 21 22 32 31 32 33\n");
}

// With values of vertices they stand behind these; else only Medit's own files get keywords for them.
TEST(MeditSolutions, OfElementsStandBehindThoseOfVertices) {
  const test::TestFiles files;
  Document document = read_document(files.write("a.mesh", mesh));
  document.format.clear();
  document.element_values = {{.name = "solution", .reals = {7}}};
  EXPECT_EQ(items_of(losses(files.path("b.mesh"), document)), "1 values \"solution\" of elements (7)\n");
  document.node_values = {{.name = "solution", .reals = {3, 4}}};
  for (const std::string out : {"b.mesh", "b.meshb"}) {
    EXPECT_EQ(items_of(losses(files.path(out), document)), "") << out;
    write_document(files.path(out), document);
    const Document back = read_document(files.path(out));
    EXPECT_EQ(items_of(back.dropped), "") << out;
    EXPECT_EQ(values_of(back), "v nodes solution 1: 3 4\nv elements solution 1: 7\n") << out;
  }
  EXPECT_EQ(files.read(files.path("b.sol")),
            head + "SolAtVertices\n2\n1 1\n3\n4\n\nSolAtEdges\n1\n1 1\n7\n\nEnd\n");
  EXPECT_EQ(files.read(files.path("b.mesh")).find("SolAt"), std::string::npos);
}

// With elements of one kind the values are those of all elements.
TEST(MeditSolutions, OfAllElements) {
  const test::TestFiles files;
  const Document document =
      read_document(files.write("a.mesh", mesh.substr(0, mesh.find("\nEnd")) + "SolAtEdges 1 1 1 7\nEnd\n"));
  EXPECT_EQ(values_of(document), "v elements solution 1: 7\n");
  EXPECT_EQ(items_of(losses(files.path("b.meshb"), document)), "");
  write_document(files.path("b.meshb"), document);
  EXPECT_EQ(values_of(read_document(files.path("b.meshb"))), "v elements solution 1: 7\n");
}

TEST(MeditSolutions, NothingElseInThemIsPassedOverInSilence) {
  const test::TestFiles files;
  files.write("a.mesh", mesh);
  const std::string keywords =
      "Vertices 1\n0 0 0 0\nCorners 1 1\nRequiredVertices 1 2\nEdges 1 1 2 3\nTrianglesP2Ordering 6\n"
      "2 0 0\n0 2 0\n0 0 2\n1 1 0\n0 1 1\n1 0 1\nTime 2\n";
  files.write("a.sol", head + keywords + "SolAtVertices 2 1 1\n1 2\nEnd\n");
  const Document document = read_document(files.path("a.mesh"));
  EXPECT_TRUE(document.warnings.empty()) << document.warnings[0];
  std::string dropped;
  for (const Loss& loss : document.dropped) dropped += loss.item.substr(loss.item.find(':') + 1);
  EXPECT_EQ(dropped, " Vertices Edges Time Corners RequiredVertices TrianglesP2Ordering");
  for (const Loss& loss : document.dropped) EXPECT_FALSE(loss.elements) << loss.item;
}

}  // namespace
}  // namespace tetproof
