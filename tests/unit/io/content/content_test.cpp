// SPDX-License-Identifier: GPL-3.0-or-later
// Files with a wrong ending or none, standard input, and files of formats that are not read.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "tests/support/cube_files.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

// Endings of the formats that are recognised by content, and how messages call such a file.
const std::vector<std::pair<std::string, std::string>> recognised{{".msh", "a Gmsh .msh 2.2 file"},
                                                                  {".vtk", "a legacy VTK file"},
                                                                  {".vtu", "a VTK XML file"},
                                                                  {".mesh", "a Medit .mesh file"},
                                                                  {".off", "an OFF file"},
                                                                  {".obj", "a Wavefront OBJ file"},
                                                                  {".ply", "a PLY file"}};

std::string cube(const std::string& ending) {
  return test::cube_file(ending, test::cube_faces(3));
}

// The warnings without the folder's name.
std::vector<std::string> warnings(const test::TestFiles& files, std::vector<std::string> all) {
  for (std::string& warning : all)
    if (warning.starts_with(files.path(""))) warning = warning.substr(files.path("").size());
  return all;
}

TEST(Content, WinsOverAnEndingOfAnotherFormat) {
  const test::TestFiles files;
  for (const auto& [ending, what] : recognised)
    for (const std::string lie : {".msh", ".mesh", ".vtk", ".vtu", ".stl", ".off", ".obj", ".ply", ".node",
                                  ".poly", ".step", ".dat"}) {
      if (lie == ending) continue;
      SCOPED_TRACE(ending + " called " + lie);
      const std::string path = files.write("a" + lie, cube(ending));
      const std::vector<std::string> expected{"a" + lie + ": " + what +
                                              " by its content, though its name ends in " + lie};
      const SurfaceFile surface = read_surface_file(path);
      EXPECT_EQ(surface.surface.triangles.size(), 12u);
      EXPECT_EQ(warnings(files, surface.warnings), expected);
      EXPECT_EQ(warnings(files, read_document(path).warnings), expected);
    }
}

TEST(Content, ThatOverrulesTheEndingIsNamedInErrors) {
  const test::TestFiles files;
  const std::string note = " because of its content, though its name ends in .mesh)";
  const std::string gmsh =
      files.write("x.mesh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 zero\n");
  const std::string of_gmsh = "x.mesh:6: expected a coordinate, found 'zero' (read as a Gmsh .msh 2.2 file";
  EXPECT_EQ(files.message([&] { read_document(gmsh); }), of_gmsh + note);
  EXPECT_EQ(files.message([&] { read_surface(gmsh); }), of_gmsh + note);
  // What is no surface is a fault of the format that was read, too.
  const std::string edge = files.write("y.mesh", "OFF 2 1 0\n0 0 0\n1 0 0\n2 0 1\n");
  const std::string message = files.message([&] { read_surface(edge); });
  EXPECT_TRUE(message.ends_with(" (read as an OFF file" + note)) << message;
  // An ending that agrees, or says nothing, needs no note.
  files.write("z.off", "OFF 1 0 0\n0 0 zero\n");
  files.write("z", "OFF 1 0 0\n0 0 zero\n");
  EXPECT_EQ(files.message([&] { read_document(files.path("z.off")); }),
            "z.off:2: expected a coordinate, found 'zero'");
  EXPECT_EQ(files.message([&] { read_document(files.path("z")); }),
            "z:2: expected a coordinate, found 'zero'");
}

TEST(Content, DecidesWhereTheEndingSaysNothing) {
  const test::TestFiles files;
  for (const auto& [ending, what] : recognised)
    for (const std::string name : {"a", "a.surf", "a.", "stl"}) {
      SCOPED_TRACE(ending + " called " + name);
      const std::string path = files.write(name, cube(ending));
      const SurfaceFile surface = read_surface_file(path);
      EXPECT_EQ(surface.surface.triangles.size(), 12u);
      EXPECT_EQ(surface.warnings, std::vector<std::string>{});
      EXPECT_EQ(read_document(path).points.size(), 8u);
    }
}

