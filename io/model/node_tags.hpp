// SPDX-License-Identifier: GPL-3.0-or-later
// The one number that tools give to a node to tell where it is: Medit's reference, TetGen's marker.
#pragma once

#include <string_view>

#include "io/document.hpp"

namespace tetproof::io {

/// Returns the values of all nodes under one of the words for such numbers (io/model/tag_words.hpp), the
/// target's `own` word first: integers, or under another word than the own one whole reals, since some
/// formats have no integers. Null: there are none.
const Values* node_tags(const Document& document, std::string_view own);

}  // namespace tetproof::io
