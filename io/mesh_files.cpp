// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/bytes/input_file.hpp"
#include "io/bytes/tokens.hpp"
#include "io/codecs.hpp"
#include "io/content/reading.hpp"
#include "io/error.hpp"

namespace tetproof {
namespace {

const Format* format_with(const std::string& ending) {
  for (const Format& format : formats())
    if (std::find(format.endings.begin(), format.endings.end(), ending) != format.endings.end())
      return &format;
  return nullptr;
}

}  // namespace

const std::vector<Format>& formats() {
  static const std::vector<Format> all = [] {
    std::vector<Format> list;
    for (const io::Codec& codec : io::codecs()) list.push_back(codec.format);
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
  InputFile file = io::open_input(path);
  file.report_to(options.progress);
  return io::read_file(file, options, io::Wanted::document).document;
}

Document read_document_in_memory(std::string_view bytes, const ReadOptions& options,
                                 const std::string& name) {
  return io::read_file(InputFile::in_memory(bytes, name), options, io::Wanted::document).document;
}

}  // namespace tetproof
