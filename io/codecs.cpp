// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/codecs.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "io/bytes/atomic_file.hpp"
#include "io/bytes/input_file.hpp"
#include "io/medit/medit.hpp"
#include "io/msh/msh.hpp"
#include "io/obj/obj.hpp"
#include "io/off/off.hpp"
#include "io/ply/ply.hpp"
#include "io/stl/stl.hpp"
#include "io/supplement/supplement.hpp"
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

template <void (*Write)(AtomicFile&, const Document&, bool)>
void write_one_file(const std::string& path, const Document& document, bool binary, const std::string&) {
  AtomicFile file(path);
  Write(file, document, binary);
  file.commit();
}

template <void (*Write)(AtomicFile&, const Document&, bool)>
void write_msh(const std::string& path, const Document& document, bool binary,
               const std::string& supplement) {
  AtomicFile file(path);
  if (!supplement.empty()) file.keep_checksum();
  Write(file, document, binary);
  if (!supplement.empty())
    file.write(fmt::format("$TetproofSupplement\n{}{}$EndTetproofSupplement\n",
                           supplement_head({{"", file.checksum()}}), supplement));
  file.commit();
}

void write_msh40_text(AtomicFile& file, const Document& document, bool) {
  write_msh40(file, document);
}

Document read_surface_file(const std::string& path) {
  return read_surface_document(InputFile(path), Wanted::document).document;
}

template <Holds (*Held)(const Document&, bool)>
Holds holds_whatever_the_path(const std::string&, const Document& document, bool binary) {
  return Held(document, binary);
}

template <void (*Write)(AtomicFile&, const Document&, bool), Holds (*Held)(const Document&, bool)>
Codec surface(Format format) {
  return {std::move(format), read_surface_file, write_one_file<Write>, holds_whatever_the_path<Held>};
}

}  // namespace

const std::vector<Codec>& codecs() {
  static const std::vector<Codec> all{
      {{.name = "msh41", .what = "Gmsh .msh 4.1", .endings = {".msh"}, .reads = true},
       read_one_file<read_msh>,
       write_msh<write_msh41>,
       [](const std::string&, const Document& document, bool binary) {
         return msh_holds(document, "msh41", binary);
       }},
      {{.name = "msh40", .what = "Gmsh .msh 4.0", .endings = {".msh"}, .reads = true, .binary = false},
       read_one_file<read_msh>,
       write_msh<write_msh40_text>,
       [](const std::string&, const Document& document, bool binary) {
         return msh_holds(document, "msh40", binary);
       }},
      {{.name = "msh22", .what = "Gmsh .msh 2.2", .endings = {".msh"}, .reads = true},
       read_one_file<read_msh>,
       write_msh<write_msh22>,
       [](const std::string&, const Document& document, bool binary) {
         return msh_holds(document, "msh22", binary);
       }},
      {{.name = "tetgen",
        .what = "TetGen .node and .ele",
        .endings = {".node", ".ele", ".face", ".edge", ".neigh", ".vol", ".mtr", ".var", ".t2f", ".t2e",
                    ".f2e", ".cell"},
        .reads = true,
        .binary = false},
       read_tetgen,
       [](const std::string& path, const Document& document, bool, const std::string& supplement) {
         write_tetgen(path, document, supplement);
       },
       [](const std::string&, const Document& document, bool) { return tetgen_holds(document); },
       [](const std::string& path, const Document& document, bool) {
         return tetgen_left_over(path, document, "tetgen");
       }},
      {{.name = "poly", .what = "TetGen .poly", .endings = {".poly"}, .reads = true, .binary = false},
       read_tetgen,
       [](const std::string& path, const Document& document, bool, const std::string& supplement) {
         write_poly(path, document, supplement);
       },
       [](const std::string&, const Document& document, bool) { return poly_holds(document); },
       [](const std::string& path, const Document& document, bool) {
         return tetgen_left_over(path, document, "poly");
       }},
      {{.name = "smesh", .what = "TetGen .smesh", .endings = {".smesh"}, .reads = true, .binary = false},
       read_tetgen,
       [](const std::string& path, const Document& document, bool, const std::string& supplement) {
         write_smesh(path, document, supplement);
       },
       [](const std::string&, const Document& document, bool) { return smesh_holds(document); },
       [](const std::string& path, const Document& document, bool) {
         return tetgen_left_over(path, document, "smesh");
       }},
      {{.name = "vtu",
        .what = "VTK XML unstructured grid",
        .endings = {".vtu"},
        .reads = true,
        .usually_binary = true},
       read_one_file<read_vtu>,
       write_one_file<write_vtu>,
       holds_whatever_the_path<vtu_holds>,
       vtu_warning},
      {{.name = "vtk",
        .what = "VTK legacy unstructured grid",
        .endings = {".vtk"},
        .reads = true,
        .usually_binary = true},
       read_one_file<read_vtk>,
       write_one_file<write_vtk>,
       holds_whatever_the_path<vtk_holds>,
       vtk_warning},
      {{.name = "medit",
        .what = "Medit .mesh and .meshb",
        .endings = {".mesh", ".meshb"},
        .reads = true,
        .binary_ending = ".meshb"},
       read_one_file<read_medit>,
       write_one_file<write_medit>,
       holds_whatever_the_path<medit_holds>},
      surface<write_stl, stl_holds>(
          {.name = "stl", .what = "STL surface", .endings = {".stl"}, .reads = true, .usually_binary = true}),
      surface<write_off, off_holds>(
          {.name = "off", .what = "OFF surface", .endings = {".off"}, .reads = true, .binary = false}),
      surface<write_obj, obj_holds>({.name = "obj",
                                     .what = "Wavefront OBJ surface",
                                     .endings = {".obj"},
                                     .reads = true,
                                     .binary = false}),
      surface<write_ply, ply_holds>(
          {.name = "ply", .what = "PLY surface", .endings = {".ply"}, .reads = true, .usually_binary = true}),
  };
  return all;
}

const Codec& codec_named(const std::string& name) {
  for (const Codec& codec : codecs())
    if (codec.format.name == name) return codec;
  throw std::logic_error("no codec for " + name);
}

}  // namespace tetproof::io
