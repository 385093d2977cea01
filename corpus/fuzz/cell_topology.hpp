// SPDX-License-Identifier: GPL-3.0-or-later
// The topology of a body of cells. Internal.
#pragma once

#include "corpus/fuzz/shape.hpp"
#include "corpus/generators/cells.hpp"

namespace tetproof::corpus {

/// Fills empty cells until the boundary is a manifold: the first cell at the first corner where the solid
/// cells, or the empty ones, do not hang together through common sides.
void fill_to_manifold(CellBody& body);

/// The boundary of a body whose boundary is a manifold, with its components, cavities and genus.
Shape cell_shape(const CellBody& body);

}  // namespace tetproof::corpus
