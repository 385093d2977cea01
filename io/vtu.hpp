// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's XML files of unstructured grids.
#pragma once

#include "io/atomic_file.hpp"
#include "io/document.hpp"
#include "io/holds.hpp"

namespace tetproof::io {

/// VTK's number of the cell type for Gmsh's element type; 0 if there is none that this writer knows.
int vtk_cell_type(int gmsh_type);

/// Coordinates as Float64, integers as Int64; base64 if `binary`. `node_values` and `element_values` become
/// point and cell data; entity tags and the first physical group of each element as cell data "entity" and
/// "group" where there are any besides one entity. Elements that VTK does not have, or that name unknown
/// nodes, are left out.
void write_vtu(AtomicFile& file, const Document& document, bool binary);

Holds vtu_holds();

}  // namespace tetproof::io
