// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the order in which TetGen listed nodes between corners. It depends on TetGen's version and switches.
// No file says it, but the nodes' places show it.
#pragma once

#include <cstddef>
#include <vector>

#include "io/document.hpp"
#include "io/tetgen/tetgen_read_parts.hpp"

namespace tetproof::io {

/// The nodes of second-order elements of one kind, one after the other.
struct TetgenRun {
  const Index* nodes;
  std::size_t count;  ///< of elements
};

/// With its switch for the opposite orientation TetGen exchanges corners 0 and 1, but not the nodes between
/// corners. Returns whether there are tetrahedra, and all of them are like that.
bool are_turned(const Document&, const std::vector<TetgenRun>& tets);
/// With -f TetGen 1.5 lists the node opposite to each corner of a face; without it, the node behind each
/// corner. Returns whether there are faces, and all of them are as with -f. `tets`: those of second order, if
/// any.
bool have_nodes_opposite_corners(const Document&, const std::vector<TetgenRun>& faces,
                                 const std::vector<TetgenRun>& tets);

/// Put the nodes of a file that has been read into the usual order.
void order_tetrahedra_nodes(const TetgenElements&, Document&);
void order_face_nodes(const TetgenElements& faces, const TetgenElements& tets, Document&);

}  // namespace tetproof::io
