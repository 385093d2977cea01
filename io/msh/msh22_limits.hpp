// SPDX-License-Identifier: GPL-3.0-or-later
// Plans which numbers a .msh 2.2 file gives to the nodes and elements of a document. The writer and the list
// of what is held share this plan.
#pragma once

#include <cstdint>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

struct Msh22Limits {
  /// Nodes and elements are numbered from 1, because they count from 0, or a tag does not fit the 4 bytes
  /// that binary has for it.
  bool renumber = false;
  /// Parametric coordinates are written. This needs them for all nodes on curves and surfaces.
  bool parametric = false;
  /// When renumbering: the number of `Document::unknown[0]`. The others count up from it.
  std::int64_t first_unknown = 0;
  /// An element in several groups is written once for each. The tags of these copies count up from this one.
  std::int64_t first_copy = 1;
  std::size_t copies = 0;                ///< how many there are, without the first of each element
  std::vector<NodeBlock> node_blocks{};  ///< covering all nodes, in order; set only if some have parameters
};
Msh22Limits msh22_limits(const Document& document, bool binary);

/// Returns the dimension of the entity of elements of a type, which the file does not tell.
int dimension22(int type);

/// How many groups an element can have. The reader looks for an element's further groups in the elements that
/// follow, and compares each with all groups found so far, hence a limit.
inline constexpr std::size_t most_groups22 = 1000;
/// Returns the groups in which the elements of a block are written: each once, at most `most_groups22`; 0
/// alone if there are none.
std::vector<std::int64_t> groups22(const Document& document, const ElementBlock& block);

}  // namespace tetproof::io
