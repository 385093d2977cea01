// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface_files.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "io/atomic_file.hpp"
#include "io/error.hpp"
#include "io/input_file.hpp"
#include "io/obj.hpp"
#include "io/off.hpp"
#include "io/ply.hpp"
#include "io/stl.hpp"

namespace tetproof {
namespace {

// The ending in lower case without its dot; empty if there is none.
std::string ending_of(const std::string& path) {
  const std::string name = path.substr(path.find_last_of('/') + 1);
  const std::size_t dot = name.find_last_of('.');
  std::string ending = dot == name.npos ? "" : name.substr(dot + 1);
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
  return ending;
}

}  // namespace

bool is_surface_file(const std::string& path) {
  const std::string ending = ending_of(path);
  return ending == "stl" || ending == "off" || ending == "obj" || ending == "ply";
}

TriangleSurface read_surface(const std::string& path) {
  const InputFile file(path);
  const std::string ending = ending_of(path);
  if (ending == "off") return io::read_off(file);
  if (ending == "obj") return io::read_obj(file);
  if (ending == "stl") return io::read_stl(file);
  if (ending == "ply") return io::read_ply(file);
  throw InputError(fmt::format("{}: expected a surface as .stl, .off, .obj or .ply", path));
}

void write_surface(const std::string& path, const TriangleSurface& surface,
                   const SurfaceWriteOptions& options) {
  const std::string format = options.format.empty() ? ending_of(path) : options.format;
  if (format != "off" && format != "obj")
    throw InputError(fmt::format("{}: expected a surface as .stl, .off, .obj or .ply", path));
  AtomicFile file(path);
  if (format == "off") io::write_off(file, surface);
  if (format == "obj") io::write_obj(file, surface);
  file.commit();
}

}  // namespace tetproof
