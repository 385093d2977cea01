// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes/tokens.hpp"

namespace tetproof::io {
namespace {

constexpr std::string_view digits = "0123456789ABCDEF";

bool is_code(std::string_view text) {
  return text.size() >= 3 && text[0] == '%' && digits.find(text[1]) != digits.npos &&
         digits.find(text[2]) != digits.npos;
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

std::string encode_name(std::string_view name, bool blanks) {
  std::string word;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    const bool stays =
        c == ' ' ? blanks && i > 0 && i + 1 < name.size() && name[i - 1] != ' '
                 : c > ' ' && c != 127 && c != '#' && c != '\\' && !(c == '%' && is_code(name.substr(i)));
    if (stays)
      word += static_cast<char>(c);
    else
      word.append("%").append(1, digits[c / 16]).append(1, digits[c % 16]);
  }
  return word;
}

std::string decode_name(std::string_view word) {
  std::string name;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (is_code(word.substr(i))) {
      name += static_cast<char>(digits.find(word[i + 1]) * 16 + digits.find(word[i + 2]));
      i += 2;
    } else {
      name += word[i];
    }
  return name;
}

}  // namespace tetproof::io
