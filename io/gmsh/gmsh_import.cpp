// SPDX-License-Identifier: GPL-3.0-or-later
// Starts tetproof-gmsh-import, and reads what it wrote and said.
#include "io/gmsh/gmsh_import.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "io/bytes/input_file.hpp"
#include "io/bytes/scanner.hpp"
#include "io/error.hpp"
#include "io/gmsh/gmsh_import_process.hpp"
#include "io/loss/loss_list.hpp"
#include "io/mesh_files.hpp"
#include "io/msh/msh.hpp"

namespace tetproof::io {
namespace {

constexpr const char* helper_name = "tetproof-gmsh-import";

// Gmsh reads a file with an unknown ending as a script, and does not know .Step or .BREP.
void check_case(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string(), lower = ending_of(path);
  const bool has_lower =
      std::any_of(ending.begin(), ending.end(), [](char c) { return c >= 'a' && c <= 'z'; });
  if (ending != lower && (has_lower || lower == ".brep"))
    throw InputError(fmt::format("{}: Gmsh does not know the ending {}: call it {}", path, ending, lower));
}

std::string find_helper(const std::string& path) {
  std::vector<std::string> places;
  if (const char* said = std::getenv("TETPROOF_GMSH_IMPORT"); said && *said) {
    places = {said};
  } else {
    std::error_code ignored;
    const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    places = {(own / helper_name).string(),
              (own / TETPROOF_LIBEXEC_FROM_BIN / helper_name).lexically_normal().string(),
              TETPROOF_LIBEXEC "/" + std::string(helper_name)};
  }
  for (const std::string& place : places)
    if (::access(place.c_str(), X_OK) == 0 && !std::filesystem::is_directory(place)) return place;
  throw InputError(
      fmt::format("{}: {} is read through Gmsh by the program {}, expected at {} (the environment "
                  "variable TETPROOF_GMSH_IMPORT says where it is)",
                  path, ending_of(path), helper_name, fmt::join(places, " or ")));
}

std::chrono::milliseconds allowed_time() {
  const char* said = std::getenv("TETPROOF_GMSH_TIMEOUT");
  if (!said || !*said) return std::chrono::minutes(10);
  double seconds = 0;
  if (!parse_real(said, seconds) || !(seconds > 0) || seconds > 1e9)
    throw InputError(
        fmt::format("TETPROOF_GMSH_TIMEOUT: expected seconds above 0 and up to 1e9, found '{}'", said));
  return std::chrono::milliseconds(std::llround(std::ceil(1e3 * seconds)));
}

// The lines that Gmsh and the helper program said, by kind.
struct Talk {
  std::vector<std::string> errors, warnings, dropped;

  explicit Talk(const std::string& said) {
    for (std::size_t at = 0; at < said.size();) {
      const std::size_t end = std::min(said.find('\n', at), said.size());
      const std::string line = said.substr(at, end - at);
      at = end + 1;
      take("Error   : ", line, errors);
      take("Warning : ", line, warnings);
      take("Dropped : ", line, dropped);
    }
  }
  static void take(std::string_view kind, const std::string& line, std::vector<std::string>& all) {
    if (line.starts_with(kind)) all.push_back(line.substr(kind.size()));
  }
};

// What the loader says of a library that is not there; empty: the program started.
std::string missing_library(const std::string& said) {
  constexpr std::string_view words = "error while loading shared libraries: ";
  const std::size_t at = said.find(words);
  if (at == std::string::npos) return "";
  return said.substr(at + words.size(), said.find('\n', at) - at - words.size());
}

// Scripts, and files with thousands of bad elements, can cause warnings without end.
void tell_warnings(const std::string& path, const std::vector<std::string>& said, Document& document) {
  constexpr std::size_t most = 20;
  for (std::size_t i = 0; i < said.size() && i < most; ++i)
    document.warnings.push_back(fmt::format("{}: Gmsh: {}", path, said[i]));
  if (said.size() > most)
    document.warnings.push_back(fmt::format("{}: Gmsh: {} more warnings", path, said.size() - most));
}

// The helper's lines are "COUNT, ITEM, EXAMPLE". Others are Gmsh's own, if any begin like that.
void list_dropped(const std::vector<std::string>& said, Document& document) {
  for (const std::string& line : said) {
    const std::size_t item = line.find(", "), example = line.find(", ", item + 1);
    std::int64_t count = 0;
    if (example != std::string::npos && parse_integer(line.substr(0, item), count) && count > 0)
      add_loss(document.dropped, line.substr(item + 2, example - item - 2), static_cast<std::size_t>(count),
               line.substr(example + 2));
  }
}

}  // namespace

const std::vector<std::string>& gmsh_endings() {
  static const std::vector<std::string> all{
      ".geo", ".geo_unrolled", ".step", ".stp",  ".iges", ".igs", ".brep", ".brp",  ".unv", ".bdf", ".nas",
      ".dat", ".diff",         ".p3d",  ".ply2", ".wrl",  ".pos", ".med",  ".cgns", ".sat", ".x_t"};
  return all;
}

Document read_through_gmsh(const std::string& path) {
  { const InputFile there(path); }  // Gmsh does not report a missing file
  check_case(path);
  const std::string helper = find_helper(path);
  const auto allowed = allowed_time();
  ProcessEnd end;
  std::string what;
  Document document;
  try {
    const NamelessFile mesh;
    end = run_process({helper, path, shared_file, fmt::format("{}", ::getpid())}, mesh.descriptor(), allowed);
    const Talk talk(end.said);
    if (end.too_late)
      what = fmt::format(
          "Gmsh is not done after {} s (the environment variable TETPROOF_GMSH_TIMEOUT says how "
          "long it may take)",
          std::chrono::duration<double>(allowed).count());
    else if (end.signal != 0)
      what = fmt::format("Gmsh crashes on it (signal {}, {})", end.signal, ::strsignal(end.signal));
    else if (!talk.errors.empty())
      what = fmt::format("Gmsh: {}", talk.errors[0]);
    else if (const std::string library = missing_library(end.said); end.exit_code == 127 && !library.empty())
      what = fmt::format("{} is read through Gmsh, whose library is not installed: {}", ending_of(path),
                         library);
    else if (end.exit_code != 0)
      what = fmt::format("{} ends with code {}", helper, end.exit_code);
    if (!what.empty()) throw InputError(path + ": " + what);
    try {
      document = read_msh(InputFile(mesh.path()));
    } catch (const InputError& error) {  // for example because of a full disk, which Gmsh does not report
      throw InputError(fmt::format("{}: what Gmsh made of it cannot be read: {}", path, error.what()));
    }
    for (std::string& warning : document.warnings)
      if (warning.starts_with(mesh.path()))
        warning.replace(0, mesh.path().size(), path + ", as Gmsh wrote it");
    tell_warnings(path, talk.warnings, document);
    list_dropped(talk.dropped, document);
  } catch (const std::system_error& error) {
    throw InputError(fmt::format("{}: cannot be read through Gmsh: {}", path, error.what()));
  }
  document.path = path;
  document.format = "gmsh:" + ending_of(path).substr(1);
  return document;
}

}  // namespace tetproof::io
