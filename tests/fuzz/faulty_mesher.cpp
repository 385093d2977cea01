// SPDX-License-Identifier: GPL-3.0-or-later
// A mesher with planted bugs, for tests of the fuzz driver: it meshes star-shaped solids exactly, and refuses
// all others. A mesher that can do more would have bugs of its own, or not keep the boundary, so that a bug
// which moves it by 1e-6 could not be told from a sound mesh.
// usage: tetproof-faulty-mesher BUG SURFACE MESH    without arguments: the list of bugs
#include <exception>
#include <iostream>
#include <string>

#include "faults.hpp"
#include "io/document.hpp"
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "star_mesh.hpp"

#ifdef __SANITIZE_ADDRESS__
// Its crashes are those of any program, also where the tests are built with sanitizers.
extern "C" const char* __asan_default_options() {
  return "handle_segv=0:detect_leaks=0";
}
#endif

namespace {

using namespace tetproof;

int mesh(const test::Fault& fault, const std::string& input, const std::string& output) {
  TriangleSurface surface;
  TetMesh tets;
  try {
    surface = read_surface(input);
    if (fault.before) fault.before(surface);
    tets = test::star_mesh(surface, fault.fills_cavities);
  } catch (const test::NotStarShaped& reason) {
    std::cerr << "Sorry: " << reason.what() << "\n";
    return 1;
  }
  if (fault.change) fault.change(tets, surface);
  if (fault.writes) write_document(output, document_of(tets), {.format = "msh41", .binary = true});
  std::cout << tets.tets.size() << " tetrahedra" << std::endl;
  if (fault.after) fault.after(output);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "";
  for (const test::Fault& fault : test::faults())
    if (argc == 4 && name == fault.name) return mesh(fault, argv[2], argv[3]);
  std::cerr << "usage: tetproof-faulty-mesher BUG SURFACE MESH\n";
  for (const test::Fault& fault : test::faults())
    std::cerr << "  " << fault.name << ": " << fault.what << " (" << fault.outcome << ")\n";
  return 2;
}
