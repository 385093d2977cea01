// SPDX-License-Identifier: GPL-3.0-or-later
// What VTK's two file formats have in common: cells, and arrays that belong to points, to cells or to
// neither.
#pragma once

#include <deque>
#include <span>
#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/loss/holds.hpp"
#include "io/vtk/vtk_types.hpp"

namespace tetproof::io {

/// Cells and arrays in VTK's terms, as they stand in a file and not yet checked.
struct VtkPiece {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::int64_t> connectivity, ends;  ///< cell c ends at `ends[c]` in the connectivity
  std::vector<std::int64_t> types;
  std::vector<Column> point_data, cell_data;
  std::string which;  ///< of a file with several pieces: " of piece 2", for messages
};

/// Appends a piece to the document. A polyline, a strip or a cell of many vertices becomes one element for
/// each of its parts. Pixels and voxels become quadrangles and hexahedra. Cells of types that no document has
/// (polyhedra, elements of order 3 and more) are left out. All of these are listed as dropped. The cell data
/// "entity" (or "CellEntityIds", Gmsh's name for it) and "group", "group 2", ... become entities and physical
/// groups. Strings become integers with labels. `whole`: the file has only this piece. Then cells keep
/// numbers that no point has. InputError, naming the cell, where numbers contradict each other.
void add_vtk_piece(Document& document, VtkPiece&& piece, bool whole);

/// Appends an array that belongs to neither points nor cells: a table with one column of the same name.
void add_vtk_field(Document& document, Column&& column);

/// Whether cell data of this name become entities or groups, if they are integers.
bool is_array_of_tags(const std::string& name);

/// What a writer writes. An array's numbers are reals or integers.
struct VtkArray {
  std::string name, type = "Float64";
  int components = 1;
  std::span<const double> reals;
  std::span<const std::int64_t> integers;
  std::span<const std::string> texts;
  std::size_t size() const { return reals.size() + integers.size() + texts.size(); }
};
struct VtkMesh {
  std::vector<std::size_t> elements;  ///< positions of those that are written
  std::vector<Index> connectivity;
  std::vector<std::int64_t> ends;
  std::vector<unsigned char> types;
  std::vector<VtkArray> point_data, cell_data, field_data;
  std::deque<std::vector<double>> own_reals;  ///< what the arrays of changed values look at
  std::deque<std::vector<std::int64_t>> own_integers;
};

/// The document in VTK's terms. `entity_name`: what the array of entity tags is called; it is there when any
/// is not 0. Values that not all nodes or elements have are filled up: NaN, 0. Elements that name unknown
/// nodes are left out.
VtkMesh vtk_mesh(const Document& document, const std::string& entity_name);

/// Where the first number stands that is `wanted`: "a point", `point data "a"`, ...; empty: nowhere.
std::string first_place_of(bool (*wanted)(double), const Document& document, const VtkMesh& mesh);

/// What both formats hold.
Holds vtk_holds_common(const Document& document);

}  // namespace tetproof::io
