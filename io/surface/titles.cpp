// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/titles.hpp"
#include "io/bytes/scanner.hpp"

namespace tetproof::io {

std::string leading_comments(Scanner scanner) {
  std::string title;
  bool first = true;
  while (scanner.remaining() > 0) {
    if (scanner.at_line_end()) {
      scanner.next_line();
      continue;
    }
    const std::string_view line = scanner.rest_of_line();
    if (line[0] != '#') break;
    title.append(first ? "" : "\n").append(line.substr(line.starts_with("# ") ? 2 : 1));
    first = false;
  }
  return title;
}

std::vector<std::string> title_lines(const std::string& title) {
  std::vector<std::string> lines;
  if (title.empty()) return lines;
  for (std::size_t from = 0;;) {
    const std::size_t end = title.find('\n', from);
    lines.push_back(title.substr(from, end - from));
    if (end == title.npos) return lines;
    from = end + 1;
  }
}

bool title_in_lines(const std::string& title) {
  return title.find('\r') == title.npos;  // a CR ends a line
}

}  // namespace tetproof::io
