// SPDX-License-Identifier: GPL-3.0-or-later
// A user's program: meshes a generated surface, has the mesh judged, writes it, and has a broken one judged
// too.
#include <cmath>
#include <iostream>
#include <utility>

#include <tetproof/corpus/surfaces.hpp>
#include <tetproof/io/mesh_files.hpp>
#include <tetproof/reference/generate.hpp>
#include <tetproof/verify/verify.hpp>

int main() {
  using namespace tetproof;

  const TriangleSurface surface = corpus::make_surface("torus:R=1,r=0.4,n=2000");
  const reference::Generation generation = reference::generate(surface, {.cells = {16, 0, 0}});
  TetMesh mesh = generation.grid.mesh;

  const verify::Options options{.region = verify::Region::inside, .fidelity = 0.1, .voxels = 32};
  const verify::Report report = verify::verify(mesh, surface, options);
  std::cout << verify::report_text(report);
  if (!verify::sound(report) || report.certificate != true) return std::cerr << "not a sound mesh\n", 1;

  // The torus's volume is 2 pi^2 R r^2; its triangulation and a grid of 16 cells come within a tenth of it.
  const double exact = 2 * M_PI * M_PI * 0.4 * 0.4;
  if (std::abs(report.volume.mesh.value() - exact) > 0.1 * exact) return std::cerr << "wrong volume\n", 1;

  write_document("torus.msh", document_of(mesh));
  const TetMesh back = tet_mesh(read_document("torus.msh"));
  if (back.points != mesh.points || back.tets != mesh.tets) return std::cerr << "torus.msh differs\n", 1;

  std::swap(mesh.tets[0][0], mesh.tets[0][1]);
  if (verify::sound(verify::verify(mesh))) return std::cerr << "an inverted tetrahedron went unseen\n", 1;
  return 0;
}
