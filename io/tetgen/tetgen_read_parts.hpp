// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the reader of TetGen's files. All of them add to one document.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/tetgen/tetgen_records.hpp"

namespace tetproof::io {

/// Elements of one kind in a document that is being read, and their file.
struct TetgenElements {
  std::string path;
  std::size_t first = 0, count = 0;
  std::size_t nodes = 0;  ///< where their connectivity starts
  int nodes_each = 0;     ///< 0: there is no such file
};

/// The first line of a .node, .poly or .smesh.
struct TetgenNodeHeader {
  std::int64_t count = 0, attributes = 0;
  bool marked = false;
};
TetgenNodeHeader read_node_header(Records&);
/// Reads the nodes. The document has none yet.
void read_nodes(Records&, const TetgenNodeHeader&, Document&);
/// Reads a .node file.
void read_node_file(const std::string& path, Document&);

/// The form of an .ele, .face or .edge file whose first line has been read.
struct TetgenElementFile {
  const char *one, *many;  ///< "tetrahedron", "tetrahedra"
  const char* number;      ///< "the number of a tetrahedron"
  int corners = 4;
  std::size_t count = 0;
  int nodes_each = 4, attributes = 0;
  bool marked = false;
  int tets = 0;             ///< columns of -nn: the tetrahedra at an element
  bool with_values = true;  ///< attributes and markers are kept
};
TetgenElementFile read_ele_header(Records&);
/// `tets`: the nodes of each tetrahedron in the .ele, 0 if there is none. They decide what the columns may
/// mean.
TetgenElementFile read_face_header(Records&, int tets);
/// `others`: the nodes of each tetrahedron. Without tetrahedra: 10 if the faces are of second order,
/// otherwise 4.
TetgenElementFile read_edge_header(Records&, int others);
TetgenElements read_elements(Records&, const TetgenElementFile&, NodeIndex&, Document&);

/// Reads `each` integers for each of the elements, from a file with a first line (.neigh) or without one
/// (.t2f, .t2e, .f2e).
void read_element_integers(Records&, const TetgenElements&, const char* many, const char* name, int each,
                           bool has_header, Document&);
void read_volume_bounds(Records&, const TetgenElements& tets, Document&);
void read_sizes(Records&, const std::string& node_path, Document&);
void read_bounds(Records&, NodeIndex&, Document&);

/// Reads the files `stem`.v.node, .v.edge, .v.face and .v.cell.
void read_voronoi(const std::string& stem, Document&);

/// Reads a .poly or a .smesh; returns whether its points are in the .node at `node_path` (empty: there can be
/// none). `places`, if not null, gets the byte where each polygon starts.
bool read_plc(Records&, const std::string& node_path, bool smesh, Document&,
              std::vector<std::size_t>* places = nullptr);

}  // namespace tetproof::io
