// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace tetproof::corpus {

std::string printable(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = '?';
  return text;
}

std::string text_table(const TextRows& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (c == widths.size()) widths.push_back(0);
      widths[c] = std::max(widths[c], row[c].size());
    }
  std::string text;
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string cell = printable(row[c]);
      text += c == 0 ? fmt::format("{:<{}}", cell, widths[c]) : fmt::format("  {:>{}}", cell, widths[c]);
      if (c + 1 == row.size()) text += "\n";
    }
  return text;
}

}  // namespace tetproof::corpus
