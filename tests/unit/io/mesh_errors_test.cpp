// SPDX-License-Identifier: GPL-3.0-or-later
// Files that break the grammar of a mesh format: the whole text of each message.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "io/mesh_files.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

struct Case {
  std::string name;
  std::vector<std::pair<std::string, std::string>> files;  // the first one is read
  std::string message;

  friend void PrintTo(const Case& test, std::ostream* out) { *out << test.name; }
};

const std::string v41 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";  // 3 lines
const std::string v22 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string one41 = "$Nodes\n1 1 1 1\n0 1 0 1\n1\n0 0 0\n$EndNodes\n";  // 6 lines
const std::string one22 = "$Nodes\n1\n1 0 0 0\n$EndNodes\n";                  // 4 lines
const std::string none41 = "$Elements\n0 0 0 0\n$EndElements\n";
const std::string nodes3 = "3 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n";

std::string zeros(std::size_t count) {
  return std::string(count, '\0');
}
std::string one_le() {
  return std::string("\1\0\0\0", 4);
}
const std::string b41 = "$MeshFormat\n4.1 1 8\n" + one_le() + "\n$EndMeshFormat\n";  // 40 bytes
const std::string b22 = "$MeshFormat\n2.2 1 8\n" + one_le() + "\n$EndMeshFormat\n";
std::string size_le(unsigned char value) {
  return std::string(1, static_cast<char>(value)) + zeros(7);
}
std::string int_le(unsigned char value) {
  return std::string(1, static_cast<char>(value)) + zeros(3);
}

