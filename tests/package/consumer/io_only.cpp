// SPDX-License-Identifier: GPL-3.0-or-later
// Writes one tetrahedron, reads it back, and compares.
#include <iostream>

#include <tetproof/io/mesh_files.hpp>

int main() {
  tetproof::TetMesh mesh;
  mesh.points = {{0, 0, 0}, {0.1, 0, 0}, {0, 1.0 / 3, 0}, {0, 0, 1e-300}};
  mesh.tets = {{0, 1, 2, 3}};
  tetproof::write_document("one.msh", tetproof::document_of(mesh));
  const tetproof::TetMesh back = tetproof::tet_mesh(tetproof::read_document("one.msh"));
  if (back.points == mesh.points && back.tets == mesh.tets) return 0;
  std::cerr << "one.msh does not hold what was written\n";
  return 1;
}
