// SPDX-License-Identifier: GPL-3.0-or-later
// The OBJ format of surfaces.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/file_plan.hpp"
#include "io/model/read_document.hpp"

namespace tetproof::io {

/// Reads Wavefront's OBJ. Faces are `f` with corners i, i/t, i//n or i/t/n. Numbers are positive or negative,
/// and may name points that come later. `l` is a line, or a polyline if it has more than two points. `p`
/// lists points. A backslash at the end of a line continues the statement.
///  - `g`: physical groups. A whole number is the group with this number. Names get the numbers 1, 2, ...
///    that are not taken, in the order in which elements first use them; a comment `# group 5 wing` gives a
///    name another number. %20 stands for a blank, and so on; `default` is a name like any other.
///  - `o`, `usemtl`, `s`: values of elements "object", "material" (integers with labels; "" before the first
///    statement) and "smoothing" (integers; 0 is off), if any element has one.
///  - `vt`, `vn`: values of elements' nodes "texture" (as many components as the longest `vt` has) and
///    "normal".
///  - Numbers behind x y z: values of nodes, "weight" for one number, "color" for three or four.
///  - `mtllib`: a table "mtllib" with a column "file". Comments above everything else: the title.
/// All other statements, such as free-form surfaces, are dropped, and so are texture coordinates and normals
/// that no face uses. Throws InputError, also for a file without any statement of OBJ.
ReadDocument read_obj(const InputFile& file, Wanted wanted);

/// Plans OBJ as text, with exact numbers. It holds all points; points, lines, polylines and faces by their
/// corners, except those that name nodes which do not exist; and everything else that the reader reads. A
/// group without a name is `g NUMBER`. Comments give the numbers of named groups that would otherwise get
/// another number.
std::unique_ptr<FilePlan> plan_obj(const Document& document, bool binary);

}  // namespace tetproof::io
