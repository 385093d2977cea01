// SPDX-License-Identifier: GPL-3.0-or-later
// The OFF format of surfaces.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/file_plan.hpp"
#include "io/model/read_document.hpp"

namespace tetproof::io {

/// Reads Geomview's OFF, text and binary; binary also with little-endian numbers, which is a warning. The
/// keyword [ST][C][N]OFF may be missing. The counts are in the keyword's line or below it, with or without
/// the number of edges. Comments may be anywhere. Each point and each face has a line; if no face has a
/// colour, a face may continue in the next lines.
///
/// Nodes are numbered from 0. A face of two corners is a line, a face of one corner is a point. Values of
/// nodes: "normal", "color" (3 or 4 components, also in plain OFF), "texture". Values of elements: "color".
/// Colours are integers if all colours of the file with this number of components are. Other numbers behind a
/// point or a face are dropped, and so is what follows the last face. The comments above the counts are the
/// title. 4OFF and nOFF are refused. Throws InputError.
ReadDocument read_off(const InputFile& file, Wanted wanted);

/// Plans OFF as text, with exact numbers. It holds all points; faces by their corners, except those that name
/// nodes which do not exist; lines and points if the document was read from an OFF; values and title as they
/// are read.
std::unique_ptr<FilePlan> plan_off(const Document& document, bool binary);

}  // namespace tetproof::io
