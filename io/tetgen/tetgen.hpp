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
// Where no element has attributes or markers, the first physical group of each element is written in their
// place (0: none), so that TetGen sees it.
//
// Values belong to the elements of one file, and `first` is the first of them. Integers that are numbers of
// elements are kept as in the file, counted from its first number.
//
// Listed as dropped: words behind the columns that are read, lines behind those that a file announces,
// numbers of faces, edges, holes, ... that do not count up, attributes and markers of Voronoi points, and
// files that lack the file that they describe. Comments are no data, except for our own supplement.
#pragma once

#include <string>
#include <string_view>

#include "io/document.hpp"
#include "io/loss/holds.hpp"
#include "io/model/element_types.hpp"

namespace tetproof::io {

/// Reads the file and all other files of its set that exist. The numbers of the nodes must count up from 0
/// or 1. A number that no node has is kept as such.
Document read_tetgen(const std::string& path);
/// The surface that a .poly or .smesh describes, made with `SurfaceFaces` in io/surface/polygons.hpp. A facet
/// of several polygons or with holes is refused.
TriangleSurface read_tetgen_surface(const std::string& path);

/// Writes the mesh: .node and .ele, and of the others those that the document has something for. All of them
/// appear, or none. `supplement`: what the rest of the document comes to, io/supplement/supplement.hpp; it
/// stands in comments at the end of the .node. InputError if the file named would have nothing to say.
void write_tetgen(const std::string& path, const Document& document, const std::string& supplement = {});
/// Writes the elements with `of_boundary`, or else all of two dimensions, with all points, holes and regions;
/// and .edge .mtr .var where there is something for them. The supplement stands at its end.
void write_poly(const std::string& path, const Document& document, const std::string& supplement = {});
/// Likewise. InputError for a facet of several polygons or with holes, which a .smesh has no way to say.
void write_smesh(const std::string& path, const Document& document, const std::string& supplement = {});

/// A warning of files that are there already, are not written, and would be read together with what is; or
/// nothing. `format`: "tetgen", "poly" or "smesh".
std::string tetgen_left_over(const std::string& path, const Document& document, const std::string& format);

Holds tetgen_holds(const Document& document);
Holds poly_holds(const Document& document);
Holds smesh_holds(const Document& document);

}  // namespace tetproof::io
