// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "io/bytes/atomic_file.hpp"
#include "io/bytes/input_file.hpp"
#include "io/bytes/tokens.hpp"
#include "io/error.hpp"
#include "io/loss/holds.hpp"
#include "io/medit/medit.hpp"
#include "io/msh/msh.hpp"
#include "io/obj/obj.hpp"
#include "io/off/off.hpp"
#include "io/ply/ply.hpp"
#include "io/reading.hpp"
#include "io/stl/stl.hpp"
#include "io/supplement/supplement.hpp"
#include "io/tetgen/tetgen.hpp"
#include "io/vtk/vtk.hpp"
#include "io/vtk/vtu.hpp"

namespace tetproof {
namespace {

const Format* format_with(const std::string& ending) {
  for (const Format& format : formats())
    if (std::find(format.endings.begin(), format.endings.end(), ending) != format.endings.end())
      return &format;
  return nullptr;
}

// A format, and who reads and writes it.
struct Codec {
  Format format;
  io::ReadDocument (*read)(const InputFile&, io::Wanted);
  /// `supplement`: lines that the file keeps aside, for formats whose Holds say where.
  void (*write)(const std::string& path, const Document&, bool binary, const std::string& supplement);
  io::Holds (*holds)(const std::string& path, const Document&, bool binary);
  /// See `write_warning`; null: never any.
  std::string (*warning)(const std::string& path, const Document&, bool binary) = nullptr;
};

template <Document (*Read)(const InputFile&)>
io::ReadDocument read_mesh(const InputFile& file, io::Wanted) {
  return {Read(file)};
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
                           io::supplement_head({{"", file.checksum()}}), supplement));
  file.commit();
}

void write_msh40_text(AtomicFile& file, const Document& document, bool) {
  io::write_msh40(file, document);
}

template <io::Holds (*Holds)(const Document&, bool)>
io::Holds holds_whatever_the_path(const std::string&, const Document& document, bool binary) {
  return Holds(document, binary);
}

template <io::ReadDocument (*Read)(const InputFile&, io::Wanted),
          void (*Write)(AtomicFile&, const Document&, bool), io::Holds (*Holds)(const Document&, bool)>
Codec surface(Format format) {
  return {std::move(format), Read, write_one_file<Write>, holds_whatever_the_path<Holds>};
}

const std::vector<Codec>& codecs() {
  static const std::vector<Codec> all{
      {{.name = "msh41", .what = "Gmsh .msh 4.1", .endings = {".msh"}, .reads = true},
       read_mesh<io::read_msh>,
       write_msh<io::write_msh41>,
       [](const std::string&, const Document& document, bool binary) {
         return io::msh_holds(document, "msh41", binary);
       }},
      {{.name = "msh40", .what = "Gmsh .msh 4.0", .endings = {".msh"}, .reads = true, .binary = false},
       read_mesh<io::read_msh>,
       write_msh<write_msh40_text>,
       [](const std::string&, const Document& document, bool binary) {
         return io::msh_holds(document, "msh40", binary);
       }},
      {{.name = "msh22", .what = "Gmsh .msh 2.2", .endings = {".msh"}, .reads = true},
       read_mesh<io::read_msh>,
       write_msh<io::write_msh22>,
       [](const std::string&, const Document& document, bool binary) {
         return io::msh_holds(document, "msh22", binary);
       }},
      {{.name = "tetgen",
        .what = "TetGen .node and .ele",
        .endings = {".node", ".ele", ".face", ".edge", ".neigh", ".vol", ".mtr", ".var", ".t2f", ".t2e",
                    ".f2e", ".cell"},
        .reads = true,
        .binary = false},
       io::read_tetgen,
       [](const std::string& path, const Document& document, bool, const std::string& supplement) {
         io::write_tetgen(path, document, supplement);
       },
       [](const std::string&, const Document& document, bool) { return io::tetgen_holds(document); },
       [](const std::string& path, const Document& document, bool) {
         return io::tetgen_left_over(path, document, "tetgen");
       }},
      {{.name = "poly", .what = "TetGen .poly", .endings = {".poly"}, .reads = true, .binary = false},
       io::read_poly,
       [](const std::string& path, const Document& document, bool, const std::string& supplement) {
         io::write_poly(path, document, supplement);
       },
       [](const std::string&, const Document& document, bool) { return io::poly_holds(document); },
       [](const std::string& path, const Document& document, bool) {
         return io::tetgen_left_over(path, document, "poly");
       }},
      {{.name = "smesh", .what = "TetGen .smesh", .endings = {".smesh"}, .reads = true, .binary = false},
       io::read_smesh,
       [](const std::string& path, const Document& document, bool, const std::string& supplement) {
         io::write_smesh(path, document, supplement);
       },
       [](const std::string&, const Document& document, bool) { return io::smesh_holds(document); },
       [](const std::string& path, const Document& document, bool) {
         return io::tetgen_left_over(path, document, "smesh");
       }},
      {{.name = "vtu",
        .what = "VTK XML unstructured grid",
        .endings = {".vtu"},
        .reads = true,
        .usually_binary = true},
       read_mesh<io::read_vtu>,
       write_one_file<io::write_vtu>,
       holds_whatever_the_path<io::vtu_holds>,
       io::vtu_warning},
      {{.name = "vtk",
        .what = "VTK legacy unstructured grid",
        .endings = {".vtk"},
        .reads = true,
        .usually_binary = true},
       read_mesh<io::read_vtk>,
       write_one_file<io::write_vtk>,
       holds_whatever_the_path<io::vtk_holds>,
       io::vtk_warning},
      {{.name = "medit",
        .what = "Medit .mesh and .meshb",
        .endings = {".mesh", ".meshb"},
        .reads = true,
        .binary_ending = ".meshb"},
       read_mesh<io::read_medit>,
       write_one_file<io::write_medit>,
       holds_whatever_the_path<io::medit_holds>},
      surface<io::read_stl, io::write_stl, io::stl_holds>(
          {.name = "stl", .what = "STL surface", .endings = {".stl"}, .reads = true, .usually_binary = true}),
      surface<io::read_off, io::write_off, io::off_holds>(
          {.name = "off", .what = "OFF surface", .endings = {".off"}, .reads = true, .binary = false}),
      surface<io::read_obj, io::write_obj, io::obj_holds>({.name = "obj",
                                                           .what = "Wavefront OBJ surface",
                                                           .endings = {".obj"},
                                                           .reads = true,
                                                           .binary = false}),
      surface<io::read_ply, io::write_ply, io::ply_holds>(
          {.name = "ply", .what = "PLY surface", .endings = {".ply"}, .reads = true, .usually_binary = true}),
  };
  return all;
}

