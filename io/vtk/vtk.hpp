// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's legacy files of unstructured grids and polygonal data.
// Facts: "VTK File Formats", https://vtk.org/wp-content/uploads/2015/04/file-formats.pdf, and VTK 9.1.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/file_plan.hpp"

namespace tetproof::io {

/// Reads versions 1 to 5.1, ASCII and binary, which is big-endian. Attributes of points and cells become
/// values, scalars and colours as any; field data and lookup tables become tables; metadata are skipped. The
/// cell data "CellEntityIds", as Gmsh calls them (which writes the numbers of physical groups there when it
/// saves by groups), and "group", "group 2", ... become entities and physical groups; the second line is the
/// document's title. See `add_vtk_piece` for cells that are not kept as they are.
Document read_vtk(const InputFile& file);

/// Version 4.2, which VTK 9, Gmsh 4.8 and meshio read. As in .vtu (see there), but entity tags as
/// "CellEntityIds". Integers are int where all are such, vtktypeint64 else.
///
/// Warns of text with numbers that are not finite: VTK 9.1 reads none, and misreads all that follows.
std::unique_ptr<FilePlan> plan_vtk(const Document& document, bool binary);

}  // namespace tetproof::io
