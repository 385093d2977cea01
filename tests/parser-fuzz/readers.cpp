// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers.hpp"

#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>

#include "io/error.hpp"
#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "io/trace.hpp"
#include "tests/support/document_in_order.hpp"

namespace tetproof::test {
namespace {

void surface(const std::string& path) {
  const TriangleSurface read = read_surface(path);
  for (const auto& triangle : read.triangles)
    for (const Index corner : triangle)
      if (corner < 0 || corner >= static_cast<Index>(read.vertices.size()))
        throw std::logic_error("a triangle names a vertex that does not exist");
}

// In one of the formats and encodings, another one for each document: what is written can be read.
void written_again(const Document& document, const std::string& path) {
  std::vector<std::pair<const Format*, bool>> targets;
  for (const Format& format : formats())
    for (const bool binary : {false, true})
      if (binary ? format.binary : format.ascii) targets.emplace_back(&format, binary);
  const std::size_t any = 31 * document.points.size() + 17 * document.connectivity.size() +
                          7 * document.sections.size() + document.warnings.size();
  const auto& [format, binary] = targets[any % targets.size()];
  const WriteOptions options{.format = format->name, .binary = binary};
  const std::filesystem::path folder = path + ".again";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const std::string again = folder / ("y" + format->endings.front());
  losses(again, document, options);
  try {
    write_document(again, document, options);
  } catch (const InputError&) {
    if (!binary) throw;  // a tag that does not fit 4 bytes
    return;
  }
  if (!format->reads) return;
  try {
    check_in_order(read_document(again));
  } catch (const InputError& error) {
    throw std::logic_error(std::string("what was written is refused: ") + error.what());
  }
  std::filesystem::remove_all(folder);
}

// What was read must also be fit to be looked at and written.
void mesh(const std::string& path) {
  const Document read = read_document(path);
  check_in_order(read);
  const TetMesh view = tet_mesh(read);
  const Numbering names = numbering(read);
  if (!names.tets.empty() && names.tets.size() != view.tets.size())
    throw std::logic_error("tetrahedra without a number");
  try {
    surface_of(read);
  } catch (const InputError&) {  // it has no faces, or none that can be cut
  }
  tet_regions(read);
  written_again(read, path);
}

// A surface is read as such, and as a document.
void surface_and_mesh(const std::string& path) {
  mesh(path);
  surface(path);
}

// What was read must be fit to be written, and mean the same when it is read again.
void trace_of(const std::string& path) {
  trace::Reader reader(path);
  std::string text;
  std::size_t records = 0;
  for (; const std::optional<trace::Record> record = reader.next(); ++records)
    text += trace::to_line(*record) + "\n";
  if (records == 0) return;
  const std::string again = path + ".again";
  std::ofstream(again) << text;
  trace::Reader second(again);
  for (; const std::optional<trace::Record> record = second.next(); --records)
    if (text.find(trace::to_line(*record) + "\n") == std::string::npos)
      throw std::logic_error("a record that is not the one that was written");
  if (records != 0) throw std::logic_error("not as many records as were written");
}

}  // namespace

std::function<void(const std::string&)> reader_of(const std::string& ending) {
  if (ending == ".jsonl") return trace_of;
  const bool surfaces = is_surface_file("x" + ending);
  return surfaces ? surface_and_mesh : mesh;
}

std::vector<Reader> readers() {
  // Written by VTK 9.1: what tests/programs/vtk_kinds.py writes, smaller.
  const std::string seeds = "../../tests/parser-fuzz/seeds/";
  return {
      {"Off", "surfaces/cube.off", surface_and_mesh},
      {"Obj", "surfaces/cube.obj", surface_and_mesh},
      {"StlText", "surfaces/tetrahedra.stl", surface_and_mesh},
      {"StlBinary", "surfaces/cube_binary.stl", surface_and_mesh},
      {"PlyText", "surfaces/cube_text.ply", surface_and_mesh},
      {"PlyLittleEndian", "surfaces/cube_little_endian.ply", surface_and_mesh},
      {"PlyBigEndian", "surfaces/cube_big_endian.ply", surface_and_mesh},
      {"Msh41Text", "meshes/two_41_text.msh", mesh},
      {"Msh41LittleEndian", "meshes/two_41_little_endian.msh", mesh},
      {"Msh41BigEndian", "meshes/two_41_big_endian.msh", mesh},
      {"Msh22Text", "meshes/two_22_text.msh", mesh},
      {"Msh22LittleEndian", "meshes/two_22_little_endian.msh", mesh},
      {"Msh22BigEndian", "meshes/two_22_big_endian.msh", mesh},
      {"Msh1", "meshes/two_1.msh", mesh},
      {"Msh3Text", "meshes/two_3_text.msh", mesh},
      {"Msh3Binary", "meshes/two_3_binary.msh", mesh},
      {"Msh40Text", "meshes/two_40_text.msh", mesh},
      {"Msh40Binary", "meshes/two_40_binary.msh", mesh},
      {"TetgenNodes", "meshes/two.1.node", mesh, {"meshes/two.1.ele"}},
      {"TetgenTetrahedra", "meshes/two.1.ele", mesh, {"meshes/two.1.node"}},
      {"VtkText", "meshes/cells_text.vtk", mesh},
      {"VtkBinary", "meshes/cells_binary.vtk", mesh},
      {"VtuText", "meshes/cells_text.vtu", mesh},
      {"VtuZlib", "meshes/cells_base64_zlib.vtu", mesh},
      {"VtuRaw", "meshes/cells_raw.vtu", mesh},
      {"VtkKindsText", seeds + "kinds_text.vtk", mesh},
      {"VtkKindsBinary", seeds + "kinds_binary.vtk", mesh},
      {"VtkImage", seeds + "image.vtk", mesh},
      {"VtkRectilinear", seeds + "rectilinear.vtk", mesh},
      {"VtuLz4", seeds + "kinds_raw_lz4.vtu", mesh},
      {"VtuLzma", seeds + "kinds_base64_lzma.vtu", mesh},
      {"Vtp", seeds + "polygonal.vtp", mesh},
      {"Vti", seeds + "image.vti", mesh},
      {"VtiPieces", seeds + "pieces.vti", mesh},
      {"VtuFaces", seeds + "faces.vtu", mesh},
      {"Vtr", seeds + "rectilinear.vtr", mesh},
      {"MeditText", "meshes/two.mesh", mesh},
      {"MeditBinary", "meshes/two.meshb", mesh},
      {"TetgenFaces", "meshes/set.1.face", mesh, {"meshes/set.1.node", "meshes/set.1.ele"}},
      {"TetgenEdges", "meshes/set.1.edge", mesh, {"meshes/set.1.node", "meshes/set.1.ele"}},
      {"TetgenNeighbours", "meshes/set.1.neigh", mesh, {"meshes/set.1.node", "meshes/set.1.ele"}},
      {"TetgenFacesOfTetrahedra", "meshes/set.1.t2f", mesh, {"meshes/set.1.node", "meshes/set.1.ele"}},
      {"TetgenEdgesOfTetrahedra", "meshes/set.1.t2e", mesh, {"meshes/set.1.node", "meshes/set.1.ele"}},
      {"TetgenEdgesOfFaces",
       "meshes/set.1.f2e",
       mesh,
       {"meshes/set.1.node", "meshes/set.1.ele", "meshes/set.1.face"}},
      {"TetgenVolumes", "meshes/set.1.vol", mesh, {"meshes/set.1.node", "meshes/set.1.ele"}},
      {"TetgenSizes", "meshes/set.1.mtr", mesh, {"meshes/set.1.node", "meshes/set.1.ele"}},
      {"TetgenBounds", "meshes/set.1.var", mesh, {"meshes/set.1.node", "meshes/set.1.ele"}},
      {"TetgenVoronoiPoints",
       "meshes/set.1.v.node",
       mesh,
       {"meshes/set.1.node", "meshes/set.1.v.edge", "meshes/set.1.v.face", "meshes/set.1.v.cell"}},
      {"TetgenVoronoiEdges",
       "meshes/set.1.v.edge",
       mesh,
       {"meshes/set.1.node", "meshes/set.1.v.node", "meshes/set.1.v.face", "meshes/set.1.v.cell"}},
      {"TetgenVoronoiFaces",
       "meshes/set.1.v.face",
       mesh,
       {"meshes/set.1.node", "meshes/set.1.v.node", "meshes/set.1.v.edge", "meshes/set.1.v.cell"}},
      {"TetgenVoronoiCells",
       "meshes/set.1.v.cell",
       mesh,
       {"meshes/set.1.node", "meshes/set.1.v.node", "meshes/set.1.v.edge", "meshes/set.1.v.face"}},
      {"TetgenPoly", "meshes/facets.poly", mesh},
      {"TetgenSmesh", "meshes/pyramid.smesh", surface_and_mesh},
      {"Trace", "traces/every_record.jsonl", trace_of},
  };
}

}  // namespace tetproof::test