TEST(Content, RecognisesEveryVersionAndForm) {
  const test::TestFiles files;
  const std::string binary_medit("\1\0\0\0\2\0\0\0\3\0\0\0\x14\0\0\0\3\0\0\0\x36\0\0\0\0\0\0\0", 28);
  std::string binary_stl(84 + 50, '\0');
  binary_stl[80] = 1;
  const std::vector<std::pair<std::string, std::string>> cases{
      {"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n0 0 0 0\n$EndNodes\n$Elements\n0 0 0 0\n$EndElements\n",
       "msh41"},
      {"$MeshFormat\n4 0 8\n$EndMeshFormat\n$Nodes\n0 0\n$EndNodes\n$Elements\n0 0\n$EndElements\n", "msh40"},
      {"$Comments\nx\n$EndComments\n$MeshFormat\n2.2 0 "
       "8\n$EndMeshFormat\n$Nodes\n0\n$EndNodes\n$Elements\n0\n$EndElements\n",
       "msh22"},
      {"$NOD\n0\n$ENDNOD\n$ELM\n0\n$ENDELM\n", "msh1"},
      {"\xEF\xBB\xBFOFF 0 0 0\n", "off"},
      {"# a comment\nOFF0 0 0\n", "off"},
      {"# vtk DataFile Version 3.0\nOFF\n0 0 0\n", "off"},  // VTK's third line is ASCII or BINARY
      {"# vtk DataFile Version 3.0\n# title\n# ASCII\nv 1 2 3\n", "obj"},
      {"# vtk DataFile Version 3.0\nby hand\n", "no format"},
      {"# VTK datafile version 2.0\r\nby hand\r\n \tAscii\r\nDATASET UNSTRUCTURED_GRID\r\nPOINTS 0 float\r\n",
       "vtk"},
      {"# vtk DataFile Version 2.0\n\n\nbinary\nDATASET UNSTRUCTURED_GRID\nPOINTS 0 float\n", "vtk"},
      {"STCNOFF\n0 0 0\n", "off"},
      {"solid x\n facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
       "0\nendloop\nendfacet\n",
       "stl"},
      {"solid\nendsolid\n", "stl"},
      {binary_stl, "stl"},
      {"# Blender\nmtllib a.mtl\no Cube\nv 1 2 3\n", "obj"},
      {"o Cube\nusemtl x\n", "no format"},     // without a point the content is not certain
      {"v 1 2 3\nsome words\n", "no format"},  // a statement that OBJ does not have
      {"<?xml version=\"1.0\"?>\n<!-- by hand -->\n<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>"
       "</UnstructuredGrid></VTKFile>",
       "a.unknown:3: expected <Piece>"},
      {"\n MeshVersionFormatted 1\nDimension 3\nVertices\n0\nEnd\n", "medit"},
      {binary_medit, "a.unknown: byte 28: expected Vertices, found the end of the file"},
      {"4 3 0 0\n1 0 0 0\n", "no format"},  // TetGen's files are not recognised
      {"8 12 0\n0 0 0\n", "no format"},     // an OFF without its keyword is not, either
      {"", "no format"},
  };
  for (const auto& [bytes, format] : cases) {
    std::string found;
    const std::string path = files.write("a.unknown", bytes);
    const std::string message = files.message([&] { found = read_document(path).format; });
    if (found.empty())
      found = message.find("the content tells no format") != message.npos ? "no format" : message;
    EXPECT_EQ(found, format) << bytes << "\n" << message;
  }
}

