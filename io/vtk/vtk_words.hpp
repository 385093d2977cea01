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
/// The word that a legacy file has for such a type.
std::string_view vtk_word_of_type(std::string_view type);

/// Encodes a name or text as one word: blanks, line ends and bytes that are not ASCII become codes such as
/// %20.
std::string vtk_encoded(std::string_view text);
/// Decodes such a word. The digits of its codes may be in upper or lower case.
std::string vtk_decoded(std::string_view word);

}  // namespace tetproof::io
