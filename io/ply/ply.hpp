// SPDX-License-Identifier: GPL-3.0-or-later
// The PLY format of surfaces.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/file_plan.hpp"
#include "io/model/read_document.hpp"

namespace tetproof::io {

/// Reads PLY: text and both byte orders. Nodes are element `vertex` with x, y, z, numbered from 0. Faces are
/// element `face` with a list `vertex_indices` or `vertex_index`; strips of triangles are element `tristrips`
/// with such a list, and become triangles; lines are element `edge` with `vertex1` and `vertex2`. The
/// elements come in any order, and their properties have any type.
///  - Other properties of these elements are values, integers where the type is. Several become one where
///  they
///    follow each other: nx ny nz "normal", red green blue [alpha] "color", s t "texture", NAME_0 NAME_1 ...
///    NAME. Those of faces and of edges are one where the properties have the same names. Those of tristrips
///    are dropped.
///  - A face's list `texcoord` of two numbers a corner: values "texture" of elements' nodes.
///  - Other lists are columns of tables "vertex", "face" and "edge"; other elements are tables. The type of a
///    column is as in the file: "float" or "list uchar float".
///  - Comments are the lines of the title; lines that start with "obj_info " were such.
/// In names, %20 stands for a blank, and so on. Throws InputError. A surface must have faces or strips.
ReadDocument read_ply(const InputFile& file, Wanted wanted);

/// PLY as text or binary, little endian; exact: numbers are float or double, uchar, short, int or uint, as
/// small as can be. All points, faces of three and more corners and then lines, but for those that name nodes
/// which do not exist, and all else that is read.
std::unique_ptr<FilePlan> plan_ply(const Document& document, bool binary);

}  // namespace tetproof::io
