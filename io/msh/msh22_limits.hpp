// SPDX-License-Identifier: GPL-3.0-or-later
// What .msh 2.2 does to a document's numbers; the writer and what is said of it must agree.
#pragma once

#include <cstdint>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

struct Msh22Limits {
  bool renumber = false;  ///< nodes and elements from 1: a tag does not fit the 4 bytes that it has in binary
  bool parametric =
      false;  ///< parametric coordinates are written; only when all nodes on curves and surfaces have them
  std::int64_t first_unknown = 0;  ///< when renumbering: the number of `Document::unknown[0]`; counts up
  std::int64_t first_copy = 1;     ///< the tag of the first copy of an element in several groups; counts up
  std::size_t copies = 0;
  std::vector<NodeBlock> node_blocks{};  ///< covering all nodes, in order; set only if some have parameters
};
Msh22Limits msh22_limits(const Document& document, bool binary);

/// The dimension of the entity of elements of a type, which the file does not say.
int dimension22(int type);

/// The reader looks for an element's further groups in the next elements: for so many at most, since it looks
/// through them again for each.
inline constexpr std::size_t most_groups22 = 1000;
/// The groups in which the elements of a block are written: each once, at most so many; 0 for none.
std::vector<std::int64_t> groups22(const Document& document, const ElementBlock& block);

}  // namespace tetproof::io
