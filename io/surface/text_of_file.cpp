// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/text_of_file.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "io/bytes/scanner.hpp"
#include "io/bytes/text_encoding.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {

std::string_view text_of_file(const InputFile& file, Document& document) {
  if (const std::string warning = warning_of_end(file); !warning.empty())
    document.warnings.push_back(warning);
  return file.bytes().substr(0, end_of_text(file.bytes()));
}

Scanner start_of_text(const InputFile& file, std::string_view text) {
  return {file.path(), text, start_of_utf8(text)};
}

std::string example_line(const std::string& path, std::string_view text, std::size_t place) {
  const std::size_t end = std::min(text.find_first_of("\r\n", place), text.size());
  return fmt::format("line {}: {}", Scanner(path, text, place).line(),
                     shown_name(text.substr(place, end - place)));
}

}  // namespace tetproof::io
