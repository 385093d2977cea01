// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts output into lines and takes from them what changes from run to run.
#include "corpus/meshing/output_lines.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tetproof::corpus {

namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (lower(c) >= 'a' && lower(c) <= 'z') || c == '_';
}
bool is_hex(char c) {
  return is_digit(c) || (lower(c) >= 'a' && lower(c) <= 'f');
}

std::string plain(std::string_view line) {
  std::string result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\x1b') {  // a colour: ESC [ numbers letter
      while (i + 1 < line.size() && !is_letter(line[i])) ++i;
    } else if (line[i] == '\r') {
      if (i + 1 < line.size()) result.clear();
    } else {
      result += static_cast<unsigned char>(line[i]) < ' ' || line[i] == 0x7f ? ' ' : line[i];
    }
  }
  return result;
}

/// Where the number that starts at `at` ends.
std::size_t number_end(std::string_view text, std::size_t at) {
  if (text.compare(at, 2, "0x") == 0) {
    at += 2;
    while (at < text.size() && is_hex(text[at])) ++at;
    return at;
  }
  const auto digits = [&] {
    while (at < text.size() && is_digit(text[at])) ++at;
  };
  digits();
  if (at + 1 < text.size() && text[at] == '.' && is_digit(text[at + 1])) {
    ++at;
    digits();
  }
  if (at + 1 < text.size() && lower(text[at]) == 'e') {
    const bool sign = text[at + 1] == '-' || text[at + 1] == '+';
    if (at + 1 + sign < text.size() && is_digit(text[at + 1 + sign])) {
      at += 1 + sign;
      digits();
    }
  }
  return at;
}

}  // namespace

std::vector<std::string> output_lines(std::string_view output) {
  std::vector<std::string> lines;
  while (!output.empty()) {
    const std::size_t end = std::min(output.find('\n'), output.size());
    lines.push_back(plain(output.substr(0, end)));
    output.remove_prefix(std::min(end + 1, output.size()));
  }
  return lines;
}

bool says(std::string_view text, std::string_view part) {
  return std::search(text.begin(), text.end(), part.begin(), part.end(),
                     [](char a, char b) { return lower(a) == b; }) != text.end();
}

std::string without_numbers(std::string_view line) {
  // Words with a slash keep what follows the last one: "/tmp/x/mesh.geo" is a path, and so is "a/b".
  std::string text;
  for (std::size_t i = 0; i < line.size();) {
    if (line[i] == ' ') {
      if (!text.empty() && text.back() != ' ') text += ' ';
      ++i;
      continue;
    }
    const std::size_t end = std::min(line.find(' ', i), line.size());
    std::string_view word = line.substr(i, end - i);
    const std::size_t slash = word.rfind('/');
    if (slash != std::string_view::npos && slash + 1 < word.size()) {
      const std::size_t quotes = std::min(word.find_first_not_of("'\"`(["), word.size());
      text += word.substr(0, std::min(quotes, slash));
      word.remove_prefix(slash + 1);
    }
    text += word;
    i = end;
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const bool in_word = i > 0 && (is_letter(text[i - 1]) || is_digit(text[i - 1]));
    if (!is_digit(text[i]) || in_word) {
      result += text[i++];
      continue;
    }
    const std::size_t end = number_end(text, i);
    result += text.compare(i, 2, "0x") == 0 ? "ADDRESS" : "#";
    if (result.size() > 1 && result.back() == '#' && (result[result.size() - 2] == '-') &&
        (result.size() == 2 || !is_letter(result[result.size() - 3])))
      result.erase(result.size() - 2, 1);  // a sign
    i = end;
  }
  if (result.size() > 160) result.resize(160);
  return result;
}

}  // namespace tetproof::corpus
