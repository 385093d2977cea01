// SPDX-License-Identifier: GPL-3.0-or-later
// Medit's .mesh (text) and .meshb (binary), which libMeshb calls the Gamma Mesh Format.
// Facts: https://github.com/LoicMarechal/libMeshb and meshio's medit module.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/file_plan.hpp"

namespace tetproof::io {

/// Reads text with keywords in any order, and binary files of versions 1 to 4 and both byte orders. The
/// content tells which of the two a file is. References of nodes become node values "references", unless all
/// are 0. References of elements become physical groups, except 0. "Corners", "Ridges", and "Required" and
/// "Parallel" (MMG's) with "Vertices", "Edges", "Triangles", "Quadrilaterals" or "Tetrahedra" become values,
/// all 1, of the nodes or elements that they list. "Pentahedra" are read as "Prisms". All other keywords
/// become sections, as text in one form. A keyword such as TetrahedraP2Ordering sets the order of nodes of
/// second-order elements. A number that no node or element has is kept as such.
///
/// Values of "SolAtVertices" and the like, in the file or in a .sol or .solb beside it, become values
/// "solution", "solution 2", ...: scalars, vectors of 3 components, and tensors of 9, row by row. `file` can
/// also be the .sol or .solb, with its mesh beside it.
///
/// Listed as dropped: binary keywords of unknown code or form, bytes that a binary keyword has behind its
/// numbers, lines behind those that a keyword announces, everything behind End, solutions for another number
/// of vertices or that cannot be read, and what else stands in a .sol. Comments (from # to the end of a line)
/// are no data.
Document read_medit(const InputFile& file);

/// Plans a file of dimension 3 with doubles: text, or binary of version 2 (version 3 beyond 2 GiB, version 4
/// for numbers beyond 32 bits). Elements are listed by kind, in the order in which the kinds first come up.
/// Elements of an order that Medit does not have are listed by their corners. Elements that name unknown
/// nodes are left out if these numbers would be those of other nodes. Reals of all nodes with 1, 3 or 9
/// components go into a .sol or .solb beside the file, which has no names for them; a warning says so. Such
/// reals of all elements of a kind go behind them, under "SolAtTetrahedra" and the like; where nodes have
/// none, into the mesh itself, but only if the document comes from a Medit file: not every program reads
/// these. References of nodes are values "references" or what other tools call so (io/model/node_tags.hpp).
/// Integers for all nodes or elements, 1 or 0, that have the name of a keyword such as "Corners" become its
/// list.
std::unique_ptr<FilePlan> plan_medit(const Document& document, bool binary);

}  // namespace tetproof::io
