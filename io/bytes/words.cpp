// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes/words.hpp"

#include <algorithm>

namespace tetproof::io {

std::string singular(std::string_view many) {
  std::string text(many);
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    const std::string_view word = std::string_view(text).substr(start, end - start);
    if (!std::all_of(word.begin(), word.end(), [](char c) { return c >= 'a' && c <= 'z'; })) break;
    // Letters at the end of the word that make place for the singular's.
    const auto ends_in = [&](std::size_t letters, const char* of_one) {
      return text.replace(end - letters, letters, of_one);
    };
    if (word.ends_with("hedra")) return ends_in(1, "on");
    if (word == "vertices") return ends_in(4, "ex");
    if (word.ends_with("ies")) return ends_in(3, "y");
    if (word.ends_with("s") && !word.ends_with("ss")) return ends_in(1, "");
    start = end + 1;
  }
  return text;
}

}  // namespace tetproof::io
