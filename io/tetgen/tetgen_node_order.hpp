// SPDX-License-Identifier: GPL-3.0-or-later
// In what order TetGen lists nodes between corners depends on its version and its switches, and no file says
// it: their places do.
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

/// With its switch for the opposite orientation TetGen exchanges corners 0 and 1, but nothing between
/// corners: whether all tetrahedra, and there are any, prove to be like that.
bool are_turned(const Document&, const std::vector<TetgenRun>& tets);
/// With -f TetGen 1.5 lists the node opposite to each corner of a face, without it the node behind each
/// corner: whether all faces, and there are any, prove to be like the first. `tets`: of second order, if
/// there are any.
bool have_nodes_opposite_corners(const Document&, const std::vector<TetgenRun>& faces,
                                 const std::vector<TetgenRun>& tets);

/// Puts the nodes of a file that was read into the usual order.
void order_tetrahedra_nodes(const TetgenElements&, Document&);
void order_face_nodes(const TetgenElements& faces, const TetgenElements& tets, Document&);

}  // namespace tetproof::io
