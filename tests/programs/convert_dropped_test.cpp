// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader drops is shown by tetproof-convert: in its lines, in its JSON, by --info, and by --strict.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using Json = nlohmann::json;

/// Files; the first one is converted with --strict. It must be refused because of `item`. If `item` is empty,
/// it must be converted, and converting back must give it again.
struct Sample {
  std::string name;
  std::vector<std::pair<std::string, std::string>> files;
  std::string out, item;

  friend void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.name; }
};

const std::string vtk_head =
    "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
    "0 0 0 1 0 0 0 1 0 0 0 1\n";
const std::string medit_head =
    "MeshVersionFormatted 2\n\nDimension 3\n\nVertices\n7\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 0 1 0\n0 1 "
    "1 0\n"
    "0 0 2 0\n\n";
const std::string tetrahedron = "Tetrahedra\n1\n4 5 6 7 2\n\n";
const std::string node = "4 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n", ele = "1 4\n1 1 2 3 4\n";

std::string vtu(const std::string& nodes, const std::string& points, const char* type,
                const std::string& data = "") {
  const auto count = [](const std::string& text) {
    return std::to_string(std::count(text.begin(), text.end(), ' ') + 1);
  };
  return "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\"><UnstructuredGrid>"
         "<Piece NumberOfPoints=\"" +
         std::to_string(std::stoi(count(points)) / 3) +
         "\" NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
         "format=\"ascii\">" +
         points +
         "</DataArray></Points><Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" +
         nodes + "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" + count(nodes) +
         "</DataArray><DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">" + type +
         "</DataArray></Cells>" + data + "</Piece></UnstructuredGrid></VTKFile>";
}

std::string array(const char* name, const char* value) {
  return std::string("<DataArray type=\"Int32\" Name=\"") + name + "\" format=\"ascii\">" + value +
         "</DataArray>";
}

// A .meshb of version 2: a vertex, and two numbers under the keyword `code`.
std::string meshb(int code) {
  std::string bytes;
  const auto number = [&](std::int32_t value) {
    for (int k = 0; k < 4; ++k) bytes += static_cast<char>(static_cast<std::uint32_t>(value) >> 8 * k & 255);
  };
  for (const std::int32_t value : {1, 2, 3, 20, 3, 4, 60, 1, 0, 0, 0, 0, 0, 0, 0, code, 76, 1, 1, 54, 0})
    number(value);
  return bytes;
}

const std::vector<Sample> samples{
    {"Drop",
     {{"a.vtk", vtk_head + "CELLS 2 10\n4 0 1 2 3\n4 0 1 2 3\nCELL_TYPES 2\n10\n79\n"}},
     "b.msh",
     "cells of type 79 (Bezier hexahedron)"},
    {"Lagrange3",
     {{"a.vtu", vtu("0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19",
                    "0 0 0 3 0 0 0 3 0 0 0 3 1 0 0 2 0 0 2 1 0 1 2 0 0 2 0 0 1 0 0 0 1 0 0 2 2 0 1 1 0 2 0 2 "
                    "1 0 1 2 1 0 "
                    "1 1 1 1 0 1 1 1 1 0",
                    "71")}},
     "b.msh",
     ""},
    {"Req", {{"a.mesh", medit_head + tetrahedron + "End\n"}}, "b.meshb", ""},
    {"ReqBinary", {{"a.meshb", meshb(12)}}, "b.mesh", ""},
    {"UnknownBinary", {{"a.meshb", meshb(11)}}, "b.mesh", "keyword of code 11"},
    {"RequiredVerticesInBinary", {{"a.meshb", meshb(15)}}, "b.mesh", ""},
    {"Marks",
     {{"a.mesh", medit_head + "Edges\n2\n1 2 0\n2 3 0\n\n" + tetrahedron +
                     "RequiredVertices\n1\n2\n\nCorners\n1\n3\n\nRequiredEdges\n1\n1\n\nRidges\n1\n2\n\nNorma"
                     "ls\n1\n0 0 "
                     "1\n\nMine\n3 4\n\nEnd\n"}},
     "b.mesh",
     ""},
    {"Penta",
     {{"a.mesh", medit_head + tetrahedron + "Pentahedra\n1\n1 2 3 4 5 6 1\n\nEnd\n"}},
     "b.meshb",
     ""},
    {"TwoCellData",
     {{"a.vtu",
       vtu("0 1 2 3", "0 0 0 1 0 0 0 1 0 0 0 1", "10",
           "<CellData>" + array("a", "1") + "</CellData><CellData>" + array("b", "2") + "</CellData>")}},
     "b.vtk",
     ""},
    {"Polyline",
     {{"a.vtk",
       "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n0 0 0 1 0 0 1 1 0 0 1 0\n"
       "LINES 1 5\n4 0 1 2 3\nCELL_DATA 1\nSCALARS id int 1\nLOOKUP_TABLE default\n5\n"}},
     "b.vtk",
     ""},
    {"ArraysOfOneKind",
     {{"a.vtk", vtk_head + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nCELL_DATA 1\nVECTORS v double\n1 2 3\n"
                           "SCALARS s double\nLOOKUP_TABLE default\n0.5\n"}},
     "b.vtk",
     ""},
    {"Roles",
     {{"a.vtk", vtk_head + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nCELL_DATA 1\nVECTORS v double\n1 2 3\n"
                           "FIELD FieldData 1\nw 3 1 double\n4 5 6\n"}},
     "b.vtk",
     ""},
    {"UnknownAttribute",
     {{"a.vtu", vtu("0 1 2 3", "0 0 0 1 0 0 0 1 0 0 0 1", "10", "<CellData Mood=\"blue\"></CellData>")}},
     "b.vtk",
     "attribute Mood of <CellData>"},
    {"ExtraColumns",
     {{"a.node", "1 3\n1 0 0 0 77\n"}},
     "b.msh",
     "words behind those that are read in a line"},
    {"FilesOfTheSet",
     {{"a.node", node}, {"a.neigh", "1 4\n1 -1 -1 -1 -1\n"}},
     "b.msh",
     "files of the set that are not read"},
    {"TheWholeSet", {{"a.node", node}, {"a.ele", ele}, {"a.neigh", "1 4\n1 -1 -1 -1 -1\n"}}, "b.msh", ""},
    {"BytesBehindTheLastSection",
     {{"a.msh",
       "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 15 2 0 1 1\n"
       "$EndElements\nmore\n"}},
     "b.msh",
     "bytes behind the last section"},
};

