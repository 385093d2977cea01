// SPDX-License-Identifier: GPL-3.0-or-later
// The OFF format of surfaces.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/file_plan.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {

/// Reads Geomview's OFF: [ST][C][N]OFF, or no keyword at all; counts on the keyword's line or later, the
/// number of edges there or not; comments; a line for each point and for each face. Nodes are numbered from
/// 0; a face of two corners is a line, of one a point. Values of nodes: "normal", "color" (of 3 or 4
/// components; those of plain OFF as well, where every vertex has as many), "texture". Values of elements:
/// "color". Colours are integers where all of the file with so many components are. The comments above the
/// counts are the title. 4OFF, nOFF and binary OFF are refused. Throws InputError.
SurfaceDocument read_off(const InputFile& file, Wanted wanted);

/// OFF as text, exact: all points, and faces by their corners, but for those that name nodes which do not
/// exist; lines and points if the document was read from an OFF; values and title as they are read.
std::unique_ptr<FilePlan> plan_off(const Document& document, bool binary);

}  // namespace tetproof::io
