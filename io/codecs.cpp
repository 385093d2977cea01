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
#include "io/tetgen/tetgen.hpp"
#include "io/vtk/vtk.hpp"
#include "io/vtk/vtu.hpp"

namespace tetproof::io {
namespace {

template <Document (*Read)(const InputFile&)>
ReadDocument read_mesh(const InputFile& file, Wanted) {
  return {Read(file)};
}

}  // namespace

const std::vector<Codec>& codecs() {
  static const std::vector<Codec> all{
      {{.name = "msh41", .what = "Gmsh .msh 4.1", .endings = {".msh"}, .reads = true},
       read_mesh<read_msh>,
       plan_msh41,
       false,
       true},
      {{.name = "msh40", .what = "Gmsh .msh 4.0", .endings = {".msh"}, .reads = true, .binary = false},
       read_mesh<read_msh>,
       plan_msh40,
       false,
       true},
      {{.name = "msh22", .what = "Gmsh .msh 2.2", .endings = {".msh"}, .reads = true},
       read_mesh<read_msh>,
       plan_msh22,
       false,
       true},
      {{.name = "tetgen",
        .what = "TetGen .node and .ele",
        .endings = {".node", ".ele", ".face", ".edge", ".neigh", ".vol", ".mtr", ".var", ".t2f", ".t2e",
                    ".f2e", ".cell"},
        .reads = true,
        .binary = false},
       read_tetgen,
       plan_tetgen,
       false,
       true},
      {{.name = "poly", .what = "TetGen .poly", .endings = {".poly"}, .reads = true, .binary = false},
       read_poly,
       plan_poly,
       false,
       true},
      {{.name = "smesh", .what = "TetGen .smesh", .endings = {".smesh"}, .reads = true, .binary = false},
       read_smesh,
       plan_smesh,
       false,
       true},
      {{.name = "vtu",
        .what = "VTK XML unstructured grid",
        .endings = {".vtu"},
        .endings_only_read = {".vtp", ".vti", ".vtr", ".vts"},
        .reads = true,
        .usually_binary = true},
       read_mesh<read_vtu>,
       plan_vtu,
       true},
      {{.name = "vtk",
        .what = "VTK legacy unstructured grid",
        .endings = {".vtk"},
        .reads = true,
        .usually_binary = true},
       read_mesh<read_vtk>,
       plan_vtk,
       true},
      {{.name = "medit",
        .what = "Medit .mesh and .meshb",
        .endings = {".mesh", ".meshb"},
        .endings_beside = {".sol", ".solb"},
        .reads = true,
        .binary_ending = ".meshb"},
       read_mesh<read_medit>,
       plan_medit,
       false,
       false,
       true},
      {{.name = "stl", .what = "STL surface", .endings = {".stl"}, .reads = true, .usually_binary = true},
       read_stl,
       plan_stl},
      {{.name = "off", .what = "OFF surface", .endings = {".off"}, .reads = true, .binary = false},
       read_off,
       plan_off},
      {{.name = "obj", .what = "Wavefront OBJ surface", .endings = {".obj"}, .reads = true, .binary = false},
       read_obj,
       plan_obj,
       true},
      {{.name = "ply", .what = "PLY surface", .endings = {".ply"}, .reads = true, .usually_binary = true},
       read_ply,
       plan_ply},
  };
  return all;
}

const Codec& codec_named(const std::string& name) {
  for (const Codec& codec : codecs())
    if (codec.format.name == name) return codec;
  throw std::logic_error("no codec for " + name);
}

ReadDocument read_as(const std::string& format, const InputFile& file, Wanted wanted) {
  return codec_named(format).read(file, wanted);
}

}  // namespace tetproof::io
