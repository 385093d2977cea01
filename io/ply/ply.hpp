// SPDX-License-Identifier: GPL-3.0-or-later
// The PLY format of surfaces.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/file_plan.hpp"
#include "io/model/read_document.hpp"

namespace tetproof::io {

/// Reads PLY: text, and binary in both byte orders. Nodes are element `vertex` with x, y, z, numbered from 0.
/// Faces are element `face` with a list `vertex_indices` or `vertex_index`. Strips of triangles are element
/// `tristrips` with such a list, in which -1 ends a strip, and become triangles. Lines are element `edge`
/// with `vertex1` and `vertex2`, and come behind the faces; a face of two corners is a line where it stands,
/// and a face of one corner a point. What follows the last element is dropped. The elements may come in any
/// order, and their properties may have any type.
///  - Other properties of these elements are values. They are integers if the type is. Consecutive
///    properties become one list of values: nx ny nz "normal", red green blue [alpha] "color", s t "texture",
///    NAME_0 NAME_1 ... "NAME". Values of faces and of edges are one list if the properties have the same
///    names. Those of tristrips are dropped.
///  - A list `texcoord` of a face, with two numbers for each corner: values "texture" of elements' nodes.
///  - Other lists are columns of tables "vertex", "face" and "edge". Other elements are tables. The type of
///    a column is the type in the file: "float" or "list uchar float".
///  - Comments are the lines of the title. Lines of the title that start with "obj_info " were such lines.
/// In names, %20 stands for a blank, and so on. Throws InputError. A surface must have faces or strips.
ReadDocument read_ply(const InputFile& file, Wanted wanted);

/// Plans PLY as text or little-endian binary, with exact numbers: float or double, and the smallest of uchar,
/// short, int and uint. It holds all points; faces of three or more corners and then lines, except those that
/// name nodes which do not exist; and everything else that the reader reads.
std::unique_ptr<FilePlan> plan_ply(const Document& document, bool binary);

}  // namespace tetproof::io
