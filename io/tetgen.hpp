// SPDX-License-Identifier: GPL-3.0-or-later
// TetGen's .node and .ele. Facts: TetGen's manual, section 5, https://wias-berlin.de/software/tetgen
#pragma once

#include <string>

#include "io/document.hpp"
#include "io/element_types.hpp"
#include "io/holds.hpp"

namespace tetproof::io {

/// TetGen's order of a second-order tetrahedron: its node k is Gmsh's node `tetgen_order[k]`.
inline constexpr int tetgen_order[10] = {0, 1, 2, 3, 8, 7, 4, 5, 9, 6};

/// Reads `stem`.node and `stem`.ele. Without the .ele it is a document of nodes, but not if `needs_elements`.
/// The numbers of the nodes must count up from 0 or 1; a corner that is no node's number is kept as such.
/// Attributes and markers become values.
Document read_tetgen(const std::string& stem, bool needs_elements);

/// What TetGen does to a document; the writer and the list of losses must agree on it.
struct TetgenLimits {
  bool renumber_nodes = false;     ///< they do not count up from 0 or 1
  bool renumber_elements = false;  ///< nor do the tetrahedra, from the same number
  int nodes_each = 4;              ///< 10 if all tetrahedra are of second order
};
TetgenLimits tetgen_limits(const Document& document);

Holds tetgen_holds(const Document& document);

/// Writes `stem`.node and `stem`.ele, the tetrahedra only, with the values called "attributes" and "markers".
/// `supplement`: what the rest of the document comes to, io/supplement.hpp; it stands in comments.
void write_tetgen(const std::string& stem, const Document& document, const std::string& supplement = {});

/// The values called `name`, or null.
const Values* values_named(const std::vector<Values>& values, const std::string& name);

}  // namespace tetproof::io
