// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's XML files of unstructured grids.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/file_plan.hpp"

namespace tetproof::io {

/// Reads ASCII, base64 and appended data, compressed by zlib or not, of both byte orders; pieces are put one
/// after the other. Point and cell data become values, field data a table for each array; the cell data
/// "entity" (or "CellEntityIds") and "group", "group 2", ... become entities and physical groups. Nodes and
/// cells count from 0. See `add_vtk_piece` for the cells that are not kept as they are.
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
