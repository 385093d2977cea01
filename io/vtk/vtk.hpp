// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's legacy files of grids and polygonal data.
// Facts: "VTK File Formats", https://vtk.org/wp-content/uploads/2015/04/file-formats.pdf, and VTK 9.1.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/file_plan.hpp"

namespace tetproof::io {

/// Reads versions 1 to 5.1, ASCII and binary (which is big-endian), of the data sets UNSTRUCTURED_GRID and
/// POLYDATA, and the structured ones: STRUCTURED_POINTS, STRUCTURED_GRID and RECTILINEAR_GRID become
/// hexahedra (quadrangles, lines), with a warning. Attributes of points and cells (SCALARS, VECTORS,
/// COLOR_SCALARS, ...) become values. Field data and lookup tables become tables. The cell data
/// with a name of io/model/tag_words.hpp become entities and physical groups, as in .vtu. (Gmsh's
/// "CellEntityIds" are entities, or the numbers of physical groups when it saves by groups.) The second line
/// is the document's title, unless it is "vtk output", which VTK's writer makes up.
/// See `VtkPieces::add` for cells that are not kept as they are.
///
/// CELL_TYPES may stand before CELLS. A word that begins with the name of a type, such as `int1`, is read as
/// that type, with a warning: VTK does so.
///
/// The first array of a role gets it: Scalars, Vectors, Normals, ... SCALARS, VECTORS and TENSORS count as
/// roles only beside a FIELD; without one they only say how many components an array has.
///
/// Listed as dropped: the roles of further arrays, the name of an array's lookup table, names of fields,
/// names of components and information keys in METADATA, and colours that are rounded to bytes.
Document read_vtk(const InputFile& file);

/// Version 4.2, which VTK 9, Gmsh 4.8 and meshio read. As in .vtu (see there), but entity tags as
/// "CellEntityIds". Integers are int where all are such, vtktypeint64 else. A role makes an array an
/// attribute; beside entities, cell data have no role Scalars, since VTK takes the first array for it.
///
/// Warns of text with numbers that are not finite: VTK 9.1 reads none, and misreads all that follows.
std::unique_ptr<FilePlan> plan_vtk(const Document& document, bool binary);

}  // namespace tetproof::io
