// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/program/files_in_use.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "io/bytes/atomic_file.hpp"
#include "io/error.hpp"
#include "io/medit/medit_solution.hpp"
#include "io/tetgen/tetgen_files.hpp"

namespace tetproof::program {
namespace {

bool is_tetgen(const std::string& format) {
  return format == "tetgen" || format == "poly" || format == "smesh";
}

// The format that a file is read as, if an option or its ending says it.
std::string format_to_read(const std::string& path, const ReadOptions& options) {
  if (!options.format.empty()) return options.format;
  const std::string ending = ending_of(path);
  for (const Format& format : formats())
    for (const auto* endings : {&format.endings, &format.endings_beside})
      if (std::find(endings->begin(), endings->end(), ending) != endings->end()) return format.name;
  return {};
}

// Equal for two paths that lead to the same file. Empty for devices and sockets, which have no content that
// an output could replace.
std::string identity_of(const std::string& path, bool output) {
  struct stat file {};
  const bool exists = path == "-" ? ::fstat(output ? STDOUT_FILENO : STDIN_FILENO, &file) == 0
                                  : ::stat(path.c_str(), &file) == 0;
  if (exists)
    return S_ISREG(file.st_mode) || S_ISFIFO(file.st_mode) ? fmt::format("{} {}", file.st_dev, file.st_ino)
                                                           : std::string();
  const std::filesystem::path place = std::filesystem::absolute(path);
  std::error_code missing;
  const std::filesystem::path folder = std::filesystem::canonical(place.parent_path(), missing);
  return ((missing ? place.parent_path().lexically_normal() : folder) / place.filename()).string();
}

std::string named(const std::string& argument, const std::string& path) {
  return fmt::format("{} ({})", path, argument);
}

}  // namespace

FilesInUse::FilesInUse(const Common& common) {
  writes("--json", common.json);
}

void FilesInUse::reads(const std::string& argument, const std::string& path) {
  add({argument, path, false, identity_of(path, false)});
}

void FilesInUse::reads_mesh(const std::string& argument, const std::string& path,
                            const ReadOptions& options) {
  const std::string format = path == "-" ? "" : format_to_read(path, options);
  if (is_tetgen(format))
    for (const std::string& file : io::tetgen_files_read(path)) reads(argument, file);
  else if (format == "medit")
    for (const std::string& file : io::medit_files_read(path)) reads(argument, file);
  else
    reads(argument, path);
}

void FilesInUse::writes(const std::string& argument, const std::string& path) {
  if (path.empty()) return;
  add({argument, path, true, identity_of(path, true)});
  if (path != "-") check_creatable(path);
}

void FilesInUse::writes_mesh(const std::string& argument, const std::string& path,
                             const WriteOptions& options) {
  if (path.empty()) return;
  if (path == "-")
    throw InputError(fmt::format("{}: a mesh is not written to standard output; name a file", argument));
  const std::string format = encoding_of(path, options).format;
  if (!is_tetgen(format)) return writes(argument, path);
  for (const std::string& file : io::tetgen_files_always_written(path, format)) writes(argument, file);
}

void FilesInUse::writes_mesh(const std::string& argument, PlannedFile& output) {
  for (const std::string& file : output.files()) writes(argument, file);
}

bool FilesInUse::standard_output_is_taken() const {
  return std::any_of(uses_.begin(), uses_.end(),
                     [](const Use& use) { return use.output && use.path == "-"; });
}

void FilesInUse::add(Use use) {
  for (const Use& other : uses_) {
    if (other.argument == use.argument && other.output == use.output) continue;  // one set, or told again
    if (use.path == "-" && other.path == "-" && use.output == other.output)
      throw InputError(fmt::format("{} - and {} -: only one of them {} standard {}", other.argument,
                                   use.argument, use.output ? "fits on" : "can be",
                                   use.output ? "output" : "input"));
    if (use.identity.empty() || use.identity != other.identity || !(use.output || other.output)) continue;
    const Use& output = use.output ? use : other;
    const Use& rest = use.output ? other : use;
    throw InputError(fmt::format("{} is the same file as {}: {}", named(output.argument, output.path),
                                 named(rest.argument, rest.path),
                                 rest.output ? "each output needs a file of its own"
                                             : "an output may not take the place of an input"));
  }
  uses_.push_back(std::move(use));
}

}  // namespace tetproof::program
