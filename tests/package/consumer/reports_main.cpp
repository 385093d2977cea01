// SPDX-License-Identifier: GPL-3.0-or-later
// A user's program that hands a report to other tools: as JSON, and as JUnit XML for a CI system.
// usage: reports REPORT.json REPORT.xml
#include <fstream>
#include <iostream>
#include <string>
#include <utility>

#include <tetproof/corpus/surfaces.hpp>
#include <tetproof/reference/generate.hpp>
#include <tetproof/verify/verify.hpp>

int main(int argc, char** argv) {
  using namespace tetproof;
  if (argc != 3) return std::cerr << "usage: reports REPORT.json REPORT.xml\n", 2;
  const TriangleSurface surface = corpus::make_surface("sphere:r=1,n=500");
  TetMesh mesh = reference::generate(surface, {.cells = {8, 0, 0}}).grid.mesh;
  std::swap(mesh.tets[0][0], mesh.tets[0][1]);
  const verify::Report report =
      verify::verify(mesh, surface, {.region = verify::Region::inside, .fidelity = 0.2, .voxels = 16});

  std::ofstream(argv[1]) << verify::report_json(report);
  const std::string junit = verify::report_junit(report, "sphere");
  std::ofstream(argv[2]) << junit;
  const bool told = junit.find("<failure type=\"inverted\" message=\"tetrahedron 0: negative") != junit.npos;
  return told ? 0 : (std::cerr << junit, 1);
}
