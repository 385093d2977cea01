// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the structured grids of VTK's XML files: ImageData, RectilinearGrid and StructuredGrid.
#pragma once

#include <cstddef>
#include <pugixml.hpp>

#include "io/document.hpp"
#include "io/vtk/vtk_piece.hpp"
#include "io/vtk/vtu_file.hpp"
#include "io/vtk/vtu_parts.hpp"

namespace tetproof::io {

enum class VtuLattice { image, rectilinear, structured };

/// Reads all pieces of the grid into one. `bytes`: the size of the file. `filled` becomes the number of
/// pieces that have points. The document gets warnings and what is dropped.
VtkPiece read_vtu_lattice(const VtuFile& file, const pugi::xml_node& grid, VtuLattice kind, std::size_t bytes,
                          Document& document, std::size_t& filled);

}  // namespace tetproof::io
