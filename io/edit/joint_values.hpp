// SPDX-License-Identifier: GPL-3.0-or-later
// The values of two documents that are joined.
#pragma once

#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// The position in the joint document of a node or element of the second one: behind `by` others. Negative,
/// as in `Values::at`: behind `unknown` unknown numbers.
inline Index moved_behind(Index i, Index by, Index unknown) {
  return i < 0 ? i - unknown : i + by;
}

/// Values that both documents have, of the same name and kind, become one; the rest stand for themselves.
/// Where a document has several of one name, the first goes with the first.
void join_values(std::vector<Values>& all, std::vector<Values>&& more, Index by, Index unknown);

}  // namespace tetproof::io
