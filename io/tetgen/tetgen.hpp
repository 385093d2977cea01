// SPDX-License-Identifier: GPL-3.0-or-later
// TetGen's files. Facts: its manual, section 5, https://wias-berlin.de/software/tetgen, and versions 1.5
// and 1.6.
//
// A mesh is the files .node .ele .face .edge .neigh .vol .mtr .var .t2f .t2e .f2e and .v.node .v.edge .v.face
// .v.cell of one name, as TetGen's switch -r reads them. The input of meshing is .poly or .smesh with .node
// (if it has no points of its own) .edge .mtr .var, as -p reads them. They become these parts of a document:
//
//   .node   points; values of nodes "attributes" (reals), "markers" (integers)
//   .ele    tetrahedra of type 4 or 11; values "attributes" (reals). Their numbers are the elements' tags
//   .face   triangles (2 or 9), behind the tetrahedra; "markers"; with -nn "neighbours", two tetrahedra each
//   .edge   lines (1 or 8), behind the triangles; "markers"; with -nn "neighbours", one tetrahedron each
//   .neigh  "neighbours" of tetrahedra, 4 integers
//   .t2f    "faces" of tetrahedra, 4 integers; .t2e: "edges", 6; .f2e: "edges" of triangles, 3
//   .vol    "volume bounds" of tetrahedra (reals, not positive: none)
//   .mtr    "sizes" of nodes, 1, 3 or 6 reals
//   .var    area_bounds and length_bounds
//   .v.*    voronoi
//   .poly   polygons as elements with `of_boundary`, by their corners: points (15), lines (1), triangles (2),
//           quadrangles (3), polygons (34); their "markers", the same for all polygons of a facet; `facets`
//           for those with several polygons or holes; holes, regions. Behind them the lines of .edge
//
// Attributes of tetrahedra and markers of triangles, lines and polygons that are tags become physical groups
// (io/model/groups_of_values.hpp), and groups are written as attributes and markers: the first of each
// element, 0 for none. Negative markers, as TetGen 1.6 gives to what has none, stay values of their elements;
// they are written beside the groups, and any other values of that name are not. Markers of nodes are written
// from what other tools call so, too (io/model/node_tags.hpp).
//
// Values belong to the elements of one file, and `first` is the first of them. Integers that are numbers of
// elements are kept as in the file, counted from its first number.
//
// Listed as dropped: words behind the columns that are read, lines behind those that a file announces,
// numbers of faces, edges, holes, ... that do not count up, attributes and markers of Voronoi points, and
// files that lack the file that they describe. Comments are no data, except for our own supplement.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/file_plan.hpp"
#include "io/model/element_types.hpp"
#include "io/model/read_document.hpp"

namespace tetproof::io {

/// The item of `Document::dropped` for a file that goes on behind the lines that its first line announces.
inline constexpr const char* lines_behind_those_announced = "lines behind those that a file announces";

/// Reads the file and all others of its set that are there. The numbers of the nodes must count up from 0 or
/// 1; a number that no node has is kept as such. InputError for standard input, which is one file only.
ReadDocument read_tetgen(const InputFile& file, Wanted wanted);
/// Reads a .poly or a .smesh, whatever its name, and the files beside it. Standard input has none beside it:
/// InputError if its points are elsewhere. A surface wanted: with the place of each polygon, and without
/// the supplement, which may move elements.
ReadDocument read_poly(const InputFile& file, Wanted wanted);
ReadDocument read_smesh(const InputFile& file, Wanted wanted);

/// A mesh: .node and .ele, and each of the other files that the document has content for. All of them appear,
/// or none. The supplement (io/supplement/supplement.hpp) goes into comments at the end of the .node.
/// Writing to a path that names a file of the set for which there is no content is an InputError.
std::unique_ptr<FilePlan> plan_tetgen(const Document& document, bool binary);
/// A .poly: the elements with `of_boundary`, or else all of two dimensions, with all points, holes and
/// regions; and .edge, .mtr, .var where there is content for them. The supplement goes to the end of the
/// .poly.
std::unique_ptr<FilePlan> plan_poly(const Document& document, bool binary);
/// Likewise a .smesh. Writing a facet of several polygons or with holes is an InputError: a .smesh cannot say
/// it.
std::unique_ptr<FilePlan> plan_smesh(const Document& document, bool binary);

}  // namespace tetproof::io
