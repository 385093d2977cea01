// SPDX-License-Identifier: GPL-3.0-or-later
// Polyhedra as VTK's files list their faces.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// A polyhedron, with its nodes in the order in which its faces name them: its own list of nodes has no order
/// that matters, and in legacy files there is none.
struct VtkPolyhedron {
  std::vector<std::int64_t> nodes;
  std::vector<std::int32_t> faces;  ///< as in `ElementBlock`

  /// `list`: the number of faces, and for each face the number of its nodes and these. `more`: nodes that may
  /// be among those of the faces; any others come behind them. Returns what is wrong; empty: nothing.
  std::string read(std::span<const std::int64_t> list, std::span<const std::int64_t> more);

 private:
  std::int32_t place(std::int64_t node);

  std::unordered_map<std::int64_t, std::int32_t> place_;
};

/// How many of the nodes of a block's polyhedra their faces name.
int nodes_of_faces(const ElementBlock& block);

/// Polyhedra as VTK 9.4 and later list them in XML files: face f has the corners up to `face_ends[f]`, and
/// cell c the faces up to `ends[c]` in `faces`.
struct VtkFaces {
  std::vector<std::int64_t> corners, face_ends, faces, ends;

  bool empty() const { return corners.empty() && face_ends.empty() && faces.empty() && ends.empty(); }
  /// Makes of them the lists of `VtkPiece`. Returns what is wrong; empty: nothing.
  std::string lists(std::vector<std::int64_t>& faces_of_cells,
                    std::vector<std::int64_t>& ends_of_cells) const;
};

}  // namespace tetproof::io
