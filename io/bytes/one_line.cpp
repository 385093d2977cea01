// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes/one_line.hpp"

#include <fmt/core.h>

#include <cstdint>

namespace tetproof::io {
namespace {

// A character of a text in UTF-8 and the number of its bytes; no bytes: the text does not start with one.
struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;
};

Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80) return {byte(0), 1};
  const std::size_t bytes = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < bytes) return {};
  std::uint32_t code = byte(0) & (0xFFU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3FU);
  }
  // Each character has one form only, and halves of pairs are none.
  constexpr std::uint32_t least[]{0, 0, 0x80, 0x800, 0x10000};
  if (code < least[bytes] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return {};
  return {code, bytes};
}

bool is_control(std::uint32_t code) {
  return code < ' ' || (code >= 0x7F && code < 0xA0) || code == 0x2028 || code == 0x2029 ||  // lines
         code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||           // directions
         (code >= 0x2066 && code <= 0x2069) || code == 0xFEFF;
}

}  // namespace

std::string in_one_line(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  while (!text.empty()) {
    const Character c = first_character(text);
    const std::size_t bytes = c.bytes == 0 ? 1 : c.bytes;
    if (c.bytes == 0)
      line += fmt::format("\\x{:02X}", static_cast<unsigned char>(text[0]));
    else if (is_control(c.code))
      line += c.code < 0x100 ? fmt::format("\\x{:02X}", c.code) : fmt::format("\\u{:04X}", c.code);
    else
      line.append(text.substr(0, bytes));
    text.remove_prefix(bytes);
  }
  return line;
}

std::string start_in_one_line(std::string_view text, std::size_t most) {
  if (text.size() <= most) return in_one_line(text);
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return in_one_line(text.substr(0, most)) + "...";
}

std::string escape_controls_of_json(std::string_view json) {
  std::string text;
  text.reserve(json.size());
  while (!json.empty()) {
    const Character c = first_character(json);
    const std::size_t bytes = c.bytes == 0 ? 1 : c.bytes;
    if (c.bytes != 0 && c.code >= ' ' && is_control(c.code))
      text += fmt::format("\\u{:04x}", c.code);
    else
      text.append(json.substr(0, bytes));
    json.remove_prefix(bytes);
  }
  return text;
}

}  // namespace tetproof::io
