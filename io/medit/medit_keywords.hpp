// SPDX-License-Identifier: GPL-3.0-or-later
// The keywords of Medit's files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

struct MeditKeyword {
  int code;  ///< its number in binary files; `no_medit_code`: it has none
  std::string_view name;
  int element;              ///< Gmsh's type of the elements that it lists; 0: it does not list elements
  std::string_view format;  ///< of a line: i integer, r real, c coordinates
  bool counted = true;      ///< the lines follow their number
};

inline constexpr int no_medit_code = -1;
inline constexpr int medit_dimension = 3, medit_vertices = 4, medit_end = 54;

constexpr bool is_medit_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
/// Whether a word has the form of a keyword, known or not: letters, digits and _, with a letter first.
bool looks_like_medit_keyword(std::string_view word);

/// The keyword with this code or name; synonyms are known too. Null: no such keyword, or none of a fixed
/// form.
const MeditKeyword* medit_keyword(int code);
const MeditKeyword* medit_keyword(std::string_view name);
/// All keywords that list elements, in the order in which they are written.
const std::vector<const MeditKeyword*>& medit_elements();

/// A keyword that marks nodes (`element` 0) or elements.
struct MeditMark {
  std::string_view name;
  int element;  ///< Gmsh's type of the elements whose numbers it lists
};
const MeditMark* medit_mark(std::string_view name);

/// The numbers of a section.
struct MeditLines {
  std::vector<std::int64_t> integers;  ///< the integers of all lines, one after the other
  std::vector<double> reals;
  std::size_t count = 1;
};
/// The numbers in `body`; none if it does not have the keyword's form.
std::optional<MeditLines> medit_lines(const MeditKeyword& keyword, const std::string& body, int dimension);
/// The body of a section as text. Binary sections are kept in this form.
std::string medit_body(const MeditKeyword& keyword, const MeditLines& lines, int dimension);

}  // namespace tetproof::io
