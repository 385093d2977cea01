// SPDX-License-Identifier: GPL-3.0-or-later
// Medit's .mesh (text) and .meshb (binary), which libMeshb calls the Gamma Mesh Format.
// Facts: https://github.com/LoicMarechal/libMeshb and meshio's medit module.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/file_plan.hpp"

namespace tetproof::io {

/// Reads text, keywords in any order, and binary files of versions 1 to 4 and both byte orders; the content
/// tells which it is. References of nodes become node values "references", unless all are 0, and those of
/// elements physical groups, but 0. "Corners", "RequiredVertices", "Ridges", "RequiredEdges",
/// "RequiredTriangles" and "RequiredQuadrilaterals" become values, all 1, of the nodes or elements that they
/// list; all other keywords sections, as text. Binary keywords of an unknown form are skipped with a warning.
/// Elements of second order are taken in the order that a keyword such as TetrahedraP2Ordering says, if there
/// is one. What no node or element has as its number is kept as such.
Document read_medit(const InputFile& file);

/// Dimension 3, doubles. Text, or binary of version 2; of 3 beyond 2 GiB, of 4 for numbers beyond 32 bits.
/// Elements are listed by kind; those of an order that Medit does not have by their corners. Elements that
/// name unknown nodes are left out where their numbers would stand for others.
std::unique_ptr<FilePlan> plan_medit(const Document& document, bool binary);

}  // namespace tetproof::io
