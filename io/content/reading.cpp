// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/content/reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "io/bytes/one_line.hpp"
#include "io/bytes/text_encoding.hpp"
#include "io/codecs.hpp"
#include "io/content/content.hpp"
#include "io/error.hpp"
#include "io/gmsh/gmsh_import.hpp"

namespace tetproof::io {
namespace {

bool contains(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

bool has_ending(const Format& format, const std::string& ending) {
  return contains(format.endings, ending) || contains(format.endings_beside, ending);
}

// The format that the ending of a name stands for; empty: none, or one that Gmsh reads.
std::string format_of_ending(const std::string& ending) {
  for (const Format& format : formats())
    if (has_ending(format, ending)) return format.name;
  return {};
}

[[noreturn]] void refuse_unknown(const InputFile& file, const std::string& ending) {
  const std::string name = !file.is_named() ? ""
                           : ending.empty() ? "no ending, and "
                                            : "unknown ending, and ";
  throw InputError(
      fmt::format("{}: {}the content tells no format; expected one of {}{}", file.path(), name,
                  fmt::join(known_endings(), " "),
                  file.is_named() ? fmt::format("; through Gmsh {}", fmt::join(gmsh_endings(), " ")) : ""));
}

// Reads a file whose content overrules its ending. Both the warning and an error say so.
ReadDocument read_against_ending(const Content& content, const std::string& ending, const InputFile& file,
                                 Wanted wanted) {
  const std::string note =
      fmt::format(" (read as {} because of its content, though its name ends in {})", content.what, ending);
  try {
    ReadDocument read = read_as(content.format, file, wanted);
    read.document.warnings.insert(
        read.document.warnings.begin(),
        fmt::format("{}: {} by its content, though its name ends in {}", file.path(), content.what, ending));
    read.read_as = note;
    return read;
  } catch (const InputError& error) {
    throw InputError(error.what() + note);
  }
}

ReadDocument read_by_content(const InputFile& file, const ReadOptions& options, Wanted wanted) {
  const std::vector<Content> contents = own_contents(file.bytes());
  if (contents.empty()) refuse_wide_text(file);
  if (!options.format.empty()) return read_as(format_named(options.format).name, file, wanted);
  const std::string ending = file.is_named() ? ending_of(file.path()) : "";
  const std::string by_ending = format_of_ending(ending);
  const bool through_gmsh = contains(gmsh_endings(), ending);
  for (const Content& content : contents)
    if (has_ending(format_named(content.format), ending)) return read_as(content.format, file, wanted);
  if (!contents.empty()) {
    const Content& content = contents.front();
    if (by_ending.empty() && !through_gmsh) return read_as(content.format, file, wanted);
    return read_against_ending(content, ending, file, wanted);
  }
  if (through_gmsh) return {read_through_gmsh(file.path())};
  if (const std::optional<Content> foreign = foreign_content(file.bytes(), ending))
    throw InputError(
        fmt::format("{}: {}, which is not read; {}", file.path(), foreign->what, foreign->advice));
  if (by_ending.empty()) refuse_unknown(file, ending);
  return read_as(by_ending, file, wanted);
}

}  // namespace

InputFile open_input(const std::string& path) {
  return path == "-" ? InputFile::standard_input() : InputFile(path);
}

ReadDocument read_file(const InputFile& file, const ReadOptions& options, Wanted wanted) {
  ReadDocument read = read_by_content(file, options, wanted);
  for (std::string& warning : read.document.warnings) warning = in_one_line(warning);
  return read;
}

}  // namespace tetproof::io
