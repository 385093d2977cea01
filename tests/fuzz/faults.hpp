// SPDX-License-Identifier: GPL-3.0-or-later
// The bugs of the faulty mesher.
#pragma once

#include <string>
#include <vector>

#include "io/tet_mesh.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::test {

/// One bug. What is null does what it should.
struct Fault {
  const char* name;
  const char* what;                                          ///< one line: what happens, and when
  const char* outcome;                                       ///< how the driver must class it
  void (*before)(const TriangleSurface& surface) = nullptr;  ///< before meshing
  void (*change)(TetMesh& mesh, const TriangleSurface& surface) = nullptr;
  void (*after)(const std::string& mesh_file) = nullptr;  ///< once the file is written
  bool fills_cavities = false;
  bool writes = true;
};

const std::vector<Fault>& faults();

}  // namespace tetproof::test
