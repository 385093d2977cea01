// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/atomic_file.hpp"
#include "io/error.hpp"
#include "io/msh.hpp"
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

}  // namespace

const std::vector<Format>& formats() {
  static const std::vector<Format> all{
      {.name = "msh41", .what = "Gmsh .msh 4.1", .endings = {".msh"}, .reads = true},
      {.name = "msh22", .what = "Gmsh .msh 2.2", .endings = {".msh"}, .reads = true},
      {.name = "vtu", .what = "VTK XML unstructured grid", .endings = {".vtu"}},
  };
  return all;
}

const Format& format_of(const std::string& path) {
  const std::string ending = ending_of(path);
  std::vector<std::string> known;
  for (const Format& format : formats())
    for (const std::string& e : format.endings) {
      if (e == ending) return format;
      known.push_back(e);
    }
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

Document read_document(const std::string& path) {
  const Format& format = format_of(path);
  if (format.name == "msh41") return io::read_msh(InputFile(path));
  throw InputError(fmt::format("{}: {} cannot be read yet", path, format.what));
}

void write_document(const std::string& path, const Document& document, const WriteOptions& options) {
  const Format& format = options.format.empty() ? format_of(path) : format_named(options.format);
  AtomicFile file(path);
  if (format.name == "msh41")
    io::write_msh41(file, document, options.binary.value_or(false));
  else if (format.name == "msh22")
    io::write_msh22(file, document, options.binary.value_or(false));
  else if (format.name == "vtu")
    io::write_vtu(file, document, options.binary.value_or(true));
  file.commit();
}

}  // namespace tetproof
