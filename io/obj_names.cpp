// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/obj_names.hpp"

#include <algorithm>

#include "io/input_file.hpp"
#include "io/tokens.hpp"

namespace tetproof::io {

std::optional<std::int64_t> group_number(std::string_view word) {
  std::int64_t number;
  if (!parse_integer(word, number) || number == 0 || std::to_string(number) != word) return {};
  return number;
}

std::string group_word(const Document& document, int dim, std::int64_t group) {
  for (const GroupName& name : document.group_names) {
    if (name.dim != dim || name.group != group || name.name.empty()) continue;
    const std::string word = encode_name(name.name);
    if (!group_number(word)) return word;
    constexpr std::string_view digits = "0123456789ABCDEF";  // a name of digits alone: the first as a code
    const auto c = static_cast<unsigned char>(word[0]);
    return std::string{'%', digits[c / 16], digits[c % 16]} + word.substr(1);
  }
  return std::to_string(group);
}

std::int32_t GroupNumbers::enter(int dim) {
  std::vector<std::int64_t> groups;
  for (const std::string& word : words_) {
    std::int64_t number;
    if (const auto own = group_number(word)) {
      number = *own;
    } else {
      const auto [place, is_new] = numbers_.try_emplace(word, 0);
      if (is_new) {
        while (taken_.count(next_)) ++next_;
        place->second = next_++;
      }
      number = place->second;
      if (entered_.insert({dim, number}).second)
        document_->group_names.push_back({dim, number, decode_name(word)});
    }
    if (std::find(groups.begin(), groups.end(), number) == groups.end()) groups.push_back(number);
  }
  return (*sets_)(groups);
}

}  // namespace tetproof::io