TEST(Content, TheOptionOverrulesContentAndEnding) {
  const test::TestFiles files;
  const std::string path = files.write("a.obj", cube(".off"));
  EXPECT_EQ(read_surface(path, {.format = "off"}).triangles.size(), 12u);
  EXPECT_EQ(read_surface_file(path, {.format = "off"}).warnings, std::vector<std::string>{});
  EXPECT_EQ(read_document(path, {.format = "off"}).format, "off");
  EXPECT_EQ(files.message([&] { read_document(path, {.format = "ply"}); }),
            "a.obj:1: expected 'ply', found 'OFF'");
  EXPECT_EQ(files.message([&] { read_document(path, {.format = "nas"}); }),
            "unknown format 'nas', expected one of msh41 msh40 msh22 tetgen poly smesh vtu vtk medit stl off "
            "obj ply");
  // Files that only the reader of their format can recognise.
  EXPECT_EQ(read_surface(files.write("b.txt", cube(".poly")), {.format = "poly"}).triangles.size(), 12u);
  EXPECT_EQ(read_surface(files.write("b", cube(".smesh")), {.format = "smesh"}).triangles.size(), 12u);
  const std::string text = cube(".off");
  EXPECT_EQ(read_surface(files.write("c.node", text.substr(4)), {.format = "off"}).triangles.size(), 12u);
  EXPECT_EQ(files.message([&] { read_document(files.write("c.txt", ""), {.format = "tetgen"}); }),
            "c.txt: TetGen's files are known by their endings, expected one of .node .ele .face .edge .neigh "
            ".vol .mtr .var .t2f .t2e .f2e .cell");
}

