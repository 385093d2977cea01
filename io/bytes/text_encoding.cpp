// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes/text_encoding.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

#include "io/bytes/words.hpp"
#include "io/error.hpp"

namespace tetproof::io {
namespace {

// Whether the first characters are ASCII, each of so many bytes with one that is not 0, at `place`.
bool is_wide_ascii(std::string_view bytes, std::size_t width, std::size_t place) {
  const std::size_t characters = std::min<std::size_t>(bytes.size() / width, 16);
  for (std::size_t c = 0; c < characters; ++c)
    for (std::size_t k = 0; k < width; ++k) {
      const auto byte = static_cast<unsigned char>(bytes[c * width + k]);
      const bool text = (byte >= ' ' && byte < 0x7F) || (byte >= '\t' && byte <= '\r');
      if (k == place ? !text : byte != 0) return false;
    }
  return characters >= 4;
}

}  // namespace

std::size_t end_of_text(std::string_view bytes) {
  std::size_t end = bytes.size();
  // Line ends between them belong to the rest; those in front of the first one to the text.
  for (std::size_t i = end; i > 0; --i) {
    const char c = bytes[i - 1];
    if (c == '\0' || c == '\x1A')
      end = i - 1;
    else if (c != '\n' && c != '\r')
      break;
  }
  return end;
}

std::string warning_of_end(const InputFile& file) {
  const std::string_view bytes = file.bytes();
  const std::size_t end = end_of_text(bytes);
  if (end == bytes.size()) return {};
  const std::string_view rest = bytes.substr(end);
  const std::size_t zeros = static_cast<std::size_t>(std::count(rest.begin(), rest.end(), '\0'));
  const std::size_t marks = static_cast<std::size_t>(std::count(rest.begin(), rest.end(), '\x1A'));
  std::string what = zeros > 0 ? counted(zeros, "zero bytes") : "";
  if (marks > 0) what += (zeros > 0 ? " and " : "") + std::string("^Z");
  return fmt::format("{}: byte {}: {} at the end {} passed over", file.path(), end, what,
                     zeros + marks == 1 ? "is" : "are");
}

void refuse_wide_text(const InputFile& file) {
  const std::string_view bytes = file.bytes();
  const struct {
    std::string_view mark;
    std::size_t width, place;  // of characters, and of ASCII in them
    const char* name;
  } kinds[]{{std::string_view("\xFF\xFE\0\0", 4), 4, 0, "UTF-32"},
            {std::string_view("\0\0\xFE\xFF", 4), 4, 3, "UTF-32"},
            {"\xFF\xFE", 2, 0, "UTF-16"},
            {"\xFE\xFF", 2, 1, "UTF-16"}};
  for (const auto& kind : kinds) {
    const std::string_view text = bytes.starts_with(kind.mark) ? bytes.substr(kind.mark.size()) : bytes;
    if (is_wide_ascii(text, kind.width, kind.place))
      throw InputError(fmt::format("{}: text in {}, which no mesh format has; save it as UTF-8 or ASCII",
                                   file.path(), kind.name));
  }
}

}  // namespace tetproof::io
