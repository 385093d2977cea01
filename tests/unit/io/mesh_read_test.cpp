// SPDX-License-Identifier: GPL-3.0-or-later
// Every construct of the mesh formats' text grammars, in files written by hand.
#include <gtest/gtest.h>

#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

struct Case {
  std::string name;
  std::vector<std::pair<std::string, std::string>> files;  // the first one is read
  std::string expected;
  std::vector<std::string> warnings = {};

  friend void PrintTo(const Case& test, std::ostream* out) { *out << test.name; }
};

const std::string v41 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
const std::string v22 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string nodes41 = "$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n";
const std::string nodes22 = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n";
const std::string tet41 = "$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n";
const std::string tet22 = "$Elements\n1\n1 4 2 0 1 1 2 3 4\n$EndElements\n";
const std::string n4 = "n 1 0 0 0\nn 2 1 0 0\nn 3 0 1 0\nn 4 0 0 1\n";
const std::string none41 = "$Elements\n0 0 0 0\n$EndElements\n";

const std::vector<Case> cases{
    {"Msh41Smallest",
     {{"a.msh", v41 + nodes41 + tet41}},
     "msh41\n" + n4 + "N 3/1 4: \ne 1 4 3/1 g p: 1 2 3 4\n"},
    {"Msh1",
     {{"a.msh",
       "$NOD\n4\n7 0 0 0\n8 1 0 0\n9 0 1 0\n-3 0 0 1\n$ENDNOD\n$ELM\n4\n1 4 5 2 4 7 8 9 -3\n2 4 6 2 4 7 8 9 "
       "-3\n"
       "3 2 0 1 3 7 8 9\n4 15 1 1 1 11\n$ENDELM\n"}},
     "msh1\nn 7 0 0 0\nn 8 1 0 0\nn 9 0 1 0\nn -3 0 0 1\ne 1 4 3/2 g5,6 p: 7 8 9 -3\ne 3 2 2/1 g p: 7 8 9\n"
     "e 4 15 0/1 g1 p: ?11\n",
     {"a.msh: 1 element repeats another one in a further physical group and is merged with it; the first is "
      "element 2, which repeats element 1"}},
    {"Msh1OlderNameOfTheNodes",
     {{"a.msh", "$NOE\n1\n1 0 0 0\n$ENDNOE\n$ELM\n0\n$ENDELM\n$PostFormat\n1\n$EndPostFormat\n"}},
     "msh1\nn 1 0 0 0\nS PostFormat [1\n]\n"},
    {"Msh3",
     {{"a.msh",
       "$MeshFormat\n3 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 7 \"steel\"\n$EndPhysicalNames\n"
       "$Entities\n1 1 1 1\n1 1 9\n4 2 1 -2 0\n5 1 -4 0\n2 1 5 2 7 8\n$EndEntities\n"
       "$Nodes\n4\n1 0 0 0 0\n2 1 0 0 4 1 0.5\n3 0 1 0 4 1 0.75\n4 0 0 1 5 2 0.25 0.125\n$EndNodes\n"
       "$Elements\n3\n1 2 5 3 1 2 3\n2 4 2 7 1 2 3 4 2 1 -2\n3 4 2 4 1 2 3 9\n$EndElements\n"}},
     "msh3\nG 3 7 steel\nE 0/1 0 0 0 0 0 0 g9 b\nE 1/4 0 0 0 0 0 0 g b1,-2\nE 2/5 0 0 0 0 0 0 g b-4\n"
     "E 3/2 0 0 0 0 0 0 g7,8 b5\n" +
         n4 +
         "N 1/4 2: 0.5 0.75\nN 2/5 1: 0.25 0.125\ne 1 2 2/5 g p: 1 2 3\ne 2 4 3/2 g7,8 p1: 1 2 3 4\n"
         "e 3 4 3/2 g7,8 p: 1 2 3 ?9\nghost element 2 1: 2\n"},
    {"Msh3SubElements",
     {{"a.msh",
       "$MeshFormat\n3 0 8\n$EndMeshFormat\n$Nodes\n2\n1 0 0 0 0\n2 1 0 0 0\n$EndNodes\n"
       "$Elements\n2\n1 1 1 2 1 2\n2 134 1 3 1 2 1\n$EndElements\n"}},
     "msh3\nn 1 0 0 0\nn 2 1 0 0\ne 1 1 1/1 g p: 1 2\ne 2 134 1/1 g p: 1 2\n"},
    {"Msh40",
     {{"a.msh",
       "$MeshFormat\n4 0 8\n$EndMeshFormat\n$Entities\n1 0 0 1\n1 0 0.5 1 0 0.5 1 1 -2\n"
       "3 0 0 0 1 1 1 2 7 8 1 -2\n$EndEntities\n"
       "$PartitionedEntities\n2\n1\n7 1\n0 0 0 1\n2 3 3 2 1 2 0 0 0 1 1 1 1 6 1 5\n$EndPartitionedEntities\n"
       "$Nodes\n2 4\n3 3 0 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n2 2 1 1\n4 0 0 1 0.25 0.75\n$EndNodes\n"
       "$Elements\n2 2\n3 3 4 1\n1 1 2 3 4\n2 3 4 1\n5 1 2 3 99\n$EndElements\n"}},
     "msh40\nE 0/1 0 0.5 1 0 0.5 1 g-2 b\nE 3/3 0 0 0 1 1 1 g7,8 b-2\nE 3/2 0 0 0 1 1 1 g6 b5 (3/3 "
     "p1,2)\nghost 7 1\n" +
         n4 + "N 3/3 3: \nN 2/2 1: 0.25 0.75\ne 1 4 3/3 g7,8 p: 1 2 3 4\ne 5 4 3/2 g6 p1,2: 1 2 3 ?99\n"},
    {"Msh41Empty", {{"a.msh", v41 + "$Nodes\n0 0 0 0\n$EndNodes\n" + none41}}, "msh41\n"},
    {"Msh41CommentsBlankLinesAndSpaces",
     {{"a.msh", "$Comments\nby hand\n$EndComments\n\n" + v41 + "\n  " + nodes41 + " \n" + tet41 + "\n\n"}},
     "msh41\n" + n4 + "N 3/1 4: \ne 1 4 3/1 g p: 1 2 3 4\nS ^Comments [by hand\n]\n"},
    {"Msh41CarriageReturns",
     {{"a.msh",
       "$MeshFormat\r\n4.1 0 8\r\n$EndMeshFormat\r\n$Nodes\r\n1 1 5 5\r\n0 1 0 1\r\n5\r\n1 2 "
       "3\r\n$EndNodes\r\n"
       "$Elements\r\n1 1 7 7\r\n0 1 15 1\r\n7 5\r\n$EndElements\r\n"}},
     "msh41\nn 5 1 2 3\nN 0/1 1: \ne 7 15 0/1 g p: 5\n"},
    {"Msh41SparseUnorderedTagsOf64Bits",
     {{"a.msh",
       v41 +
           "$Nodes\n2 4 3 9223372036854775807\n3 1 0 2\n9223372036854775807\n3\n0 0 0\n1 0 0\n2 -9 0 2\n-5\n"
           "2147483648\n0 1 0\n0 0 1\n$EndNodes\n$Elements\n1 1 8589934592 8589934592\n3 1 4 1\n"
           "8589934592 9223372036854775807 3 -5 2147483648\n$EndElements\n"}},
     "msh41\nn 9223372036854775807 0 0 0\nn 3 1 0 0\nn -5 0 1 0\nn 2147483648 0 0 1\nN 3/1 2: \nN 2/-9 2: \n"
     "e 8589934592 4 3/1 g p: 9223372036854775807 3 -5 2147483648\n"},
    {"Msh41NearlyDenseTags",
     {{"a.msh", v41 + "$Nodes\n1 4 10 16\n3 1 0 4\n16\n10\n12\n11\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n"
                      "$Elements\n1 2 3 9\n3 1 4 2\n9 10 11 12 16\n3 10 11 13 16\n$EndElements\n"}},
     "msh41\nn 16 0 0 0\nn 10 1 0 0\nn 12 0 1 0\nn 11 0 0 1\nN 3/1 4: \ne 9 4 3/1 g p: 10 11 12 16\n"
     "e 3 4 3/1 g p: 10 11 ?13 16\n"},
    {"Msh41NodesThatDoNotExist",
     {{"a.msh", v41 + nodes41 + "$Elements\n1 2 1 2\n3 1 4 2\n1 1 2 3 99\n2 0 -7 99 4\n$EndElements\n"}},
     "msh41\n" + n4 + "N 3/1 4: \ne 1 4 3/1 g p: 1 2 3 ?99\ne 2 4 3/1 g p: ?0 ?-7 ?99 4\n"},
    {"Msh41ElementsBeforeNodes",
     {{"a.msh", v41 + tet41 + nodes41}},
     "msh41\n" + n4 + "N 3/1 4: \ne 1 4 3/1 g p: 1 2 3 4\n"},
    {"Msh41SectionsTwice",
     {{"a.msh", v41 + nodes41 + tet41 +
                    "$Nodes\n1 1 9 9\n3 1 0 1\n9\n5 5 5\n$EndNodes\n"
                    "$Elements\n1 1 4 4\n3 2 4 1\n4 1 2 3 9\n$EndElements\n"}},
     "msh41\n" + n4 + "n 9 5 5 5\nN 3/1 4: \nN 3/1 1: \ne 1 4 3/1 g p: 1 2 3 4\ne 4 4 3/2 g p: 1 2 3 9\n"},
    {"Msh41RealsOfEveryKind",
     {{"a.msh",
       v41 +
           "$Nodes\n1 3 1 3\n3 1 0 3\n1\n2\n3\n-0 5e-324 0.1\n+1.5 1D3 NaN\n-inf 1e999 17.000000000000004\n"
           "$EndNodes\n" +
           none41}},
     "msh41\nn 1 -0 5e-324 0.1\nn 2 1.5 1000 nan\nn 3 -inf inf 17.000000000000004\nN 3/1 3: \n"},
    {"Msh41ParametricNodes",
     {{"a.msh", v41 +
                    "$Nodes\n4 4 1 4\n0 1 1 1\n1\n0 0 0\n1 2 1 1\n2\n1 0 0 0.5\n2 3 1 1\n3\n0 1 0 0.25 0.75\n"
                    "3 4 1 1\n4\n0 0 1 0.1 0.2 0.3\n$EndNodes\n" +
                    none41}},
     "msh41\n" + n4 + "N 0/1 1: \nN 1/2 1: 0.5\nN 2/3 1: 0.25 0.75\nN 3/4 1: 0.1 0.2 0.3\n"},
    {"Msh41EntitiesAndGroups",
     {{"a.msh",
       v41 +
           "$PhysicalNames\n3\n3 7 \"steel part\"\n2 5 \"a \"quoted\" name\"\n0 1 \"\"\n$EndPhysicalNames\n"
           "$Entities\n1 1 1 1\n1 0 0.5 1 2 1 -2\n4 0 0 0 1 0 0 0 2 1 -1\n"
           "2 0 0 0 1 1 0 1 -5 1 4\n1 0 0 0 1 1 1 2 7 8 1 -2\n$EndEntities\n" +
           nodes41 + tet41}},
     "msh41\nG 3 7 steel part\nG 2 5 a \"quoted\" name\nG 0 1 \nE 0/1 0 0.5 1 0 0.5 1 g1,-2 b\n"
     "E 1/4 0 0 0 1 0 0 g b1,-1\nE 2/2 0 0 0 1 1 0 g-5 b4\nE 3/1 0 0 0 1 1 1 g7,8 b-2\n" +
         n4 + "N 3/1 4: \ne 1 4 3/1 g7,8 p: 1 2 3 4\n"},
    {"Msh41PartitionedEntities",
     {{"a.msh", v41 +
                    "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 0 0\n$EndEntities\n"
                    "$PartitionedEntities\n2\n1\n7 1\n1 0 0 1\n5 3 1 2 1 2 0 0 0 1 9\n"
                    "2 3 1 1 2 0 0 0 1 1 1 1 6 1 5\n$EndPartitionedEntities\n" +
                    nodes41 + "$Elements\n1 1 1 1\n3 2 4 1\n1 1 2 3 4\n$EndElements\n"}},
     "msh41\nE 3/1 0 0 0 1 1 1 g b\nE 0/5 0 0 0 0 0 0 g9 b (3/1 p1,2)\nE 3/2 0 0 0 1 1 1 g6 b5 (3/1 "
     "p2)\nghost 7 1\n" +
         n4 + "N 3/1 4: \ne 1 4 3/2 g6 p2: 1 2 3 4\n"},
    {"Msh41OtherTypesAndAnUnknownOne",
     {{"a.msh", v41 + nodes41 +
                    "$Elements\n4 5 1 5\n2 1 2 1\n1 1 2 3\n0 2 15 1\n2 4\n3 1 999 2\n3 1 2 3\n4 1 2\n"
                    "1 1 1 1\n5 1 2\n$EndElements\n"}},
     "msh41\n" + n4 +
         "N 3/1 4: \ne 1 2 2/1 g p: 1 2 3\ne 2 15 0/2 g p: 4\ne 3 999 3/1 g p: 1 2 3\n"
         "e 4 999 3/1 g p: 1 2\ne 5 1 1/1 g p: 1 2\n"},
    {"Msh41OtherSectionsAreKept",
     {{"a.msh", v41 + nodes41 + tet41 +
                    "$NodeData\n1\n\"T\"\n1\n0\n3\n0\n1\n1\n2 0.1\n$EndNodeData\n"
                    "$Mine\n$EndMine2 is text\n$EndMine\n$Void\n$EndVoid\n"}},
     "msh41\n" + n4 +
         "N 3/1 4: \ne 1 4 3/1 g p: 1 2 3 4\nv nodes T 1 view 0 0 0 [] at 2: 0.1\n"
         "S Mine [$EndMine2 is text\n]\nS Void []\n"},
    {"Msh41TrailingBytes",
     {{"a.msh", v41 + nodes41 + tet41 + "garbage $"}},
     "msh41\n" + n4 + "N 3/1 4: \ne 1 4 3/1 g p: 1 2 3 4\n"},
    {"Msh41ANodeTwiceInTheSamePlace",
     {{"a.msh", v41 + "$Nodes\n1 3 1 2\n3 1 0 3\n1\n2\n1\n0 0 0\n1 0 0\n0 0 0\n$EndNodes\n"
                      "$Elements\n1 1 1 1\n1 1 1 1\n1 1 2\n$EndElements\n"}},
     "msh41\nn 1 0 0 0\nn 2 1 0 0\nn 1 0 0 0\nN 3/1 3: \ne 1 1 1/1 g p: 1 2\n",
     {"a.msh: node 1 is given twice with the same coordinates (the first such)"}},
    {"Msh41AnElementTagTwice",
     {{"a.msh",
       v41 + nodes41 + "$Elements\n1 3 1 2\n3 1 4 3\n2 1 2 3 4\n1 1 2 3 4\n2 1 2 3 4\n$EndElements\n"}},
     "msh41\n" + n4 + "N 3/1 4: \ne 2 4 3/1 g p: 1 2 3 4\ne 1 4 3/1 g p: 1 2 3 4\ne 2 4 3/1 g p: 1 2 3 4\n",
     {"a.msh: several elements have the tag 2 (the first such)"}},
    {"Msh41NegativeTagsAsGmshWritesThem",
     {{"a.msh", v41 + nodes41 +
                    "$Elements\n1 1 18446744073709551615 18446744073709551615\n3 1 4 1\n"
                    "18446744073709551615 1 2 3 18446744073709551614\n$EndElements\n"}},
     "msh41\n" + n4 + "N 3/1 4: \ne -1 4 3/1 g p: 1 2 3 ?-2\n"},

    {"Msh22Smallest", {{"a.msh", v22 + nodes22 + tet22}}, "msh22\n" + n4 + "e 1 4 3/1 g p: 1 2 3 4\n"},
    {"Msh2WithoutItsMinor",
     {{"a.msh", "$MeshFormat\n2 0 8\n$EndMeshFormat\n" + nodes22 + tet22}},
     "msh22\n" + n4 + "e 1 4 3/1 g p: 1 2 3 4\n"},
    {"Msh22NoOneTwoAndMoreTags",
     {{"a.msh", v22 + nodes22 +
                    "$Elements\n6\n1 4 0 1 2 3 4\n2 4 1 7 1 2 3 4\n3 4 2 7 5 1 2 3 4\n"
                    "4 4 4 -7 5 1 2 1 2 3 4\n5 4 6 7 5 3 2 -1 -3 1 2 3 4\n6 15 3 0 5 0 4\n$EndElements\n"}},
     "msh22\n" + n4 +
         "e 1 4 3/0 g p: 1 2 3 4\ne 2 4 3/0 g7 p: 1 2 3 4\ne 3 4 3/5 g7 p: 1 2 3 4\n"
         "e 4 4 3/5 g-7 p2: 1 2 3 4\ne 5 4 3/5 g7 p2: 1 2 3 4\ne 6 15 0/5 g p: 4\n"
         "ghost element 5 2: 1 3\n"},
    {"Msh20ThirdTagIsThePartition",
     {{"a.msh", "$MeshFormat\n2.0 0 8\n$EndMeshFormat\n" + nodes22 +
                    "$Elements\n1\n1 4 3 7 5 2 1 2 3 4\n$EndElements\n"}},
     "msh22\n" + n4 + "e 1 4 3/5 g7 p2: 1 2 3 4\n"},
    {"Msh22AnElementOncePerGroup",
     {{"a.msh", v22 + nodes22 +
                    "$Elements\n6\n1 4 2 7 1 1 2 3 4\n2 4 2 8 1 1 2 3 4\n3 4 2 9 1 1 2 3 4\n"
                    "4 4 2 7 1 1 2 4 3\n5 4 2 7 1 1 2 4 3\n6 4 2 8 2 1 2 4 3\n$EndElements\n"}},
     "msh22\n" + n4 +
         "e 1 4 3/1 g7,8,9 p: 1 2 3 4\ne 4 4 3/1 g7 p: 1 2 4 3\ne 5 4 3/1 g7 p: 1 2 4 3\n"
         "e 6 4 3/2 g8 p: 1 2 4 3\n",
     {"a.msh: 2 elements repeat another one in a further physical group and are merged with it; the first is "
      "element 2, which repeats element 1"}},
    {"Msh22UnknownTypeAndNode",
     {{"a.msh", v22 + nodes22 + "$Elements\n2\n10 999 2 0 1 1 2\n11 2 2 0 1 1 2 77\n$EndElements\n"}},
     "msh22\n" + n4 + "e 10 999 3/1 g p: 1 2\ne 11 2 2/1 g p: 1 2 ?77\n"},
    {"Msh22ParametricNodes",
     {{"a.msh", v22 +
                    "$ParametricNodes\n4\n1 0 0 0 0 1\n2 1 0 0 1 2 0.5\n3 0 1 0 2 3 0.25 0.75\n4 0 0 1 3 4\n"
                    "$EndParametricNodes\n" +
                    tet22}},
     "msh22\n" + n4 + "N 0/1 1: \nN 1/2 1: 0.5\nN 2/3 1: 0.25 0.75\nN 3/4 1: \ne 1 4 3/1 g p: 1 2 3 4\n"},
    {"Msh22PeriodicOfNothing",
     {{"a.msh", v22 + nodes22 + tet22 + "$Periodic\n0\n$EndPeriodic\n"}},
     "msh22\n" + n4 + "e 1 4 3/1 g p: 1 2 3 4\n"},

    {"TetgenSmallest",
     {{"a.node", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"}, {"a.ele", "1 4 0\n1 1 2 3 4\n"}},
     "tetgen\n" + n4 + "e 1 4 3/0 g p: 1 2 3 4\n"},
    {"TetgenFromTheElements",
     {{"a.1.ele", "1 4 0\n1 1 2 3 4\n"}, {"a.1.node", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"}},
     "tetgen\n" + n4 + "e 1 4 3/0 g p: 1 2 3 4\n"},
    {"TetgenFromZeroWithShortHeaders",
     {{"a.node", "4\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n"}, {"a.ele", "1\n0 0 1 2 3\n"}},
     "tetgen\nn 0 0 0 0\nn 1 1 0 0\nn 2 0 1 0\nn 3 0 0 1\ne 0 4 3/0 g p: 0 1 2 3\n"},
    {"TetgenCommentsCommasCarriageReturnsNoLastLineEnd",
     {{"a.node",
       "# by hand\r\n\r\n  4,3,0,0# header\r\n1,0,0,0\r\n# between\r\n2\t1 0 0\r\n3 , 0,1 , 0\r\n4 0 0 "
       "1#last"},
      {"a.ele", "\n1, 4\n 1 1,2,3,4"}},
     "tetgen\n" + n4 + "e 1 4 3/0 g p: 1 2 3 4\n"},
    {"TetgenAttributesMarkersMissingOnesAndExtraColumns",
     {{"a.node", "4 3 2 1\n1 0 0 0 0.5 -2 9\n2 1 0 0 1e-3\n3 0 1 0\n4 0 0 1 1 2 -3 77 78\n"},
      {"a.ele", "2 4 1\n1 1 2 3 4 2.25\n2 1 2 3 4\n"}},
     "tetgen\n" + n4 +
         "e 1 4 3/0 g p: 1 2 3 4\ne 2 4 3/0 g p: 1 2 3 4\nv nodes attributes 2: 0.5 -2 0.001 0 0 0 1 2\n"
         "v nodes markers 1: 9 0 0 -3\nv elements attributes 1: 2.25 0\n"},
    {"TetgenIntegersAsCReadsThem",
     {{"a.node", "4 3\n0x1 0 0 0\n2 1 0 0\n03 010 1 0\n4 0 0 1\n"}, {"a.ele", "1 4\n1 1 2 3 010\n"}},
     "tetgen\nn 1 0 0 0\nn 2 1 0 0\nn 3 10 1 0\nn 4 0 0 1\ne 1 4 3/0 g p: 1 2 3 ?8\n",
     {"a.node:2: 0x1 is 1 to TetGen, which reads integers as C does (the first such)",
      "a.ele:2: 010 is 8 to TetGen, which reads integers as C does (the first such)"}},
    {"TetgenNodesThatDoNotExist",
     {{"a.node", "4 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 nan 0 1\n"}, {"a.ele", "1 4\n1 0 -1 5 4\n"}},
     "tetgen\nn 1 0 0 0\nn 2 1 0 0\nn 3 0 1 0\nn 4 nan 0 1\ne 1 4 3/0 g p: ?0 ?-1 ?5 4\n"},
    {"TetgenSecondOrder",
     {{"a.node",
       "10 3\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n4 .5 0 0\n5 .5 .5 0\n6 0 .5 0\n7 0 0 .5\n8 0 .5 .5\n9 .5 0 "
       ".5\n"},
      // TetGen's mid-edge nodes are on the edges 23, 03, 01, 12, 13, 02, Gmsh's on 01, 12, 02, 03, 23, 13.
      {"a.ele", "1 10\n0 0 1 2 3 8 7 4 5 9 6\n"}},
     "tetgen\nn 0 0 0 0\nn 1 1 0 0\nn 2 0 1 0\nn 3 0 0 1\nn 4 0.5 0 0\nn 5 0.5 0.5 0\nn 6 0 0.5 0\nn 7 0 0 "
     "0.5\n"
     "n 8 0 0.5 0.5\nn 9 0.5 0 0.5\ne 0 11 3/0 g p: 0 1 2 3 4 5 6 7 8 9\n"},
    {"TetgenNodesAlone",
     {{"a.node", "1 3\n1 5 6 7\n"}},
     "tetgen\nn 1 5 6 7\n",
     {"a.node: there is no a.ele beside it: nodes only"}},
    {"TetgenElementNumbersOutOfOrder",
     {{"a.node", "4 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"}, {"a.ele", "2 4\n7 1 2 3 4\n3 1 2 4 3\n"}},
     "tetgen\n" + n4 + "e 7 4 3/0 g p: 1 2 3 4\ne 3 4 3/0 g p: 1 2 4 3\n",
     {"a.ele:2: tetrahedron 7 stands where tetrahedron 1 is due; TetGen goes by the order of the lines (the "
      "first such)"}},

    {"Surface",
     {{"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"}},
     "off\nn 0 0 0 0\nn 1 1 0 0\nn 2 0 1 0\ne 1 2 2/0 g p: 0 1 2\n"},
    {"MshByItsContent",
     {{"a.mesh1", v41 + nodes41 + tet41}},
     "msh41\n" + n4 + "N 3/1 4: \ne 1 4 3/1 g p: 1 2 3 4\n"},
    {"MshInCapitals", {{"A.MSH", v22 + nodes22 + tet22}}, "msh22\n" + n4 + "e 1 4 3/1 g p: 1 2 3 4\n"},
};

class MeshRead : public testing::TestWithParam<Case> {};

TEST_P(MeshRead, SaysWhatTheFileSays) {
  const test::TestFiles files;
  for (const auto& [name, bytes] : GetParam().files) files.write(name, bytes);
  const Document document = read_document(files.path(GetParam().files[0].first));
  EXPECT_EQ(test::text_of(document), GetParam().expected);
  std::vector<std::string> warnings;
  const std::string folder = files.path("");
  for (std::string warning : document.warnings) {
    for (std::size_t at; (at = warning.find(folder)) != warning.npos;) warning.erase(at, folder.size());
    warnings.push_back(warning);
  }
  EXPECT_EQ(warnings, GetParam().warnings);
}

INSTANTIATE_TEST_SUITE_P(ByHand, MeshRead, testing::ValuesIn(cases),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace tetproof
