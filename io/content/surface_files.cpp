// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface_files.hpp"

#include <fmt/format.h>

#include "io/content/reading.hpp"
#include "io/error.hpp"
#include "io/surface/document_surface.hpp"

namespace tetproof {
namespace {

// The format that the ending names: stl, ...; empty if there is no ending.
std::string format_of_name(const std::string& path) {
  const std::string ending = ending_of(path);
  return ending.empty() ? ending : ending.substr(1);
}

bool is_known(const std::string& format) {
  return format == "stl" || format == "off" || format == "obj" || format == "ply";
}

[[noreturn]] void fail_unknown(const std::string& path) {
  const std::string ending = ending_of(path);
  throw InputError(fmt::format("{}: {}, expected a surface as .stl, .off, .obj or .ply", path,
                               ending.empty() ? "no ending" : fmt::format("unknown ending '{}'", ending)));
}

}  // namespace

bool is_surface_file(const std::string& path) {
  return is_known(format_of_name(path));
}

SurfaceFile read_surface_file(const std::string& path, const ReadOptions& options) {
  InputFile file = io::open_input(path);
  file.report_to(options.progress);
  io::ReadDocument read = io::read_file(file, options, io::Wanted::surface);
  std::vector<std::string> warnings = std::move(read.document.warnings);
  std::vector<Loss> dropped = std::move(read.document.dropped);
  const std::string read_as = std::move(read.read_as);
  try {
    SurfaceNumbering numbering;
    TriangleSurface surface = io::surface_of_read(std::move(read), file, numbering, warnings);
    return {std::move(surface), std::move(numbering), std::move(warnings), std::move(dropped)};
  } catch (const InputError& error) {
    throw InputError(error.what() + read_as);
  }
}

TriangleSurface read_surface(const std::string& path, const ReadOptions& options) {
  return read_surface_file(path, options).surface;
}

void write_surface(const std::string& path, const TriangleSurface& surface,
                   const SurfaceWriteOptions& options) {
  const std::string format = options.format.empty() ? format_of_name(path) : options.format;
  if (!is_known(format)) {
    if (options.format.empty()) fail_unknown(path);
    throw InputError(fmt::format("unknown surface format '{}', expected stl, off, obj or ply", format));
  }
  const auto vertices = static_cast<Index>(surface.vertices.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const Index corner : surface.triangles[t])
      if (corner < 0 || corner >= vertices)
        throw InputError(fmt::format("{}: cannot write triangle {}: vertex {} of {} vertices does not exist",
                                     path, t, corner, vertices));
  WriteOptions write{.format = format};
  if (format_named(format).binary) write.binary = !options.ascii;
  const Document document = document_of(surface);
  write_document(path, document, write);
}

}  // namespace tetproof
