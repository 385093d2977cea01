// SPDX-License-Identifier: GPL-3.0-or-later
// What a format holds of a document: each format says it of itself, and the list of losses follows from it.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "io/document.hpp"
#include "io/losses.hpp"

namespace tetproof::io {

enum class Of { node, element, element_node };  ///< what values belong to

/// What is there of values of which a format holds the numbers alone.
struct HeldNumbers {
  std::string name;           ///< that they have in the file
  std::size_t gaps = 0;       ///< nodes or elements in the file that had none, and have NaN or 0 there
  std::size_t first_gap = 0;  ///< the position of the first in the document
};

/// What comes back unchanged when a document is written and read again. It is asked per document, since what
/// a format holds may depend on it: 32-bit numbers, elements that all are of second order.
struct Holds {
  /// Where the writer puts what the format has no place for, so that our reader takes it back: "comments",
  /// "$TetproofSupplement"; empty: nowhere.
  std::string kept_in;

  bool node_tags = false, element_tags = false;  ///< any numbers; else such that count up from 0 or 1
  /// Where elements cannot have any numbers: they count from 1 with those that are left out.
  bool numbers_all_elements = false;
  bool unknown_nodes = false;  ///< elements that name numbers which no node has
  /// The number under which the writer writes `Document::unknown[k]`; empty: that one.
  std::function<std::int64_t(std::size_t k)> unknown_number{};
  enum class Nodes { of_elements, of_no_other_elements, all };
  /// Which nodes are written: those that a written element has, also those that no element has, or all.
  Nodes which_nodes = Nodes::all;
  bool single = false;  ///< coordinates are rounded to 32 bits
  /// Nodes have no numbers: they come back in the order in which elements name them, and those at the same
  /// place (-0 is 0, NaN equals nothing) as one, with the coordinates of the first.
  bool nodes_by_place = false;

  bool element_entities = false, node_entities = false;  ///< the tag and dimension of their entity
  bool entities = false;                                 ///< their boxes, boundaries, parents
  /// Elements whose entity is written under another tag, since groups belong to entities; and the first one.
  std::int64_t changed_entities = 0;
  std::string changed_entity;
  enum class Groups { none, first, all } groups = Groups::none;
  bool group_names = false, partitions = false, partition_count = false, ghosts = false, parameters = false,
       periodic = false;
  bool boundary = false;        ///< that elements are polygons of what to mesh, not of the mesh
  bool makes_boundary = false;  ///< that they come back as such polygons if they are none
  bool facets = false, holes = false, regions = false, bounds = false, voronoi = false, tables = false,
       title = false;

  /// How many nodes of each element of a block are written: all, or only its corners; 0: the elements are
  /// not.
  std::function<int(const ElementBlock&)> nodes_each = [](const ElementBlock&) { return 0; };
  /// Polygons that a format without them cuts into a fan of triangles, in their place: the corner where it
  /// starts; -1: the element is left out. Asked of elements of which `nodes_each` is 0; not set: so are all.
  std::function<std::ptrdiff_t(const ElementBlock&, const Index* nodes)> cut_at;
  /// Formats that list elements by kind: a number for the kind of a block, ascending in the order in which
  /// the reader gives them back. All alike: any order of blocks is held.
  std::function<int(const ElementBlock&)> kind = [](const ElementBlock&) { return 0; };
  std::function<bool(const Values&, Of)> values = [](const Values&, Of) { return false; };
  /// Of values that are not held: whether all their numbers are there nevertheless, if not their labels and
  /// times. Not set: never.
  std::function<std::optional<HeldNumbers>(const Values&, Of)> numbers;
  /// Where it depends on the block, the name or the table, whether its groups or it come back; not set: as
  /// `groups`, `group_names` and `tables` say.
  std::function<bool(const ElementBlock&)> groups_of;
  std::function<bool(const GroupName&)> name;
  std::function<bool(const Table&)> table;
  std::function<bool(const Section&)> section = [](const Section&) { return false; };
};

/// Whether values have a time, step, partition or scheme; without them nothing depends on whether they are of
/// a view.
bool has_step(const Values& values);

/// What is not held, item by item.
std::vector<Loss> unheld(const Document& document, const Holds& holds);

}  // namespace tetproof::io
