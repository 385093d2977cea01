// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers.hpp"

#include <stdexcept>

#include "io/surface_files.hpp"

namespace tetproof::test {
namespace {

void surface(const std::string& path) {
  const TriangleSurface read = read_surface(path);
  for (const auto& triangle : read.triangles)
    for (const Index corner : triangle)
      if (corner < 0 || corner >= static_cast<Index>(read.vertices.size()))
        throw std::logic_error("a triangle names a vertex that does not exist");
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
  };
}

}  // namespace tetproof::test
