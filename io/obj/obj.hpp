// SPDX-License-Identifier: GPL-3.0-or-later
// The OBJ format of surfaces.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/file_plan.hpp"
#include "io/model/read_document.hpp"

namespace tetproof::io {

/// Reads Wavefront's OBJ: `v`; `f` with i, i/t, i//n or i/t/n, positive or negative, which may name points
/// that come later; `l` (a line from each point to the next); `p`. A backslash at a line's end continues the
/// statement.
///  - `g`: physical groups. A whole number is the group with this number. Names get numbers in the order in
///    which elements first use them, from 1 on without those that are taken; a comment `# group 5 wing` gives
///    another number. %20 stands for a blank, and so on; `default` is a name.
///  - `o`, `usemtl`, `s`: values of elements "object", "material" (integers with labels; "" before the first
///    statement) and "smoothing" (integers, 0 is off), if any element has one.
///  - `vt`, `vn`: values of elements' nodes "texture" (as many components as the longest `vt` has) and
///    "normal".
///  - Numbers behind x y z: values of nodes, "weight" if it is one number, "color" if they are three or four.
///  - `mtllib`: a table "mtllib" with a column "file". Comments above all else: the title.
/// All other statements, such as those of free-form surfaces, are dropped, and so are texture coordinates and
/// normals that no face uses. Throws InputError, also for a file without any statement of OBJ.
ReadDocument read_obj(const InputFile& file, Wanted wanted);

/// OBJ as text, exact: all points, and points, lines and faces by their corners, but for those that name
/// nodes which do not exist, with all that is read. A group without a name is `g NUMBER`, and comments
/// tell the numbers of the others if any would get another one.
std::unique_ptr<FilePlan> plan_obj(const Document& document, bool binary);

}  // namespace tetproof::io
