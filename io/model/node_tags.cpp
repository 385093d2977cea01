// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model/node_tags.hpp"

#include <algorithm>
#include <cmath>

#include "io/model/tag_words.hpp"
#include "io/model/values.hpp"

namespace tetproof::io {
namespace {

bool is_whole(double real) {
  return std::abs(real) <= 0x1p53 && real == std::trunc(real) && !(real == 0 && std::signbit(real));
}

bool are_tags_of_nodes(const Document& document, const Values& values, bool with_reals) {
  return values.components == 1 && of_all(values, document.points.size()) &&
         (values.reals.empty() ||
          (with_reals && std::all_of(values.reals.begin(), values.reals.end(), is_whole)));
}

}  // namespace

const Values* node_tags(const Document& document, std::string_view own) {
  const auto find = [&](std::string_view word) -> const Values* {
    for (const Values& values : document.node_values)
      if (values.name == word && are_tags_of_nodes(document, values, word != own)) return &values;
    return nullptr;
  };
  if (const Values* found = find(own)) return found;
  for (const std::string_view word : node_tag_words)
    if (const Values* found = find(word)) return found;
  return nullptr;
}

}  // namespace tetproof::io
