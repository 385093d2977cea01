// SPDX-License-Identifier: GPL-3.0-or-later
// The table of VTK's types of numbers, and the codes in names.
#include "io/vtk/vtk_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "io/bytes/tokens.hpp"

namespace tetproof::io {
namespace {

// The first word of a type is written. An id has 32 bits in files. VTK itself takes every word that begins
// with a type's name for that type, and refuses those of a fixed size but for vtktypeint64 and vtktypeuint64.
// clang-format off
constexpr std::pair<std::string_view, std::string_view> types[] = {
    {"bit", "bit"}, {"char", "Int8"}, {"signed_char", "Int8"}, {"unsigned_char", "UInt8"}, {"short", "Int16"},
    {"unsigned_short", "UInt16"}, {"int", "Int32"}, {"unsigned_int", "UInt32"}, {"vtktypeint64", "Int64"},
    {"vtktypeuint64", "UInt64"}, {"long", "Int64"}, {"unsigned_long", "UInt64"}, {"long_long", "Int64"},
    {"unsigned_long_long", "UInt64"}, {"vtkidtype", "Int32"}, {"float", "Float32"}, {"double", "Float64"},
    {"string", "String"}, {"utf8_string", "String"}, {"vtktypeint8", "Int8"}, {"vtktypeuint8", "UInt8"},
    {"vtktypeint16", "Int16"}, {"vtktypeuint16", "UInt16"}, {"vtktypeint32", "Int32"}, {"vtktypeuint32", "UInt32"},
    {"vtktypefloat32", "Float32"}, {"vtktypefloat64", "Float64"}};
// The names by which VTK recognises types, in the order in which it tries them.
constexpr std::string_view tried[] = {"bit", "char", "signed_char", "unsigned_char", "short", "unsigned_short",
                                      "vtkidtype", "int", "unsigned_int", "long", "unsigned_long", "vtktypeint64",
                                      "vtktypeuint64", "float", "double", "string", "utf8_string"};
// The roles of arrays in XML files, and the keywords that give them in legacy files.
constexpr std::pair<std::string_view, std::string_view> roles[] = {
    {"Scalars", "SCALARS"}, {"Vectors", "VECTORS"}, {"Normals", "NORMALS"}, {"TCoords", "TEXTURE_COORDINATES"},
    {"Tensors", "TENSORS"}, {"Tensors", "TENSORS6"}, {"GlobalIds", "GLOBAL_IDS"}, {"PedigreeIds", "PEDIGREE_IDS"},
    {"EdgeFlag", "EDGE_FLAGS"}, {"Scalars", "COLOR_SCALARS"}, {"Tangents", ""}, {"ProcessIds", ""},
    {"RationalWeights", ""}, {"HigherOrderDegrees", ""}};
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

std::string_view vtk_type_tried_for(std::string_view word) {
  const std::string small = lower_case(word);
  for (const std::string_view name : tried)
    if (small.starts_with(name)) return name;
  return {};
}

bool is_vtk_role(std::string_view role) {
  return std::any_of(std::begin(roles), std::end(roles), [&](const auto& one) { return one.first == role; });
}

std::string_view role_of_vtk_word(std::string_view word) {
  const std::string small = lower_case(word);
  for (const auto& [role, keyword] : roles)
    if (lower_case(keyword) == small) return role;
  return {};
}

std::string_view vtk_word_of_role(std::string_view role, int components) {
  for (const auto& [name, keyword] : roles)
    if (name == role && (role != "Tensors" || components == 9 || keyword == "TENSORS6")) return keyword;
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
