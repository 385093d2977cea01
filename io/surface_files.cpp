// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface_files.hpp"

#include <fmt/core.h>

#include <bit>
#include <cstdint>

#include "io/atomic_file.hpp"
#include "io/byte_order.hpp"
#include "io/document_surface.hpp"
#include "io/error.hpp"
#include "io/input_file.hpp"
#include "io/mesh_files.hpp"
#include "io/obj.hpp"
#include "io/off.hpp"
#include "io/ply.hpp"
#include "io/stl.hpp"

namespace tetproof {
namespace {

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
  return text;
}

// The ending in lower case without its dot; empty if there is none.
std::string ending_of(const std::string& path) {
  const std::string name = path.substr(path.find_last_of('/') + 1);
  const std::size_t dot = name.find_last_of('.');
  return dot == name.npos ? "" : lower_case(name.substr(dot + 1));
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
  const std::string first = lower_case(std::string(scanner.word('#').substr(0, 6)));
  if (first == "off" || first == "coff" || first == "noff" || first == "cnoff" || first == "stoff")
    return "off";
  if (first == "solid") {
    scanner.next_line();
    const std::string second = lower_case(std::string(scanner.word().substr(0, 9)));
    if (second == "facet" || second == "endsolid") return "stl";
  }
  return "";
}

[[noreturn]] void fail_unknown(const std::string& path, const std::string& ending,
                               const char* known_endings) {
  throw InputError(fmt::format("{}: {}, expected a surface as {}", path,
                               ending.empty() ? "no ending" : fmt::format("unknown ending '.{}'", ending),
                               known_endings));
}

bool is_known(const std::string& format) {
  return format == "stl" || format == "off" || format == "obj" || format == "ply";
}

}  // namespace

bool is_surface_file(const std::string& path) {
  return is_known(ending_of(path));
}

TriangleSurface read_surface(const std::string& path) {
  std::string format = ending_of(path);
  if (format == "msh") return io::welded_surface(read_document(path));
  const InputFile file(path);
  if (!is_known(format)) format = format_of_content(file);
  if (format == "stl") return io::read_stl(file);
  if (format == "off") return io::read_off(file);
  if (format == "obj") return io::read_obj(file);
  if (format == "ply") return io::read_ply(file);
  fail_unknown(path, ending_of(path), ".stl, .off, .obj, .ply or .msh");
}

void write_surface(const std::string& path, const TriangleSurface& surface,
                   const SurfaceWriteOptions& options) {
  const std::string format = options.format.empty() ? ending_of(path) : options.format;
  if (!is_known(format)) {
    if (options.format.empty()) fail_unknown(path, format, ".stl, .off, .obj or .ply");
    throw InputError(fmt::format("unknown surface format '{}', expected stl, off, obj or ply", format));
  }
  const auto vertices = static_cast<Index>(surface.vertices.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const Index corner : surface.triangles[t])
      if (corner < 0 || corner >= vertices)
        throw InputError(fmt::format("{}: cannot write triangle {}: vertex {} of {} vertices does not exist",
                                     path, t, corner, vertices));
  AtomicFile file(path);
  if (format == "stl")
    (options.ascii ? io::write_stl_text : io::write_stl_binary)(file, surface);
  else if (format == "off")
    io::write_off(file, surface);
  else if (format == "obj")
    io::write_obj(file, surface);
  else
    (options.ascii ? io::write_ply_text : io::write_ply_binary)(file, surface);
  file.commit();
}

}  // namespace tetproof
