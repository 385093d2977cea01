// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "io/bytes/atomic_file.hpp"
#include "io/bytes/byte_order.hpp"
#include "io/bytes/input_file.hpp"
#include "io/bytes/tokens.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/obj/obj.hpp"
#include "io/off/off.hpp"
#include "io/ply/ply.hpp"
#include "io/stl/stl.hpp"
#include "io/surface/document_surface.hpp"
#include "io/surface/polygons.hpp"
#include "io/tetgen/tetgen.hpp"

namespace tetproof {
namespace {

// What the ending says: stl, ...; empty if there is none.
std::string format_of_name(const std::string& path) {
  const std::string ending = ending_of(path);
  return ending.empty() ? ending : ending.substr(1);
}

// stl, off or ply, if the content leaves no doubt; OBJ has no first line to be known by.
std::string format_of_content(const InputFile& file) {
  const std::string_view bytes = file.bytes();
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return "ply";
  if (bytes.size() > 84) {
    const std::size_t facets = io::load<std::uint32_t>(bytes.data() + 80, std::endian::little);
    if (bytes.size() == 84 + 50 * facets) return "stl";
  }
  Scanner scanner(file);
  const std::string first = io::lower_case(scanner.word('#').substr(0, 6));
  if (first == "off" || first == "coff" || first == "noff" || first == "cnoff" || first == "stoff")
    return "off";
  if (first == "solid") {
    scanner.next_line();
    const std::string second = io::lower_case(scanner.word().substr(0, 9));
    if (second == "facet" || second == "endsolid") return "stl";
  }
  return "";
}

[[noreturn]] void fail_unknown(const std::string& path, const std::string& known) {
  const std::string ending = ending_of(path);
  throw InputError(fmt::format("{}: {}, expected a surface as {}", path,
                               ending.empty() ? "no ending" : fmt::format("unknown ending '{}'", ending),
                               known));
}

bool is_known(const std::string& format) {
  return format == "stl" || format == "off" || format == "obj" || format == "ply";
}

bool is_of_a_format(const std::string& ending) {
  const std::vector<std::string> all = known_endings();
  return std::find(all.begin(), all.end(), ending) != all.end();
}

}  // namespace

bool is_surface_file(const std::string& path) {
  return is_known(format_of_name(path));
}

namespace io {

std::string surface_format(const InputFile& file) {
  const std::string format = format_of_name(file.path());
  return is_known(format) ? format : format_of_content(file);
}

SurfaceDocument read_surface_document(const InputFile& file, Wanted wanted) {
  const std::string format = surface_format(file);
  if (format == "stl") return read_stl(file, wanted);
  if (format == "off") return read_off(file, wanted);
  if (format == "obj") return read_obj(file, wanted);
  if (format == "ply") return read_ply(file, wanted);
  fail_unknown(file.path(), fmt::format("one of {}", fmt::join(known_endings(), " ")));
}

void write_surface_document(AtomicFile& file, const Document& document, const std::string& format,
                            bool binary) {
  if (format == "stl") return write_stl(file, document, binary);
  if (format == "off") return write_off(file, document);
  if (format == "obj") return write_obj(file, document);
  write_ply(file, document, binary);
}

}  // namespace io

SurfaceFile read_surface_file(const std::string& path, const ReadOptions& options) {
  const auto of_document = [](Document document) -> SurfaceFile {
    TriangleSurface surface = io::welded_surface(document);
    return {std::move(surface), std::move(document.warnings), std::move(document.dropped)};
  };
  if (!options.format.empty()) return of_document(read_document(path, options));
  const std::string ending = ending_of(path);
  if (ending == ".poly" || ending == ".smesh") return {io::read_tetgen_surface(path), {}, {}};
  if (!is_surface_file(path) && is_of_a_format(ending)) return of_document(read_document(path));
  const InputFile file(path);
  io::SurfaceDocument read = io::read_surface_document(file, io::Wanted::surface);
  std::vector<std::string> warnings = std::move(read.document.warnings);
  std::vector<Loss> dropped = std::move(read.document.dropped);
  return {io::surface_of_faces(file, std::move(read)), std::move(warnings), std::move(dropped)};
}

TriangleSurface read_surface(const std::string& path, const ReadOptions& options) {
  return read_surface_file(path, options).surface;
}

void write_surface(const std::string& path, const TriangleSurface& surface,
                   const SurfaceWriteOptions& options) {
  const std::string format = options.format.empty() ? format_of_name(path) : options.format;
  if (!is_known(format)) {
    if (options.format.empty()) fail_unknown(path, ".stl, .off, .obj or .ply");
    throw InputError(fmt::format("unknown surface format '{}', expected stl, off, obj or ply", format));
  }
  const auto vertices = static_cast<Index>(surface.vertices.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const Index corner : surface.triangles[t])
      if (corner < 0 || corner >= vertices)
        throw InputError(fmt::format("{}: cannot write triangle {}: vertex {} of {} vertices does not exist",
                                     path, t, corner, vertices));
  AtomicFile file(path);
  io::write_surface_document(file, document_of(surface), format, !options.ascii);
  file.commit();
}

}  // namespace tetproof
