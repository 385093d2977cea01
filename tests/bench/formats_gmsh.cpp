// SPDX-License-Identifier: GPL-3.0-or-later
// Reading and writing a mesh by Gmsh's SDK, each repetition timed by itself, its start-up left out;
// formats.py runs it beside its peers.
//   formats_gmsh read FILE TIMES
//   formats_gmsh write FILE OUT VERSION ascii|binary TIMES
#include <gmsh.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "formats_timed.hpp"

namespace {

using tetproof::bench::timed;

int run(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  gmsh::initialize();
  gmsh::option::setNumber("General.Verbosity", 1);
  if (what == "read" && argc == 4) {
    for (int i = 0; i < std::atoi(argv[3]); ++i) {
      gmsh::clear();
      timed([&] { gmsh::open(argv[2]); });
    }
  } else if (what == "write" && argc == 7) {
    gmsh::open(argv[2]);
    gmsh::option::setNumber("Mesh.MshFileVersion", std::atof(argv[4]));
    gmsh::option::setNumber("Mesh.Binary", std::string(argv[5]) == "binary");
    for (int i = 0; i < std::atoi(argv[6]); ++i) timed([&] { gmsh::write(argv[3]); });
  } else {
    std::fprintf(stderr, "usage: formats_gmsh read FILE TIMES | write FILE OUT VERSION ascii|binary TIMES\n");
    return 2;
  }
  gmsh::finalize();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::string& error) {  // what Gmsh throws
    std::fprintf(stderr, "%s\n", error.c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  return 1;
}