class ConvertDropped : public testing::TestWithParam<Sample> {};

TEST_P(ConvertDropped, StrictlyNothing) {
  const Sample& sample = GetParam();
  const ScratchFolder folder;
  for (const auto& [name, bytes] : sample.files) folder.write(name, bytes);
  const auto before = folder.names();
  const std::string in = sample.files[0].first;
  const auto convert = [&](const std::vector<std::string>& words) {
    std::vector<std::string> command{program("tetproof-convert")};
    command.insert(command.end(), words.begin(), words.end());
    return run_program(command, {.directory = folder / ""});
  };
  const Outcome strict = convert({in, sample.out, "--strict", "--json", "-"});
  const auto dropped = Json::parse(strict.out)["dropped"];
  if (sample.item.empty()) {
    EXPECT_EQ(strict.exit_code, 0) << strict;
    EXPECT_EQ(dropped, Json::array());
    // Converted back to its own format, the file says as much of the mesh as the original.
    const std::string ending = in.substr(1), back = "back" + ending;
    EXPECT_EQ(convert({sample.out, back, "--strict"}).exit_code, 0);
    const Outcome first = convert({"--info", in, "--json", "-"}),
                  again = convert({"--info", back, "--json", "-"});
    Json of_first = Json::parse(first.out)["input"], of_again = Json::parse(again.out)["input"];
    for (Json* json : {&of_first, &of_again})
      for (const char* key : {"file", "warnings"}) json->erase(key);  // these contain the file's name
    EXPECT_EQ(of_first, of_again);
    return;
  }
  EXPECT_EQ(strict.exit_code, 1) << strict;
  EXPECT_EQ(folder.names(), before);
  const std::string line = "not read: " + sample.item + ": ";
  EXPECT_NE(strict.err.find(line), std::string::npos) << strict;
  EXPECT_NE(strict.err.find(sample.out + ": not written, since s"), std::string::npos) << strict;
  EXPECT_NE(strict.err.find("read"), std::string::npos) << strict;
  const auto names_it = [&](const Json& list) {
    return std::any_of(list.begin(), list.end(), [&](const Json& loss) {
      return loss["item"] == sample.item && loss["count"] > 0 && !loss["example"].get<std::string>().empty();
    });
  };
  EXPECT_TRUE(names_it(dropped)) << strict;

  // Without --strict the file is written, with the same list.
  const Outcome run = convert({in, sample.out, "--losses", "lost.json"});
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_NE(run.err.find(line), std::string::npos) << run;
  const auto lost = Json::parse(folder.read("lost.json"));
  EXPECT_EQ(lost["dropped"], dropped);
  EXPECT_TRUE(lost.contains("losses") && lost.contains("kept_aside"));
  const Outcome info = convert({"--info", in});
  EXPECT_EQ(info.exit_code, 0) << info;
  EXPECT_NE(info.out.find(" " + sample.item + ", not read ("), std::string::npos) << info;
}

INSTANTIATE_TEST_SUITE_P(Samples, ConvertDropped, testing::ValuesIn(samples),
                         [](const auto& test) { return test.param.name; });

TEST(ConvertDropped, NamesInFilesStayInTheirLine) {
  const ScratchFolder folder;
  folder.write("a.vtu", vtu("0 1 2 3", "0 0 0 1 0 0 0 1 0 0 0 1", "10",
                            "<CellData Scalars=\"a&#10;b&#27;[31m\">" + array("a", "1") + "</CellData>"));
  const Outcome run =
      run_program({program("tetproof-convert"), "a.vtu", "b.vtk", "--strict"}, {.directory = folder / ""});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err,
            "not read: attribute roles of values: 1 (\"a\\x0Ab\\x1B[31m\" as Scalars)\n"
            "b.vtk: not written, since something of a.vtu is not read (--strict)\n");
}

}  // namespace
}  // namespace tetproof::test
