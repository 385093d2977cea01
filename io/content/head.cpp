// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/content/head.hpp"
#include "io/bytes/scanner.hpp"

#include <algorithm>
#include <string>

namespace tetproof::io {

std::string_view head_text(std::string_view bytes) {
  bytes = bytes.substr(0, head_bytes);
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n\v\f"), bytes.size()));
  return bytes;
}

Scanner head_scanner(std::string_view bytes) {
  static const std::string no_path;
  return {no_path, head_text(bytes)};
}

std::string_view first_tag(std::string_view bytes) {
  std::string_view text = head_text(bytes);
  while (text.starts_with("<?") || text.starts_with("<!--")) {
    const std::string_view close = text.starts_with("<?") ? "?>" : "-->";
    const std::size_t end = text.find(close);
    if (end == text.npos) return {};
    text = head_text(text.substr(end + close.size()));
  }
  return text.starts_with('<') ? text : std::string_view();
}

}  // namespace tetproof::io
