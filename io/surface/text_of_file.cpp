// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/text_of_file.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "io/bytes/scanner.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {

std::string_view text_of_file(const InputFile& file, Document& document) {
  const std::string_view bytes = file.bytes();
  const std::size_t last = bytes.find_last_not_of('\0');
  const std::size_t size = last == bytes.npos ? 0 : last + 1;
  if (size < bytes.size())
    document.warnings.push_back(fmt::format("{}: byte {}: {} zero bytes at the end are passed over",
                                            file.path(), size, bytes.size() - size));
  return bytes.substr(0, size);
}

Scanner start_of_text(const InputFile& file, std::string_view text) {
  return {file.path(), text, text.starts_with("\xEF\xBB\xBF") ? std::size_t{3} : std::size_t{0}};
}

std::string example_line(const std::string& path, std::string_view text, std::size_t place) {
  const std::size_t end = std::min(text.find_first_of("\r\n", place), text.size());
  return fmt::format("line {}: {}", Scanner(path, text, place).line(),
                     shown_name(text.substr(place, end - place)));
}

}  // namespace tetproof::io
