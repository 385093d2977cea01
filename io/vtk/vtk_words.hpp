// SPDX-License-Identifier: GPL-3.0-or-later
// The words of VTK's legacy files: types of numbers, and names and texts with codes for characters that would
// end a word.
#pragma once

#include <string>
#include <string_view>

namespace tetproof::io {

/// The name in .vtu files of the type that `word` (in any case) names, see io/vtk/vtk_types.hpp; "bit" for
/// bits; empty for no type.
std::string type_of_vtk_word(std::string_view word);
/// The type's name at the start of `word`, where VTK takes the word for that type: it reads "int1" as int.
/// Empty: it knows no such type.
std::string_view vtk_type_tried_for(std::string_view word);
/// The word that a legacy file has for such a type.
std::string_view vtk_word_of_type(std::string_view type);

/// Whether VTK has this role for arrays: "Scalars", "GlobalIds", ...
bool is_vtk_role(std::string_view role);
/// The role that a keyword of legacy files gives to an array; empty: none.
std::string_view role_of_vtk_word(std::string_view word);
/// The keyword that gives an array of so many components this role; empty: there is none.
std::string_view vtk_word_of_role(std::string_view role, int components);

/// Encodes a name or text as one word: blanks, line ends and bytes that are not ASCII become codes such as
/// %20.
std::string vtk_encoded(std::string_view text);
/// Decodes such a word. The digits of its codes may be in upper or lower case.
std::string vtk_decoded(std::string_view word);

}  // namespace tetproof::io