const Codec& codec_named(const std::string& name) {
  for (const Codec& codec : codecs())
    if (codec.format.name == name) return codec;
  throw std::logic_error("no codec for " + name);
}

}  // namespace

const std::vector<Format>& formats() {
  static const std::vector<Format> all = [] {
    std::vector<Format> list;
    for (const Codec& codec : codecs()) list.push_back(codec.format);
    return list;
  }();
  return all;
}

std::string ending_of(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] != '.') return {};
  return io::lower_case(path.substr(dot));
}

std::vector<std::string> known_endings() {
  std::vector<std::string> known;
  for (const Format& format : formats())
    for (const std::string& ending : format.endings)
      if (std::find(known.begin(), known.end(), ending) == known.end()) known.push_back(ending);
  return known;
}

const Format& format_of(const std::string& path) {
  if (const Format* format = format_with(ending_of(path))) return *format;
  throw InputError(
      fmt::format("{}: unknown ending, expected one of {}", path, fmt::join(known_endings(), " ")));
}

const Format& format_named(const std::string& name) {
  std::vector<std::string> known;
  for (const Format& format : formats()) {
    if (format.name == name) return format;
    known.push_back(format.name);
  }
  throw InputError(fmt::format("unknown format '{}', expected one of {}", name, fmt::join(known, " ")));
}

Encoding encoding_of(const std::string& path, const WriteOptions& options) {
  const Format& format = options.format.empty() ? format_of(path) : format_named(options.format);
  const std::string ending = ending_of(path);
  const bool says_binary = !format.binary_ending.empty() && ending == format.binary_ending;
  const bool binary = options.binary.value_or(says_binary || format.usually_binary);
  if (!format.binary_ending.empty() && binary != says_binary &&
      std::find(format.endings.begin(), format.endings.end(), ending) != format.endings.end())
    throw InputError(fmt::format("{}: {} is binary if the name ends in {}, and only then", path, format.what,
                                 format.binary_ending));
  if (!(binary ? format.binary : format.ascii))
    throw InputError(fmt::format("{}: {} is never {}", path, format.what, binary ? "binary" : "text"));
  return {format.name, binary};
}

Document read_document(const std::string& path, const ReadOptions& options) {
  return io::read_file(io::open_input(path), options, io::Wanted::document).document;
}

io::ReadDocument io::read_as(const std::string& format, const InputFile& file, Wanted wanted) {
  return codec_named(format).read(file, wanted);
}

io::Holds io::holds_of(const std::string& path, const Document& document, const WriteOptions& options) {
  const auto [format, binary] = encoding_of(path, options);
  return codec_named(format).holds(path, document, binary);
}

void write_document(const std::string& path, const Document& document, const WriteOptions& options) {
  const auto [format, binary] = encoding_of(path, options);
  const Codec& codec = codec_named(format);
  codec.write(path, document, binary, io::supplement_of(document, codec.holds(path, document, binary)));
}

std::string write_warning(const std::string& path, const Document& document, const WriteOptions& options) {
  const auto [format, binary] = encoding_of(path, options);
  const Codec& codec = codec_named(format);
  return codec.warning ? codec.warning(path, document, binary) : "";
}

}  // namespace tetproof
