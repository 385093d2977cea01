// SPDX-License-Identifier: GPL-3.0-or-later
// Other programs read the surfaces that we write. Their own files come back from the format that they are in.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "io/error.hpp"
#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/surface/surface_document_text.hpp"

namespace tetproof {
namespace {

using test::told;

// VTK and meshio see the same points, cells and names of values, and do not warn. (With NumPy 2 of Debian 13
// Python warns of an overflow in meshio's own guess whether an STL file is binary.)
TEST(SurfaceDocuments, VtkAndMeshioReadWhatWeWrite) {
  const test::TestFiles files;
  const std::string python = "/usr/bin/python3 -W ignore::RuntimeWarning ",
                    quiet = " > " + files.path("out") + " 2>&1";
  if (std::system((python + "-c 'import vtk, meshio'" + quiet).c_str()) != 0)
    GTEST_SKIP() << "python3-vtk9 or python3-meshio is not here";
  const std::string script = files.write("read.py", R"(
import sys, os, vtk, meshio
os.chdir(sys.argv[1])
for name, reader in (('a.stl', vtk.vtkSTLReader()), ('b.stl', vtk.vtkSTLReader()), ('a.obj', vtk.vtkOBJReader()),
                     ('a.ply', vtk.vtkPLYReader()), ('b.ply', vtk.vtkPLYReader())):
    said = []
    reader.AddObserver('ErrorEvent', lambda *_: said.append('error'))
    reader.AddObserver('WarningEvent', lambda *_: said.append('warning'))
    reader.SetFileName(name)
    reader.Update()
    mesh = reader.GetOutput()
    data = mesh.GetPointData()
    print(name, mesh.GetNumberOfPoints(), mesh.GetNumberOfCells(), mesh.GetBounds(),
          [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())], *said)
for name in ('a.stl', 'b.stl', 'a.obj', 'a.ply', 'b.ply', 'a.off'):
    mesh = meshio.read(name)
    print(name, len(mesh.points), [(cells.type, len(cells.data)) for cells in mesh.cells], float(mesh.points.sum()))
)");
  const Document document = read_document(files.write(
      "in.off",
      "COFF\n4 2 0\n0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n0 1 0.5 1 2 3\n3 0 1 2\n3 0 2 3\n"));
  for (const char* letter : {"a", "b"})
    for (const char* ending : {".stl", ".ply"})
      write_document(files.path(letter + std::string(ending)), document, {.binary = *letter == 'b'});
  write_document(files.path("a.obj"), document);
  Document plain = document;
  plain.node_values.clear();
  write_document(files.path("a.off"), plain);
  ASSERT_EQ(std::system((python + script + " " + files.path("") + quiet).c_str()), 0)
      << files.read(files.path("out"));
  const std::string box = "(0.0, 1.0, 0.0, 1.0, 0.0, 0.5)";
  EXPECT_EQ(
      files.read(files.path("out")),
      "a.stl 4 2 " + box + " []\nb.stl 4 2 " + box + " []\na.obj 4 2 " + box + " []\na.ply 4 2 " + box +
          " ['RGB']\nb.ply 4 2 " + box +
          " ['RGB']\n"
          "a.stl 4 [('triangle', 2)] 4.5\nb.stl 4 [('triangle', 2)] 4.5\na.obj 4 [('triangle', 2)] 4.5\n"
          "a.ply 4 [('triangle', 2)] 4.5\nb.ply 4 [('triangle', 2)] 4.5\na.off 4 [('triangle', 2)] 4.5\n");
}

// Every sample that can be read comes back from its own format.
TEST(SurfaceDocuments, SamplesComeBack) {
  const std::filesystem::path shared = std::filesystem::path(TETPROOF_SOURCE_DIR) / ".." / "shared";
  if (!std::filesystem::exists(shared / "formats"))
    GTEST_SKIP() << shared / "formats"
                 << " is not here";
  const test::TestFiles files;
  int read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(shared / "formats")) {
    const std::string path = entry.path().string();
    if (!is_surface_file(path)) continue;
    SCOPED_TRACE(path);
    Document document;
    try {
      document = read_document(path);
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find(path), 0u);
      continue;
    }
    ++read;
    const bool text = document.title.empty() && document.format == "stl";
    const std::string again = files.path("again." + document.format);
    const WriteOptions options{.format = document.format, .binary = document.format == "stl" && !text};
    for (const Loss& loss : losses(again, document, options))
      ADD_FAILURE() << loss.item << ": " << loss.example;
    write_document(again, document, options);
    const Document back = read_document(again);
    EXPECT_EQ(told(back), told(document));
    EXPECT_EQ(test::text_of(back), test::text_of(document));
  }
  EXPECT_GE(read, 60);
}

}  // namespace
}  // namespace tetproof
