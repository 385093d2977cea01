// SPDX-License-Identifier: GPL-3.0-or-later
// What VTK's two readers have in common: cells and arrays as a file has them, and how they join a document.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "io/document.hpp"
#include "io/model/tag_sets.hpp"
#include "io/vtk/vtk_tags.hpp"
#include "io/vtk/vtk_types.hpp"

namespace tetproof::io {

/// Cells and arrays in VTK's terms, as they stand in a file and not yet checked.
struct VtkPiece {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::int64_t> connectivity, ends;  ///< cell c ends at `ends[c]` in the connectivity
  std::vector<std::int64_t> types;
  /// The faces of polyhedra: for each their number, and for each face the number of its points and these.
  /// Those of cell c end at `face_ends[c]`; -1: it has none.
  std::vector<std::int64_t> faces, face_ends;
  bool faces_in_cells = false;  ///< they stand in the connectivity, in place of the points of the cell
  std::vector<Column> point_data, cell_data;
  std::vector<VtkRole> point_roles, cell_roles;
  std::optional<VtkTagNames>
      tags;           ///< of a file with several pieces: which cell data are tags in all of them
  std::string which;  ///< of a file with several pieces: " of piece 2", for messages
};

/// The numbers of the texts of arrays, by the array's name.
using VtkLabels = std::map<std::string, std::unordered_map<std::string, std::int64_t>>;

class VtkPieces {
 public:
  explicit VtkPieces(Document& document) : document_(document), sets_(document) {}

  /// Appends a piece to the document. A strip or a cell of many vertices becomes one element for each of its
  /// parts. Pixels and voxels become quadrangles and hexahedra. Cells of types that no document has (Lagrange
  /// hexahedra, quadratic polygons, ...) are left out. All of these are listed as dropped. Bezier cells
  /// become elements of types of their own, with a warning. The nodes of a polyhedron are put in the order in
  /// which its faces name them. The cell data that have one of the words in io/model/tag_words.hpp, and those
  /// called "group 2", "group 3", ..., become entities and physical groups. Strings become integers with
  /// labels. `whole`: the file has only this piece. Then cells keep numbers that no point has. InputError,
  /// naming the cell, where numbers contradict each other.
  void add(VtkPiece&& piece, bool whole);

 private:
  Document& document_;
  TagSets sets_;
  VtkLabels node_labels_, element_labels_;
};

/// Appends an array that belongs to neither points nor cells: a table with one column of the same name.
void add_vtk_field(Document& document, Column&& column);

}  // namespace tetproof::io
