// SPDX-License-Identifier: GPL-3.0-or-later
// What a format holds of a document: each format says it of itself, and the list of losses follows from it.
#pragma once

#include <functional>
#include <string>

#include "io/document.hpp"

namespace tetproof::io {

enum class Of { node, element, element_node };  ///< what values belong to

/// What comes back unchanged when a document is written and read again. It is asked per document, since what
/// a format holds may depend on it: 32-bit numbers, elements that all are of second order.
struct Holds {
  /// Where the writer puts what the format has no place for, so that our reader takes it back: "comments",
  /// "$TetproofSupplement"; empty: nowhere.
  std::string kept_in;

  bool node_tags = false, element_tags = false;  ///< any numbers; else such that count up from 0 or 1
  bool unknown_nodes = false;                    ///< elements that name numbers which no node has
  bool loose_nodes = true;                       ///< nodes that no written element has
  bool single = false;                           ///< coordinates are rounded to 32 bits
  /// Nodes have no numbers: they come back in the order in which elements name them, and those at the same
  /// place (-0 is 0, NaN equals nothing) as one, with the coordinates of the first.
  bool nodes_by_place = false;
  /// Faces of more than three corners that are planar and convex come back as the triangles of a fan, in
  /// their place; `nodes` is 0 for them.
  bool cuts_polygons = false;

  bool element_entities = false, node_entities = false;  ///< the tag and dimension of their entity
  bool entities = false;                                 ///< their boxes, boundaries, parents
  enum class Groups { none, first, all } groups = Groups::none;
  bool group_names = false, partitions = false, ghosts = false, parameters = false, periodic = false;
  bool facets = false, holes = false, regions = false, bounds = false, voronoi = false, tables = false,
       title = false;

  /// How many nodes of each element of a block are written: all, or only its corners; 0: the elements are
  /// not.
  std::function<int(const ElementBlock&)> nodes = [](const ElementBlock&) { return 0; };
  /// Formats that list elements by kind: a number for the kind of a block, ascending in the order in which
  /// the reader gives them back. All alike: any order of blocks is held.
  std::function<int(const ElementBlock&)> kind = [](const ElementBlock&) { return 0; };
  std::function<bool(const Values&, Of)> values = [](const Values&, Of) { return false; };
  /// Where it depends on the block or the name, whether its groups come back; not set: as `groups` and
  /// `group_names` say.
  std::function<bool(const ElementBlock&)> groups_of;
  std::function<bool(const GroupName&)> name;
  std::function<bool(const Section&)> section = [](const Section&) { return false; };
};

}  // namespace tetproof::io
