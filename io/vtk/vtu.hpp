// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's XML files of unstructured grids.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/file_plan.hpp"

namespace tetproof::io {

/// Reads ASCII, base64 and appended data of both byte orders, compressed by zlib or not. Pieces are put one
/// after the other. Point and cell data become values, and field data a table for each array. The cell data
/// "entity" (or "CellEntityIds") and "group", "group 2", ... become entities and physical groups. Nodes and
/// cells are numbered from 0. See `add_vtk_piece` for the cells that are not kept as they are.
///
/// Everything else is listed as dropped: roles of arrays (Scalars="...", but of entities and groups), names
/// of components, information keys, the division into pieces, and elements and attributes that this reader
/// does not know. Not dropped is what follows from the values (ranges) and what only encodes them (the type
/// of numbers, their byte order). XML comments are no data.
Document read_vtu(const InputFile& file);

/// Coordinates as Float64, integers as Int64; base64 if `binary`. Values become point and cell data, entity
/// tags and physical groups cell data "entity" and "group", "group 2", ..., where there are any
/// (of entities, besides 0 and 1); tables
/// become field data. Elements that VTK does not have are written by their corners; those that name unknown
/// nodes are left out.
///
/// Warns of text with -inf: VTK 9.1 reads it as inf.
std::unique_ptr<FilePlan> plan_vtu(const Document& document, bool binary);

}  // namespace tetproof::io