const std::vector<Case> cases{
    {"Nothing", {{"a.msh", ""}}, "a.msh:1: expected $MeshFormat, found the end of the file"},
    {"Text", {{"a.msh", "\nhello\n"}}, "a.msh:2: expected a section ($Name), found 'hello'"},
    {"NoFormat", {{"a.msh", "$Nodes\n"}}, "a.msh:1: expected $MeshFormat, found '$Nodes'"},
    {"Version5",
     {{"a.msh", "$MeshFormat\n5 0 8\n$EndMeshFormat\n"}},
     "a.msh:2: this is a .msh file of version 5; versions 1 to 3, 4.0 and 4.1 are read"},
    {"Version1InsideAnother",
     {{"a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$NOD\n0\n$ENDNOD\n"}},
     "a.msh:4: section $NOD has no $EndNOD"},
    {"Version1NodesOfAnElement",
     {{"a.msh", "$NOD\n1\n1 0 0 0\n$ENDNOD\n$ELM\n1\n1 4 1 1 5 1 1 1 1 1\n$ENDELM\n"}},
     "a.msh:7: expected 4 nodes of an element of type 4, found 5"},
    {"Version1End", {{"a.msh", "$NOD\n1\n1 0 0 0\n$EndNOD\n"}}, "a.msh:4: expected $ENDNOD, found '$EndNOD'"},
    {"Version3NodesOfAnElement",
     {{"a.msh",
       "$MeshFormat\n3 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0 0\n$EndNodes\n$Elements\n1\n1 4 1 3 1 1 1\n"}},
     "a.msh:10: expected the nodes of an element of type 4, found 3 numbers"},
    {"Version3Entity",
     {{"a.msh", "$MeshFormat\n3 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0 5 4\n$EndNodes\n"}},
     "a.msh:6: expected the dimension of a node's entity, 0 to 3, found 4"},
    {"Version3EntityCount",
     {{"a.msh", "$MeshFormat\n3 0 8\n$EndMeshFormat\n$Entities\n0 99999999 0 0\n$EndEntities\n"}},
     "a.msh:5: expected the number of entities, found 99999999, more than the 18 bytes left can hold"},
    {"VersionIsText",
     {{"a.msh", "$MeshFormat\nnew 0 8\n"}},
     "a.msh:2: expected a version of the format, found 'new'"},
    {"FileType",
     {{"a.msh", "$MeshFormat\n4.1 2 8\n"}},
     "a.msh:2: expected 0 for text or 1 for binary, found 2"},
    {"NoDataSize",
     {{"a.msh", "$MeshFormat\n4.1 0\n$EndMeshFormat\n"}},
     "a.msh:3: expected the size of a number in bytes, found '$EndMeshFormat'"},
    {"BinaryDataSize",
     {{"a.msh", "$MeshFormat\n4.1 1 4\n"}},
     "a.msh:2: expected binary numbers of 8 bytes, found 4"},
    {"EndMisspelt",
     {{"a.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFromat\n"}},
     "a.msh:3: expected $EndMeshFormat, found '$EndMeshFromat'"},
    {"FormatTwice", {{"a.msh", v41 + v41}}, "a.msh:5: a second $MeshFormat"},
    {"TextBetweenSections",
     {{"a.msh", v41 + one41 + "x\n"}},
     "a.msh:10: expected a section ($Name), found 'x'"},
    {"SectionWithoutEnd",
     {{"a.msh", v41 + one41 + none41 + "$Mine\nno end\n$EndYours\n"}},
     "a.msh:13: section $Mine has no $EndMine"},
    {"NameOfAGroupOfNoDimension",
     {{"a.msh", v41 + "$PhysicalNames\n1\n4294967298 7 \"steel\"\n$EndPhysicalNames\n"}},
     "a.msh:6: expected the dimension of a physical group, 0 to 3, found 4294967298"},
    {"ParentOfNoDimension",
     {{"a.msh", v41 + "$PartitionedEntities\n2\n0\n1 0 0 0\n1 4 5 1 1 0 0 0 0\n$EndPartitionedEntities\n"}},
     "a.msh:8: expected the dimension of the parent entity, 0 to 3, found 4"},
    {"NameWithoutQuotes",
     {{"a.msh", v41 + "$PhysicalNames\n1\n3 7 steel\n$EndPhysicalNames\n"}},
     "a.msh:6: expected a name in double quotes, found 'steel'"},
    {"Msh41CountOfNodesIsBeyondTheFile",
     {{"a.msh", v41 + "$Nodes\n1 900000000 1 900000000\n0 1 0 900000000\n"}},
     "a.msh:6: expected the number of nodes in a block, found 900000000, more than the 1 byte left can hold"},
    {"Msh41CountOfNodesIsNegative",
     {{"a.msh", v41 + "$Nodes\n-1 1 1 1\n"}},
     "a.msh:5: expected the number of blocks and of nodes, found -1 and 1"},
    {"Msh41Dimension",
     {{"a.msh", v41 + "$Nodes\n1 1 1 1\n4 1 0 1\n"}},
     "a.msh:6: expected the dimension of an entity, 0 to 3, found 4"},
    {"Msh41Parametric",
     {{"a.msh", v41 + "$Nodes\n1 1 1 1\n0 1 7 1\n1\n0 0 0\n"}},
     "a.msh:6: expected 0 or 1 for parametric coordinates, found 7"},
    {"Msh41Coordinate",
     {{"a.msh", v41 + "$Nodes\n1 1 1 1\n0 1 0 1\n1\n0 0 0x\n$EndNodes\n"}},
     "a.msh:8: expected a coordinate, found '0x'"},
    {"Msh41CoordinateMissing",
     {{"a.msh", v41 + "$Nodes\n1 1 1 1\n0 1 0 1\n1\n0 0\n$EndNodes\n"}},
     "a.msh:9: expected a coordinate, found '$EndNodes'"},
    {"Msh41Tag",
     {{"a.msh", v41 + "$Nodes\n1 1 1 1\n0 1 0 1\n1.5\n0 0 0\n"}},
     "a.msh:7: expected the tag of a node, found '1.5'"},
    {"Msh41TagBeyond64Bits",
     {{"a.msh", v41 + "$Nodes\n1 1 1 1\n0 1 0 1\n18446744073709551616\n0 0 0\n"}},
     "a.msh:7: expected the tag of a node, found '18446744073709551616'"},
    {"Msh41NodeInTwoPlaces",
     {{"a.msh", v41 + "$Nodes\n1 2 5 5\n0 1 0 2\n5\n5\n0 0 0\n0 0 0.5\n$EndNodes\n" + none41}},
     "a.msh: node 5 is given twice with different coordinates: (0, 0, 0) and (0, 0, 0.5)"},
    {"Msh41NodeInTwoPlacesWithoutElements",
     {{"a.msh", v41 + "$Nodes\n1 2 5 5\n0 1 0 2\n5\n5\n0 0 0\n0 0 0.5\n$EndNodes\n"}},
     "a.msh: node 5 is given twice with different coordinates: (0, 0, 0) and (0, 0, 0.5)"},
    {"Msh41NodeInTwoPlacesBehindNoElements",
     {{"a.msh", v41 + none41 + "$Nodes\n1 2 5 5\n0 1 0 2\n5\n5\n0 0 0\n0 0 0.5\n$EndNodes\n"}},
     "a.msh: node 5 is given twice with different coordinates: (0, 0, 0) and (0, 0, 0.5)"},
    {"Msh41ElementCut",
     {{"a.msh", v41 + one41 + "$Elements\n1 1 1 1\n3 1 4 1\n1 1 1 1\n$EndElements\n"}},
     "a.msh:14: expected the tag of a node, found '$EndElements'"},
    {"Msh41LongerThanItsLine",
     {{"a.msh", v41 + one41 + "$Elements\n1 1 1 1\n0 1 15 1\n1 1 1\n$EndElements\n"}},
     "a.msh:13: expected $EndElements, found '1'"},
    {"Msh41UnknownTypeWithoutNodes",
     {{"a.msh", v41 + one41 + "$Elements\n1 1 1 1\n0 1 999 1\n1\n$EndElements\n"}},
     "a.msh:13: expected an element of type 999: its tag and its nodes"},
    {"Msh41NegativeType",
     {{"a.msh", v41 + one41 + "$Elements\n1 1 1 1\n0 1 -4 1\n1 1\n$EndElements\n"}},
     "a.msh:12: unknown element type -4"},
    {"Msh41Entities",
     {{"a.msh", v41 + "$Entities\n1 0 0 0\n1 0 0 0 9999999\n$EndEntities\n"}},
     "a.msh:6: expected the number of physical groups, found 9999999, more than the 14 bytes left can hold"},
    {"Msh41BinaryByteOrder",
     {{"a.msh", "$MeshFormat\n4.1 1 8\n" + zeros(4) + "\n$EndMeshFormat\n"}},
     "a.msh: byte 20: expected the number 1 that tells the byte order"},
    {"Msh41BinaryCut",
     {{"a.msh", b41 + "$Nodes\n" + size_le(1) + size_le(0) + zeros(3)}},
     "a.msh: byte 63: expected the least node tag (8 bytes), found 3 bytes and the end of the file"},
    {"Msh41BinaryCount",
     {{"a.msh", b41 + "$Nodes\n" + size_le(1) + size_le(200) + size_le(1) + size_le(200)}},
     "a.msh: byte 79: expected the dimension of an entity (4 bytes), found 0 bytes and the end of the file"},
    {"Msh41BinaryUnknownType",
     {{"a.msh", b41 + "$Nodes\n" + zeros(32) + "\n$EndNodes\n$Elements\n" + size_le(1) + size_le(1) +
                    size_le(1) + size_le(1) + int_le(3) + int_le(1) + int_le(200) + size_le(1) + zeros(16)}},
     "a.msh: byte 144: unknown element type 200"},
    {"Msh41BinaryEndMissing",
     {{"a.msh", b41 + "$Nodes\n" + zeros(32) + "$EndElements\n"}},
     "a.msh:6: expected $EndNodes, found '$EndElements'"},

    {"Msh22CountOfNodes",
     {{"a.msh", v22 + "$Nodes\n5000\n1 0 0 0\n"}},
     "a.msh:5: expected the number of nodes, found 5000, more than the 9 bytes left can hold"},
    {"Msh22CountOfElements",
     {{"a.msh", v22 + one22 + "$Elements\nmany\n"}},
     "a.msh:9: expected the number of elements, found 'many'"},
    {"Msh22CountOfTags",
     {{"a.msh", v22 + one22 + "$Elements\n1\n1 15 4000 1 1 1\n$EndElements\n"}},
     "a.msh:10: expected the number of tags, found 4000, more than the 20 bytes left can hold"},
    {"Msh22NegativeCountOfTags",
     {{"a.msh", v22 + one22 + "$Elements\n1\n1 15 -1 1 1 1\n$EndElements\n"}},
     "a.msh:10: expected the number of tags, found -1"},
    {"Msh22NoNodes",
     {{"a.msh", v22 + one22 + "$Elements\n1\n1 999 2 1 1\n$EndElements\n"}},
     "a.msh:10: expected the nodes of an element of type 999"},
    {"Msh22NegativeType",
     {{"a.msh", v22 + one22 + "$Elements\n1\n1 -15 2 1 1 1\n$EndElements\n"}},
     "a.msh:10: expected an element type, found -15"},
    {"Msh22NodesEndEarly",
     {{"a.msh", v22 + "$Nodes\n2\n1 0 0 0\n$EndNodes\n$Elements\n0\n$EndElements\n"}},
     "a.msh:7: expected the tag of a node, found '$EndNodes'"},
    {"Msh22ParametricDimension",
     {{"a.msh", v22 + "$ParametricNodes\n1\n1 0 0 0 9 1\n$EndParametricNodes\n"}},
     "a.msh:6: expected the dimension of a node's entity, 0 to 3, found 9"},
    {"Msh22BinaryHeader",
     {{"a.msh",
       b22 + "$Nodes\n0\n\n$EndNodes\n$Elements\n1\n" + int_le(15) + int_le(0) + int_le(0) + zeros(40)}},
     "a.msh: byte 80: expected the number of elements that follow, 1 or more, found 0"},
    {"Msh22BinaryUnknownType",
     {{"a.msh",
       b22 + "$Nodes\n0\n\n$EndNodes\n$Elements\n1\n" + int_le(200) + int_le(1) + int_le(0) + zeros(40)}},
     "a.msh: byte 76: unknown element type 200"},

    {"TetgenEmptyNode",
     {{"a.node", "# only this\n"}},
     "a.node:2: expected the number of nodes, found the end of the file"},
    {"TetgenCount", {{"a.node", "x 3\n"}}, "a.node:1: expected the number of nodes, found 'x'"},
    {"TetgenDimension", {{"a.node", "1 2\n1 0 0\n"}}, "a.node:1: expected the dimension 3, found 2"},
    {"TetgenCountIsBeyondTheFile",
     {{"a.node", "1000000 3\n1 0 0 0\n"}},
     "a.node:1: expected the number of nodes, found 1000000, more than the 9 bytes left can hold"},
    {"TetgenAttributesAreBeyondTheFile",
     {{"a.node", "1 3 100000\n1 0 0 0\n"}},
     "a.node:1: expected the number of attributes, found 100000, more than the 9 bytes left can hold"},
    {"TetgenFewerNodes",
     {{"a.node", "2 3\n1 0 0 0\n"}},
     "a.node:3: expected 2 nodes, found 1 and the end of the file"},
    {"TetgenBase",
     {{"a.node", "1 3\n2 0 0 0\n"}},
     "a.node:2: expected 0 or 1 as the first node's number, found 2"},
    {"TetgenGap",
     {{"a.node", "2 3\n1 0 0 0\n3 0 0 0\n"}},
     "a.node:3: expected node 2, found 3: nodes must stand in order"},
    {"TetgenShortLine",
     {{"a.node", "2 3\n1 0 0\n2 0 0 0\n"}},
     "a.node:2: expected a coordinate, found the end of the line"},
    {"TetgenCoordinate", {{"a.node", "1 3\n1 0 zero 0\n"}}, "a.node:2: expected a coordinate, found 'zero'"},
    {"TetgenInteger", {{"a.node", "1 3\n09 0 0 0\n"}}, "a.node:2: expected the number of a node, found '09'"},
    {"TetgenNoNode", {{"a.ele", "0 4\n"}}, "a.node: cannot open: No such file or directory"},
    {"TetgenNodesOfATetrahedron",
     {{"a.ele", "1 5\n1 1 2 3 1 2\n"}, {"a.node", nodes3}},
     "a.ele:1: expected 4 or 10 nodes a tetrahedron, found 5"},
    {"TetgenShortTetrahedron",
     {{"a.ele", "1 4\n1 1 2 3 # 4\n"}, {"a.node", nodes3}},
     "a.ele:2: expected the number of a node, found the end of the line"},
    {"TetgenFewerTetrahedra",
     {{"a.ele", "2 4\n1 1 2 3 1\n"}, {"a.node", nodes3}},
     "a.ele:3: expected 2 tetrahedra, found 1 and the end of the file"},
    {"TetgenFarTooManyTetrahedra",
     {{"a.ele", "123456789 4\n1 1 2 3 1\n"}, {"a.node", nodes3}},
     "a.ele:1: expected the number of tetrahedra, found 123456789, more than the 11 bytes left can hold"},

};

