// SPDX-License-Identifier: GPL-3.0-or-later
// Plans which TetGen file stores which part of a document. The writers and the list of what is held share
// this plan.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "io/document.hpp"
#include "io/loss/holds.hpp"

namespace tetproof::io {

/// The elements of a file, in the document's order.
struct TetgenList {
  std::vector<const ElementBlock*> blocks;
  std::size_t count = 0;
  int nodes_each = 0;  ///< how many nodes are written; 0 for polygons
};

/// The column of attributes or markers behind the elements of a list: `values` of all of them; or else, if
/// `groups`, the first physical group of each (0: none), and the `others`, negative numbers that some
/// elements without a group have.
struct TetgenTags {
  const Values* values = nullptr;
  bool groups = false;
  std::vector<std::pair<Index, std::int64_t>> others{};  ///< elements and their numbers, ascending
  const Values* of_others = nullptr;                     ///< the values that have these numbers

  /// Returns the number in the column of an element of this block, if `groups`.
  std::int64_t group_of(const Document&, const ElementBlock&, std::size_t element) const;
};

/// Values are null where there are none that the file has a place for.
struct TetgenPlan {
  bool plc = false;
  bool renumber_nodes = false, renumber_elements = false;
  std::int64_t base = 1;  ///< of all numbers
  TetgenList tets, faces, edges;
  TetgenList polygons;              ///< of a .poly or .smesh
  bool facets_as_said = true;       ///< each facet is a run of polygons that no other facet has
  std::vector<std::size_t> facets;  ///< positions in `Document::facets` of those that are such runs

  const Values *attributes = nullptr, *markers = nullptr, *sizes = nullptr;  // of nodes
  const Values *neighbours = nullptr, *tet_faces = nullptr, *tet_edges = nullptr, *volume_bounds = nullptr;
  const Values *face_tets = nullptr, *face_edges = nullptr, *edge_tets = nullptr;
  TetgenTags tet_tags, face_tags, edge_tags, facet_tags;
  bool bounds = false, voronoi = false;

  /// Returns the number that is written for a node.
  std::int64_t number(const Document&, Index node) const;
};
/// Returns the first physical group of a block, without a sign of Gmsh's; 0: it has none.
std::int64_t first_group(const Document&, const ElementBlock&);
/// Returns the number that is written for `Document::unknown[k]`.
std::int64_t tetgen_unknown(const Document&, std::int64_t base, std::size_t k);

/// The plan of .node, .ele and the other files of a mesh, and what these hold.
TetgenPlan tetgen_mesh_plan(const Document&);
Holds tetgen_mesh_holds(const Document&, const TetgenPlan&);
/// The plan of a .poly or .smesh and the files beside it, and what these hold.
TetgenPlan tetgen_plc_plan(const Document&);
Holds tetgen_plc_holds(const Document&, const TetgenPlan&, bool smesh);

}  // namespace tetproof::io
