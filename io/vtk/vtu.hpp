// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's XML files of grids and polygonal data.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/file_plan.hpp"

namespace tetproof::io {

/// Reads the types UnstructuredGrid (.vtu), PolyData (.vtp), ImageData (.vti), RectilinearGrid (.vtr) and
/// StructuredGrid (.vts): ASCII, base64 and appended data of both byte orders, compressed by zlib, LZ4, LZMA
/// or not. Structured grids become hexahedra (quadrangles, lines), with a warning, and their pieces
/// one grid (io/vtk/vtk_lattice_join.hpp). Other pieces are put one after the other. Point and cell data
/// become values with their roles (Scalars="..."), and field data a table for each array. The cell data with
/// a name of io/model/tag_words.hpp ("gmsh:physical", "medit:ref", "CellEntityIds", ...) become physical
/// groups, with "group 2", ... for further ones, and entities. Nodes and cells are numbered from 0. See
/// `VtkPieces::add` for the cells that are not kept as they are.
///
/// Everything else is listed as dropped: names of components, information keys, the division into pieces, and
/// elements and attributes that this reader does not know. Not dropped is what follows from the values
/// (ranges) and what only encodes them (the type of numbers, their byte order). XML comments are no data.
Document read_vtu(const InputFile& file);

/// An unstructured grid, with coordinates as Float64, integers as Int64; base64 if `binary`. Values become
/// point and cell data, with their roles; texts are texts again if a file of VTK had them. Entity tags become
/// cell data "gmsh:geometrical", where there are any besides 0 and, unless a file of VTK said so, 1; physical
/// groups become "gmsh:physical" (or keep the name that they had in a file of VTK), "group 2", ...; names of
/// groups and tables become field data. Elements that VTK does not have
/// are written by their corners; those that name unknown nodes are left out.
///
/// Warns of text with -inf: VTK 9.1 reads it as inf.
std::unique_ptr<FilePlan> plan_vtu(const Document& document, bool binary);

}  // namespace tetproof::io
