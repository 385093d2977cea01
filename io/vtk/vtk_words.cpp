// SPDX-License-Identifier: GPL-3.0-or-later
// The table of VTK's types of numbers, and the codes in names.
#include "io/vtk/vtk_words.hpp"

#include <fmt/format.h>

#include <utility>

#include "io/bytes/tokens.hpp"

namespace tetproof::io {
namespace {

// The first word of a type is written. An id has 32 bits in files.
// clang-format off
constexpr std::pair<std::string_view, std::string_view> types[] = {
    {"bit", "bit"}, {"char", "Int8"}, {"signed_char", "Int8"}, {"unsigned_char", "UInt8"}, {"short", "Int16"},
    {"unsigned_short", "UInt16"}, {"int", "Int32"}, {"unsigned_int", "UInt32"}, {"vtktypeint64", "Int64"},
    {"vtktypeuint64", "UInt64"}, {"long", "Int64"}, {"unsigned_long", "UInt64"}, {"long_long", "Int64"},
    {"unsigned_long_long", "UInt64"}, {"vtkidtype", "Int32"}, {"float", "Float32"}, {"double", "Float64"},
    {"string", "String"}, {"utf8_string", "String"}};
// clang-format on

// The value of a hexadecimal digit; -1 for other characters.
int digit(char c) {
  return c >= '0' && c <= '9'   ? c - '0'
         : c >= 'a' && c <= 'f' ? c - 'a' + 10
         : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                : -1;
}

}  // namespace

std::string type_of_vtk_word(std::string_view word) {
  const std::string small = lower_case(word);
  for (const auto& [name, type] : types)
    if (name == small) return std::string(type);
  return {};
}

std::string_view vtk_word_of_type(std::string_view type) {
  for (const auto& [name, known] : types)
    if (known == type) return name;
  return "double";
}

std::string vtk_encoded(std::string_view text) {
  std::string word;
  for (const char c : text)
    if (c <= ' ' || c > '~' || c == '"' || c == '%')
      word += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    else
      word += c;
  return word;
}

std::string vtk_decoded(std::string_view word) {
  std::string text;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (word[i] == '%' && i + 2 < word.size() && digit(word[i + 1]) >= 0 && digit(word[i + 2]) >= 0) {
      text += static_cast<char>(16 * digit(word[i + 1]) + digit(word[i + 2]));
      i += 2;
    } else {
      text += word[i];
    }
  return text;
}

}  // namespace tetproof::io