class MeshErrors : public testing::TestWithParam<Case> {};

TEST_P(MeshErrors, HaveOneLineWithThePlace) {
  const test::TestFiles files;
  for (const auto& [name, bytes] : GetParam().files) files.write(name, bytes);
  EXPECT_EQ(files.message([&] { read_document(files.path(GetParam().files[0].first)); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(ByHand, MeshErrors, testing::ValuesIn(cases),
                         [](const auto& test) { return test.param.name; });

TEST(MeshErrors, OfWriting) {
  const test::TestFiles files;
  const Document document;
  EXPECT_EQ(files.message([&] { write_document(files.path("a.xyz"), document); }),
            "a.xyz: unknown ending, expected one of .msh .node .ele .face .edge .neigh .vol .mtr .var .t2f "
            ".t2e .f2e .cell .poly .smesh .vtu .vtk .mesh .meshb .stl .off .obj .ply");
  EXPECT_EQ(files.message([&] { write_document(files.path("a.msh"), document, {.format = "msh5"}); }),
            "unknown format 'msh5', expected one of msh41 msh40 msh22 tetgen poly smesh vtu vtk medit stl "
            "off obj ply");
  EXPECT_EQ(files.message([&] { write_document(files.path("a.ele"), document, {.binary = true}); }),
            "a.ele: TetGen .node and .ele is never binary");
  EXPECT_EQ(files.message([&] { write_document(files.path("none/a.msh"), document); }),
            "none/a.msh: cannot create: No such file or directory");
  EXPECT_EQ(files.message([&] { read_document(files.path("none.msh")); }),
            "none.msh: cannot open: No such file or directory");
  EXPECT_TRUE(std::filesystem::is_empty(files.path("")));
}

TEST(MeshErrors, EntityTagsThatBinaryCannotHold) {
  const test::TestFiles files;
  files.write("a.msh", v41 + "$Nodes\n1 1 1 1\n0 2147483648 0 1\n1\n0 0 0\n$EndNodes\n" + none41);
  const Document document = read_document(files.path("a.msh"));
  EXPECT_EQ(files.message([&] { write_document(files.path("b.msh"), document, {.binary = true}); }),
            "a.msh: entity or group 2147483648 is too large for binary .msh, which gives it 4 bytes");
  EXPECT_FALSE(std::filesystem::exists(files.path("b.msh")));
}

}  // namespace
}  // namespace tetproof
