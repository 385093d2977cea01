// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/atomic_file.hpp"
#include "io/error.hpp"
#include "io/gmsh_import.hpp"
#include "io/input_file.hpp"
#include "io/msh.hpp"
#include "io/surface_files.hpp"
#include "io/tetgen.hpp"
#include "io/vtu.hpp"

namespace tetproof {
namespace {

std::string ending_of(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] != '.') return {};
  std::string ending = path.substr(dot);
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

const Format* format_with(const std::string& ending) {
  for (const Format& format : formats())
    if (std::find(format.endings.begin(), format.endings.end(), ending) != format.endings.end())
      return &format;
  return nullptr;
}

std::string tetgen_stem(const std::string& path) {
  const std::string ending = ending_of(path);
  return ending == ".node" || ending == ".ele" ? path.substr(0, path.size() - ending.size()) : path;
}

// Surface formats have no place for a triangle with a corner that does not exist.
TriangleSurface writable_surface(const Document& document) {
  TriangleSurface surface = surface_of(document);
  std::erase_if(surface.triangles, [](const std::array<Index, 3>& triangle) {
    return std::any_of(triangle.begin(), triangle.end(), [](Index i) { return i < 0; });
  });
  return surface;
}

}  // namespace

const std::vector<Format>& formats() {
  static const std::vector<Format> all{
      {.name = "msh41", .what = "Gmsh .msh 4.1", .endings = {".msh"}, .reads = true},
      {.name = "msh22", .what = "Gmsh .msh 2.2", .endings = {".msh"}, .reads = true},
      {.name = "tetgen",
       .what = "TetGen .node and .ele",
       .endings = {".node", ".ele"},
       .reads = true,
       .binary = false},
      {.name = "vtu", .what = "VTK XML unstructured grid", .endings = {".vtu"}, .usually_binary = true},
      {.name = "stl", .what = "STL surface", .endings = {".stl"}, .reads = true, .usually_binary = true},
      {.name = "off", .what = "OFF surface", .endings = {".off"}, .reads = true, .binary = false},
      {.name = "obj", .what = "Wavefront OBJ surface", .endings = {".obj"}, .reads = true, .binary = false},
      {.name = "ply", .what = "PLY surface", .endings = {".ply"}, .reads = true, .usually_binary = true},
  };
  return all;
}

const Format& format_of(const std::string& path) {
  if (const Format* format = format_with(ending_of(path))) return *format;
  std::vector<std::string> known;
  for (const Format& format : formats())
    for (const std::string& ending : format.endings)
      if (std::find(known.begin(), known.end(), ending) == known.end()) known.push_back(ending);
  throw InputError(fmt::format("{}: unknown ending, expected one of {}", path, fmt::join(known, " ")));
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
  const bool binary = options.binary.value_or(format.usually_binary);
  if (!(binary ? format.binary : format.ascii))
    throw InputError(fmt::format("{}: {} is never {}", path, format.what, binary ? "binary" : "text"));
  return {format.name, binary};
}

Document read_document(const std::string& path) {
  const Format* format = format_with(ending_of(path));
  const std::string name = format ? format->name : "";
  if (name == "tetgen") return io::read_tetgen(tetgen_stem(path), ending_of(path) == ".ele");
  if (name == "msh41") return io::read_msh(InputFile(path));
  if (format && !format->reads)
    throw InputError(fmt::format("{}: {} is written, but not read", path, format->what));
  const std::vector<std::string>& through_gmsh = io::gmsh_endings();
  if (!format && std::find(through_gmsh.begin(), through_gmsh.end(), ending_of(path)) != through_gmsh.end())
    return io::read_through_gmsh(path);
  if (!format) {  // the content may tell
    const InputFile file(path);
    if (file.bytes().substr(0, 11) == "$MeshFormat") return io::read_msh(file);
  }
  Document document = document_of(read_surface(path));
  document.path = path;
  document.format = format ? format->name : "surface";
  return document;
}

void write_document(const std::string& path, const Document& document, const WriteOptions& options) {
  const auto [format, binary] = encoding_of(path, options);
  if (format == "tetgen") return io::write_tetgen(tetgen_stem(path), document);
  if (format != "msh41" && format != "msh22" && format != "vtu")
    return write_surface(path, writable_surface(document), {.format = format, .ascii = !binary});
  AtomicFile file(path);
  if (format == "msh41")
    io::write_msh41(file, document, binary);
  else if (format == "msh22")
    io::write_msh22(file, document, binary);
  else
    io::write_vtu(file, document, binary);
  file.commit();
}

}  // namespace tetproof
