// SPDX-License-Identifier: GPL-3.0-or-later
// Leaves out or merges the nodes of a document, with all that belongs to nodes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// What `move_nodes` did beyond the points.
struct MovedNodes {
  std::vector<Loss> lost;
  std::size_t differing = 0;  ///< values of merged nodes that were not equal to those of the first
};

/// Moves node i to position `target[i]`; -1: it is left out. Several nodes may go to one position: the first
/// of them gives the place, the number and the values. New positions ascend in the order of these first ones.
MovedNodes move_nodes(Document& document, const std::vector<Index>& target);

}  // namespace tetproof::io
