// SPDX-License-Identifier: GPL-3.0-or-later
// Netgen's library as a program: fills a closed surface, whose triangles it keeps. Its own program needs a
// display, reads STL, and makes triangles of its own.
// usage: tetproof-netgen SURFACE MESH [SIZE [raw]]     SIZE: the largest edge; raw: no optimization
#include <dlfcn.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>

#include "io/document.hpp"
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"

namespace nglib {
#include <nglib.h>
}

#ifdef __SANITIZE_ADDRESS__
// Netgen leaks, which is not ours to judge where the tests are built with sanitizers.
extern "C" const char* __asan_default_options() {
  return "detect_leaks=0";
}
#endif

namespace {

using namespace tetproof;

/// The library's file, whose name has its version.
int print_version() {
  Dl_info info{};
  if (::dladdr(reinterpret_cast<void*>(&nglib::Ng_Init), &info) == 0) return 1;
  std::cout << "Netgen, " << std::filesystem::canonical(info.dli_fname).filename().string() << "\n";
  return 0;
}

const char* words_for(nglib::Ng_Result result) {
  switch (result) {
    case nglib::NG_SURFACE_INPUT_ERROR:
      return "Error: the surface's input is wrong";
    case nglib::NG_VOLUME_FAILURE:
      return "Error: the volume could not be meshed";
    default:
      return "Error: no mesh";
  }
}

int mesh(const std::string& input, const std::string& output, const char* size, bool raw) {
  const TriangleSurface surface = read_surface(input);
  nglib::Ng_Init();
  nglib::Ng_Mesh* grid = nglib::Ng_NewMesh();
  for (Eigen::Vector3d vertex : surface.vertices) nglib::Ng_AddPoint(grid, vertex.data());
  for (const auto& triangle : surface.triangles) {
    std::array<int, 3> numbers{triangle[0] + 1, triangle[1] + 1, triangle[2] + 1};
    nglib::Ng_AddSurfaceElement(grid, nglib::NG_TRIG, numbers.data());
  }
  nglib::Ng_Meshing_Parameters parameters;
  parameters.maxh = size ? std::atof(size) : 1e300;
  if (raw) parameters.optvolmeshenable = 0;
  if (raw) parameters.optsteps_3d = 0;
  const nglib::Ng_Result result = nglib::Ng_GenerateVolumeMesh(grid, &parameters);
  if (result != nglib::NG_OK) {
    std::cerr << words_for(result) << " (" << result << ")\n";
    return 1;
  }
  TetMesh tets;
  tets.points.resize(static_cast<std::size_t>(nglib::Ng_GetNP(grid)));
  for (std::size_t i = 0; i < tets.points.size(); ++i)
    nglib::Ng_GetPoint(grid, static_cast<int>(i + 1), tets.points[i].data());
  const int count = nglib::Ng_GetNE(grid);
  for (int i = 1; i <= count; ++i) {
    std::array<int, NG_VOLUME_ELEMENT_MAXPOINTS> numbers{};
    nglib::Ng_GetVolumeElement(grid, i, numbers.data());
    // Netgen counts a tetrahedron's corners the other way round.
    tets.tets.push_back({numbers[0] - 1, numbers[2] - 1, numbers[1] - 1, numbers[3] - 1});
  }
  write_document(output, document_of(tets));
  std::cout << count << " tetrahedra\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::string(argv[1]) == "--version") return print_version();
  if (argc < 3) {
    std::cerr << "usage: tetproof-netgen SURFACE MESH [SIZE [raw]]\n";
    return 2;
  }
  try {
    return mesh(argv[1], argv[2], argc > 3 ? argv[3] : nullptr, argc > 4 && std::string(argv[4]) == "raw");
  } catch (const std::logic_error&) {
    throw;  // a fault inside the library, and no refusal
  } catch (const std::exception& reason) {
    std::cerr << "Error: " << reason.what() << "\n";
    return 2;
  }
}
