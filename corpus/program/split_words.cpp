// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/program/split_words.hpp"

#include <fmt/core.h>

#include "io/error.hpp"

namespace tetproof::corpus {

std::vector<std::string> split_words(const std::string& text) {
  std::vector<std::string> words;
  bool inside = false;  // of a word, which may be empty: ''
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote == 0 && (c == ' ' || c == '\t' || c == '\n')) {
      inside = false;
      continue;
    }
    if (!inside) words.emplace_back();
    inside = true;
    const bool escapes =
        quote == 0 || (quote == '"' && i + 1 < text.size() && (text[i + 1] == '"' || text[i + 1] == '\\'));
    if (c == quote)
      quote = 0;
    else if (quote == 0 && (c == '\'' || c == '"'))
      quote = c;
    else if (c == '\\' && escapes && i + 1 < text.size())
      words.back() += text[++i];
    else
      words.back() += c;
  }
  if (quote != 0) throw InputError(fmt::format("'{}': the quote {} has no end", text, quote));
  return words;
}

}  // namespace tetproof::corpus
