// SPDX-License-Identifier: GPL-3.0-or-later
// Joins the pieces of a structured grid: their points and cells have places in the whole grid.
#pragma once

#include <vector>

#include "io/document.hpp"
#include "io/vtk/vtk_lattice.hpp"
#include "io/vtk/vtk_piece.hpp"

namespace tetproof::io {

/// A piece of a structured grid: points and arrays, no cells. Its first point is at the index `first`.
struct VtkLatticePiece {
  VtkDimensions first{}, dimensions{};
  VtkPiece piece;
};

/// The indices from `first` on that the pieces have.
struct VtkLatticeBox {
  VtkDimensions first{}, dimensions{};
};
VtkLatticeBox box_of(const std::vector<VtkLatticePiece>& pieces);

/// Makes one piece of several, with points and cells in the order of the whole grid. Of a point or cell that
/// several pieces have, the first that is no ghost counts, or else the first. Cells are those of the pieces;
/// where none has cell data, all whose corners are points, as in VTK. Listed as dropped in `document`: points
/// and cells that differ from piece to piece, arrays that some piece lacks, and cells between pieces that
/// have no data. Warns of what the grid has become.
VtkPiece joined(std::vector<VtkLatticePiece>&& pieces, Document& document);

}  // namespace tetproof::io
