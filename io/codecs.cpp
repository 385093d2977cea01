// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/codecs.hpp"

#include <stdexcept>

#include "io/bytes/input_file.hpp"
#include "io/medit/medit.hpp"
#include "io/msh/msh.hpp"
#include "io/obj/obj.hpp"
#include "io/off/off.hpp"
#include "io/ply/ply.hpp"
#include "io/stl/stl.hpp"
#include "io/surface/surface_document.hpp"
#include "io/tetgen/tetgen.hpp"
#include "io/vtk/vtk.hpp"
#include "io/vtk/vtu.hpp"

namespace tetproof::io {
namespace {

template <Document (*Read)(const InputFile&)>
Document read_one_file(const std::string& path) {
  return Read(InputFile(path));
}

Document read_surface_file(const std::string& path) {
  return read_surface_document(InputFile(path), Wanted::document).document;
}

}  // namespace

const std::vector<Codec>& codecs() {
  static const std::vector<Codec> all{
      {{.name = "msh41", .what = "Gmsh .msh 4.1", .endings = {".msh"}, .reads = true},
       read_one_file<read_msh>,
       plan_msh41},
      {{.name = "msh40", .what = "Gmsh .msh 4.0", .endings = {".msh"}, .reads = true, .binary = false},
       read_one_file<read_msh>,
       plan_msh40},
      {{.name = "msh22", .what = "Gmsh .msh 2.2", .endings = {".msh"}, .reads = true},
       read_one_file<read_msh>,
       plan_msh22},
      {{.name = "tetgen",
        .what = "TetGen .node and .ele",
        .endings = {".node", ".ele", ".face", ".edge", ".neigh", ".vol", ".mtr", ".var", ".t2f", ".t2e",
                    ".f2e", ".cell"},
        .reads = true,
        .binary = false},
       read_tetgen,
       plan_tetgen},
      {{.name = "poly", .what = "TetGen .poly", .endings = {".poly"}, .reads = true, .binary = false},
       read_tetgen,
       plan_poly},
      {{.name = "smesh", .what = "TetGen .smesh", .endings = {".smesh"}, .reads = true, .binary = false},
       read_tetgen,
       plan_smesh},
      {{.name = "vtu",
        .what = "VTK XML unstructured grid",
        .endings = {".vtu"},
        .reads = true,
        .usually_binary = true},
       read_one_file<read_vtu>,
       plan_vtu},
      {{.name = "vtk",
        .what = "VTK legacy unstructured grid",
        .endings = {".vtk"},
        .reads = true,
        .usually_binary = true},
       read_one_file<read_vtk>,
       plan_vtk},
      {{.name = "medit",
        .what = "Medit .mesh and .meshb",
        .endings = {".mesh", ".meshb"},
        .reads = true,
        .binary_ending = ".meshb"},
       read_one_file<read_medit>,
       plan_medit},
      {{.name = "stl", .what = "STL surface", .endings = {".stl"}, .reads = true, .usually_binary = true},
       read_surface_file,
       plan_stl},
      {{.name = "off", .what = "OFF surface", .endings = {".off"}, .reads = true, .binary = false},
       read_surface_file,
       plan_off},
      {{.name = "obj", .what = "Wavefront OBJ surface", .endings = {".obj"}, .reads = true, .binary = false},
       read_surface_file,
       plan_obj},
      {{.name = "ply", .what = "PLY surface", .endings = {".ply"}, .reads = true, .usually_binary = true},
       read_surface_file,
       plan_ply},
  };
  return all;
}

const Codec& codec_named(const std::string& name) {
  for (const Codec& codec : codecs())
    if (codec.format.name == name) return codec;
  throw std::logic_error("no codec for " + name);
}

}  // namespace tetproof::io
