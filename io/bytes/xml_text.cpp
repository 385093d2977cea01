// SPDX-License-Identifier: GPL-3.0-or-later
// Escapes text for XML and checks that XML can hold it.
#include "io/bytes/xml_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

namespace tetproof::io {
namespace {

// The length of the UTF-8 character at the start of `bytes`; 0 if there is none that XML 1.0 permits.
std::size_t character(std::string_view bytes) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return lead >= 0x20 || lead == '\t' || lead == '\n' || lead == '\r' ? 1 : 0;
  const std::size_t size = lead >= 0xC2 && lead < 0xE0   ? 2
                           : lead >= 0xE0 && lead < 0xF0 ? 3
                           : lead >= 0xF0 && lead < 0xF5 ? 4
                                                         : 0;
  if (size == 0 || size > bytes.size()) return 0;
  std::uint32_t code = lead & (0x7Fu >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  constexpr std::uint32_t least[]{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  return code < least[size] || surrogate || code == 0xFFFE || code == 0xFFFF || code > 0x10FFFF ? 0 : size;
}

}  // namespace

bool is_xml_text(std::string_view text) {
  for (std::size_t size; !text.empty(); text.remove_prefix(size))
    if ((size = character(text)) == 0) return false;
  return true;
}

std::string xml_escaped(std::string_view text, XmlLines lines) {
  std::string safe;
  while (!text.empty()) {
    const std::size_t size = character(text);
    const char c = text[0];
    if (size == 0)
      safe += "\xEF\xBF\xBD";
    else if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '"')
      safe += "&quot;";
    else if (c == '\r' || (lines == XmlLines::in_attribute && (c == '\n' || c == '\t')))
      safe += fmt::format("&#{};", static_cast<int>(c));
    else
      safe += text.substr(0, size);
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return safe;
}

}  // namespace tetproof::io