// While an object of this class lives, standard input is this file, or a pipe with these bytes.
class StandardInput {
 public:
  explicit StandardInput(const std::string& path) : before_(::dup(STDIN_FILENO)) {
    replace(::open(path.c_str(), O_RDONLY));
  }
  StandardInput(const std::string& bytes, bool) : before_(::dup(STDIN_FILENO)) {
    int ends[2];
    if (::pipe(ends) != 0 ||
        ::write(ends[1], bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
      throw std::runtime_error("no pipe");
    ::close(ends[1]);
    replace(ends[0]);
  }
  ~StandardInput() { replace(before_); }

 private:
  static void replace(int descriptor) {
    ::dup2(descriptor, STDIN_FILENO);
    ::close(descriptor);
  }
  int before_;
};

TEST(StandardInputs, AreReadByContentOrByTheOption) {
  const test::TestFiles files;
  for (const auto& [ending, what] : recognised) {
    SCOPED_TRACE(ending);
    {
      const StandardInput input(files.write("a", cube(ending)));
      EXPECT_EQ(read_surface("-").triangles.size(), 12u);
    }
    const StandardInput input(cube(ending), true);
    const Document document = read_document("-");
    EXPECT_EQ(document.points.size(), 8u);
    EXPECT_EQ(document.path, "standard input");
    EXPECT_EQ(document.warnings, std::vector<std::string>{});
  }
  for (const std::string format : {"poly", "smesh"}) {
    const StandardInput input(cube("." + format), true);
    EXPECT_EQ(read_surface("-", {.format = format}).triangles.size(), 12u);
  }
}

// Not even files without a name.
TEST(StandardInputs, HaveNoFilesBesideThem) {
  const test::TestFiles files;
  const std::string head = "MeshVersionFormatted 2\nDimension 3\n";
  files.write(".sol", head + "SolAtVertices 1 1 1\n7\nEnd\n");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(std::filesystem::path(files.path(".sol")).parent_path());
  const StandardInput input(head + "Vertices 1\n0 0 0 0\nEnd\n", true);
  const Document document = read_document("-");
  std::filesystem::current_path(before);
  EXPECT_EQ(document.points.size(), 1u);
  EXPECT_TRUE(document.node_values.empty());
}

TEST(StandardInputs, HaveOneLineForWhatIsWrong) {
  const test::TestFiles files;
  const auto message = [&](const std::string& bytes, const std::string& format) {
    const StandardInput input(bytes, true);
    return files.message([&] { read_document("-", {.format = format}); });
  };
  EXPECT_EQ(message("OFF\n1 0 0\n0 0 x\n", ""), "standard input:3: expected a coordinate, found 'x'");
  EXPECT_EQ(message("0 3\n1\n1\n3 1 2 3\n0\n", "poly"),
            "standard input:1: expected points here, found none; a .node file beside it cannot come through "
            "standard input");
  EXPECT_EQ(
      message("4 3 0 0\n", "tetgen"),
      "standard input: TetGen's mesh is several files, of which standard input can be only one; name the "
      ".node or .ele");
  EXPECT_EQ(
      message("hello\n", ""),
      "standard input: the content tells no format; expected one of .msh .node .ele .face .edge .neigh .vol "
      ".mtr .var .t2f .t2e .f2e .cell .poly .smesh .vtu .vtk .mesh .meshb .stl .off .obj .ply");
  EXPECT_EQ(message("\x1f\x8b\b", ""), "standard input: a gzip archive, which is not read; unpack it first");
}

struct Foreign {
  std::string name, file, bytes, message;
  friend void PrintTo(const Foreign& test, std::ostream* out) { *out << test.name; }
};

class ForeignFormats : public testing::TestWithParam<Foreign> {};

TEST_P(ForeignFormats, AreRefusedByName) {
  const test::TestFiles files;
  const std::string path = files.write(GetParam().file, GetParam().bytes);
  EXPECT_EQ(files.message([&] { read_document(path); }), GetParam().file + ": " + GetParam().message);
  EXPECT_EQ(files.message([&] { read_surface(path); }), GetParam().file + ": " + GetParam().message);
}

const std::string convert = ", which is not read; convert it to .vtk or .msh first";
const std::string unpack = ", which is not read; unpack it first";
const std::string wanted = ", which is not read; expected a mesh or a surface";
INSTANTIATE_TEST_SUITE_P(
    All, ForeignFormats,
    testing::Values(
        Foreign{"Mfem", "x.mesh", "MFEM mesh v1.0\n\ndimension\n3\n", "an MFEM mesh" + convert},
        Foreign{"MfemNc", "x.mesh", "MFEM NC mesh v1.0\n", "an MFEM mesh" + convert},
        Foreign{"FreeFem", "x.msh", "4 2 4\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n1 2 3 0\n",
                "a FreeFem mesh" + convert},
        Foreign{"FluentCase", "x.cas", "(0 \"grid written by GAMBIT\")\n(2 3)\n", "a Fluent mesh" + convert},
        Foreign{"Fluent", "x.msh", "(1 \"TGrid 3D\")\n\n(10 (0 1 d5 0 3))\n", "a Fluent mesh" + convert},
        Foreign{"FluentNoComment", "x.msh", "(10 (0 1 d5 0 3))\n", "a Fluent mesh" + convert},
        Foreign{"Netgen", "x.vol", "mesh3d\ndimension\n3\n", "a Netgen mesh" + convert},
        Foreign{"Gzip", "x.vtk", std::string("\x1f\x8b\b\0", 4), "a gzip archive" + unpack},
        Foreign{"Zip", "x.stl", "PK\x03\x04 3D manufacturing format", "a zip archive" + unpack},
        Foreign{"Bzip2", "x.ply", "BZh91AY&SY", "a bzip2 archive" + unpack},
        Foreign{"Xz", "x.obj",
                std::string("\xfd"
                            "7zXZ\0",
                            6),
                "an xz archive" + unpack},
        Foreign{"Zstd", "x.off", "\x28\xb5\x2f\xfd", "a zstd archive" + unpack},
        Foreign{"SevenZip", "x", "7z\xbc\xaf\x27\x1c", "a 7z archive" + unpack},
        Foreign{"Html", "x.stl", "\n<!DOCTYPE HTML>\n<html>", "an HTML page" + wanted},
        Foreign{"HtmlBare", "x.obj", "<html lang=\"en\">", "an HTML page" + wanted},
        Foreign{"Xhtml", "x.vtu", "<?xml version=\"1.0\"?><!-- x --><!doctype html>",
                "an HTML page" + wanted},
        Foreign{"Pdf", "x.mesh", "%PDF-1.4\n", "a PDF document" + wanted},
        Foreign{"Png", "x.stl", "\x89PNG\r\n", "a PNG picture" + wanted},
        Foreign{"Hdf5", "x.msh", "\x89HDF\r\n\x1a\n", "an HDF5 file" + convert},
        Foreign{"NetCdf", "x.e", "CDF\x01", "a netCDF file" + convert},
        Foreign{"NetCdf64", "x.e", "CDF\x02", "a netCDF file" + convert},
        Foreign{"Gltf", "x.glb", "glTF\2",
                "a glTF scene, which is not read; convert it to .ply or .obj first"},
        Foreign{"Xdmf", "x.xmf", "<?xml version=\"1.0\" ?>\n<Xdmf Version=\"3.0\">",
                "an XDMF file" + convert},
        Foreign{"Dolfin", "x.xml", "<?xml version=\"1.0\"?>\n<dolfin xmlns:dolfin=\"x\">",
                "a DOLFIN mesh" + convert},
        Foreign{"GitLfs", "x.stl", "version https://git-lfs.github.com/spec/v1\noid sha256:0\n",
                "a pointer of Git LFS, which is not read; fetch the file itself (git lfs pull)"},
        Foreign{"GiD", "x.msh", "MESH dimension 3 ElemType Tetrahedra Nnode 4\n", "a GiD mesh" + convert},
        Foreign{"Abaqus", "x.inp", "*HEADING\nby hand\n*NODE\n1, 0, 0, 0\n",
                "an Abaqus input file" + convert},
        Foreign{"AbaqusNodes", "x.inp", "*Node, nset=all\n1, 0, 0, 0\n", "an Abaqus input file" + convert},
        Foreign{"LsDyna", "x.k", "*KEYWORD\n*NODE\n", "an LS-DYNA input file" + convert},
        Foreign{"Ansys", "x.cdb", "/COM,ANSYS RELEASE 12\n/PREP7\n", "an ANSYS input file" + convert},
        Foreign{"Step", "x.p21", "ISO-10303-21;\nHEADER;\n",
                "a STEP file, which is not read; call it .step, so that Gmsh reads it"},
        Foreign{"Brep", "x.shape", "\nDBRep_DrawableShape\n",
                "an OpenCASCADE BREP file, which is not read; call it .brep, so that Gmsh reads it"},
        Foreign{"Vrml", "x.vrml", "#VRML V2.0 utf8\n",
                "a VRML scene, which is not read; call it .wrl, so that Gmsh reads it"}),
    [](const auto& test) { return test.param.name; });

// Three numbers in the first line mean a FreeFem mesh only if the file's name ends in .msh.
TEST(ForeignFormats, AreNotSeenInOurFiles) {
  const test::TestFiles files;
  EXPECT_EQ(read_surface(files.write("a.off", cube(".off").substr(4))).triangles.size(), 12u);
  files.write("b.node", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n");
  EXPECT_EQ(read_document(files.write("b.ele", "1 4 0\n1 1 2 3 4\n")).elements(), 1u);
  // The title of a binary STL may be anything, also where there are no triangles.
  for (const std::size_t triangles : {0u, 1u}) {
    std::string stl = "\x89PNG of a part";
    stl.resize(84 + 50 * triangles);
    stl[80] = static_cast<char>(triangles);
    EXPECT_EQ(read_document(files.write("c.stl", stl)).title.substr(1), "PNG of a part");
  }
  // It may begin as another format that we read, too. Without triangles, only the ending tells.
  for (const std::string start :
       {"ply\nformat ascii 1.0", "$NOD", "<VTKFile>", "MeshVersionFormatted 2", "OFF"})
    for (const std::size_t triangles : {0u, 1u}) {
      std::string stl = start;
      stl.resize(84 + 50 * triangles);
      stl[80] = static_cast<char>(triangles);
      for (const std::string name : {"e.stl", "e.unknown"}) {
        if (triangles == 0 && name != "e.stl") continue;
        const Document document = read_document(files.write(name, stl));
        EXPECT_EQ(document.title, start) << name;
        EXPECT_TRUE(document.warnings.empty() || triangles > 0) << document.warnings[0];
      }
    }
  const std::string zeros = files.write("d.node", std::string(84, '\0'));
  EXPECT_EQ(files.message([&] { read_document(zeros); }).find("STL"), std::string::npos);
}

}  // namespace
}  // namespace tetproof
