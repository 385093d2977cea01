// SPDX-License-Identifier: GPL-3.0-or-later
// Plans which TetGen file stores which part of a document. The writers and the list of what is held share
// this plan.
#pragma once

#include <cstdint>
#include <vector>

#include "io/document.hpp"
#include "io/loss/holds.hpp"

namespace tetproof::io {

/// The elements of a file, in the document's order.
struct TetgenList {
  std::vector<const ElementBlock*> blocks;
  std::size_t count = 0;
  int nodes_each = 0;  ///< as they are written; of polygons: 0
};

/// Values are null where the file has no place for them.
struct TetgenPlan {
  bool plc = false;
  bool renumber_nodes = false, renumber_elements = false;
  std::int64_t base = 1;  ///< of all numbers
  TetgenList tets, faces, edges;
  TetgenList polygons;              ///< of a .poly or .smesh
  bool facets_as_said = true;       ///< each is a run of polygons of its own
  std::vector<std::size_t> facets;  ///< positions in `Document::facets`, of those that are

  const Values *attributes = nullptr, *markers = nullptr, *sizes = nullptr;  // of nodes
  const Values *tet_attributes = nullptr, *neighbours = nullptr, *tet_faces = nullptr, *tet_edges = nullptr,
               *volume_bounds = nullptr;
  const Values *face_markers = nullptr, *face_tets = nullptr, *face_edges = nullptr;
  const Values *edge_markers = nullptr, *edge_tets = nullptr;
  const Values* facet_markers = nullptr;
  bool bounds = false, voronoi = false;

  // The first physical group of each element, 0 for none, stands where the document has no attributes or
  // markers, for TetGen to see; our reader has it from the supplement.
  bool tet_groups = false, face_groups = false, edge_groups = false, polygon_groups = false;

  /// The number that stands for a node.
  std::int64_t number(const Document&, Index node) const;
};
/// The first physical group of a block; 0: none.
std::int64_t first_group(const Document&, const ElementBlock&);
/// The number that is written for `Document::unknown[k]`.
std::int64_t tetgen_unknown(const Document&, std::int64_t base, std::size_t k);

/// The plan of .node, .ele and the other files of a mesh, and what these hold.
TetgenPlan tetgen_mesh_plan(const Document&);
Holds tetgen_mesh_holds(const Document&, const TetgenPlan&);
/// The plan of a .poly or .smesh and the files beside it, and what these hold.
TetgenPlan tetgen_plc_plan(const Document&);
Holds tetgen_plc_holds(const Document&, const TetgenPlan&, bool smesh);

}  // namespace tetproof::io
