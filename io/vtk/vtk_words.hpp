// SPDX-License-Identifier: GPL-3.0-or-later
// The words of VTK's legacy files: types of numbers, and names and texts in which a code stands for what
// would end a word.
#pragma once

#include <string>
#include <string_view>

namespace tetproof::io {

/// The name that .vtu files have for a type (see io/vtk/vtk_types.hpp), "bit" for bits; empty: no type.
/// `word` in any case.
std::string type_of_vtk_word(std::string_view word);
/// The other way.
std::string_view vtk_word_of_type(std::string_view type);

/// A name or text without blanks, line ends and what is not ASCII: a blank is %20.
std::string vtk_encoded(std::string_view text);
/// The other way, of capital and small letters.
std::string vtk_decoded(std::string_view word);

}  // namespace tetproof::io
