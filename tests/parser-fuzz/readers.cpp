// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers.hpp"

#include <fstream>
#include <optional>
#include <stdexcept>

#include "io/error.hpp"
#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "io/trace.hpp"

namespace tetproof::test {
namespace {

void surface(const std::string& path) {
  const TriangleSurface read = read_surface(path);
  for (const auto& triangle : read.triangles)
    for (const Index corner : triangle)
      if (corner < 0 || corner >= static_cast<Index>(read.vertices.size()))
        throw std::logic_error("a triangle names a vertex that does not exist");
}

void check_positions(const Document& read) {
  const Index nodes = static_cast<Index>(read.points.size()),
              unknown = static_cast<Index>(read.unknown.size());
  for (const Index node : read.connectivity)
    if (node >= nodes || -1 - node >= unknown)
      throw std::logic_error("an element names a position that does not exist");
  std::size_t elements = 0, connectivity = 0;
  for (const ElementBlock& block : read.blocks) {
    if (block.first != elements || block.nodes != connectivity)
      throw std::logic_error("a block does not follow the last");
    elements += block.count;
    connectivity += block.count * block.nodes_each;
  }
  if (connectivity != read.connectivity.size() ||
      (!read.element_tags.empty() && read.element_tags.size() != elements) ||
      (!read.node_tags.empty() && read.node_tags.size() != read.points.size()))
    throw std::logic_error("the arrays of a document have different lengths");
}

// What was read must also be fit to be looked at and written in every format.
void mesh(const std::string& path) {
  const Document read = read_document(path);
  check_positions(read);
  const TetMesh view = tet_mesh(read);
  const Numbering names = numbering(read);
  if (!names.tets.empty() && names.tets.size() != view.tets.size())
    throw std::logic_error("tetrahedra without a number");
  surface_of(read);
  for (const char* format : {"msh41", "msh22", "vtu"})
    for (const bool binary : {false, true}) {
      losses("/dev/null", read, {.format = format, .binary = binary});
      try {
        write_document("/dev/null", read, {.format = format, .binary = binary});
      } catch (const InputError&) {
        if (!binary) throw;  // a tag that does not fit 4 bytes
      }
    }
  losses("a.node", read);
  losses("a.stl", read);
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

std::vector<Reader> readers() {
  return {
      {"Off", "surfaces/cube.off", surface},
      {"Obj", "surfaces/cube.obj", surface},
      {"StlText", "surfaces/tetrahedra.stl", surface},
      {"StlBinary", "surfaces/cube_binary.stl", surface},
      {"PlyText", "surfaces/cube_text.ply", surface},
      {"PlyLittleEndian", "surfaces/cube_little_endian.ply", surface},
      {"PlyBigEndian", "surfaces/cube_big_endian.ply", surface},
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
      {"Trace", "traces/every_record.jsonl", trace_of},
  };
}

}  // namespace tetproof::test
