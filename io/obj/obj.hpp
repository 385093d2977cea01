// SPDX-License-Identifier: GPL-3.0-or-later
// The OBJ format of surfaces.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/file_plan.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {

/// Reads Wavefront's OBJ: `v`, `f` with i, i/t, i//n or i/t/n, positive or negative, also naming points that
/// come later; `l` (a line from each point to the next), `p`; a backslash before the line's end continues it.
///  - `g`: physical groups. A whole number is the group with this number; names are numbered in the order in
///    which elements first use them, from 1, past the numbers that are taken; a comment `# group 5 wing`
///    numbers one otherwise. %20 and the like stand for a
///    blank, ...; `default` is a name.
///  - `o`, `usemtl`, `s`: values of elements "object", "material" (integers with labels; "" before the first
///    statement) and "smoothing" (integers, 0 is off), if any element has one.
///  - `vt`, `vn`: values of elements' nodes "texture" (as many components as the longest `vt` has) and
///    "normal"; what no element names is dropped with a warning.
///  - Numbers behind x y z: values of nodes, one is "weight", three or four are "color".
///  - `mtllib`: a table "mtllib" with a column "file". Comments above all else: the title.
/// Other statements that OBJ knows are counted in a warning, but for free-form surfaces (`surf`), which are
/// refused like unknown statements. Throws InputError.
SurfaceDocument read_obj(const InputFile& file, Wanted wanted);

/// OBJ as text, exact: all points, and points, lines and faces by their corners, but for those that name
/// nodes which do not exist, with all that is read. A group without a name is `g NUMBER`, and comments
/// tell the numbers of the others if any would get another one.
std::unique_ptr<FilePlan> plan_obj(const Document& document, bool binary);

}  // namespace tetproof::io
