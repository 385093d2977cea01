// SPDX-License-Identifier: GPL-3.0-or-later
// What a format holds of a document. Each format describes itself, and the list of losses follows from its
// description.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/losses.hpp"

namespace tetproof::io {

enum class Of { node, element, element_node };  ///< what values belong to

/// Values stored only in part: the numbers survive, labels and times do not.
struct HeldNumbers {
  std::string name;           ///< the name of the values in the file
  std::size_t gaps = 0;       ///< written nodes or elements without a value; the file has NaN or 0 there
  std::size_t first_gap = 0;  ///< the position of the first such node or element in the document
};

/// What comes back unchanged when a document is written and read again. This depends on the document too:
/// whether numbers fit 32 bits, for example, or whether all elements are of second order.
struct Holds {
  /// Where the writer keeps what the format has no place for, so that our reader can put it back: "comments"
  /// or "$TetproofSupplement". Empty: nothing is kept.
  std::string kept_in;

  /// Whether nodes and elements can have any numbers. If not, only numbers that count up from 0 or 1 come
  /// back.
  bool node_tags = false, element_tags = false;
  /// Used where elements cannot have any numbers: the file counts all elements of the document from 1,
  /// including those that are left out.
  bool numbers_all_elements = false;
  bool unknown_nodes = false;  ///< elements that name numbers which no node has
  /// The number under which the writer writes `Document::unknown[k]`. Not set: that number itself.
  std::function<std::int64_t(std::size_t k)> unknown_number{};
  /// Which nodes are written: those of a written element; these and those that no element has; or all.
  enum class Nodes { of_elements, of_no_other_elements, all };
  Nodes which_nodes = Nodes::all;
  bool single = false;  ///< coordinates are rounded to 32 bits
  /// Nodes have no numbers: they come back in the order in which elements name them. Nodes at the same place
  /// come back as one, with the coordinates of the first (-0 equals 0, and NaN equals nothing).
  bool nodes_by_place = false;

  bool element_entities = false, node_entities = false;  ///< the tag and the dimension of their entity
  bool entities = false;                                 ///< boxes, boundaries and parents of entities
  /// How many elements come into an entity with another tag, because groups belong to entities; and a
  /// description of the first.
  std::int64_t changed_entities = 0;
  std::string changed_entity;
  /// Which of an element's physical groups come back.
  enum class Groups { none, first, all } groups = Groups::none;
  bool partitions = false, partition_count = false, parameters = false, periodic = false;
  bool ghosts = false, ghost_entities = false;  ///< ghost elements, and the entities for them
  bool boundary = false;        ///< that elements are polygons of what to mesh, not of the mesh
  bool makes_boundary = false;  ///< elements that are no such polygons come back as such
  bool facets = false, holes = false, regions = false, bounds = false, voronoi = false, title = false;

  /// How many nodes of each element of a block are written: all, or only its corners. 0: no element is.
  std::function<int(const ElementBlock&)> nodes_each = [](const ElementBlock&) { return 0; };
  /// For formats that write a polygon as triangles: appends those of element `e` of the block. False: the
  /// element is left out. Asked for elements of which `nodes_each` is 0. Not set: all of these are left out.
  std::function<bool(const ElementBlock&, std::size_t e, std::vector<std::array<Index, 3>>&)> cut_into;
  /// For formats that list elements by kind: a number for the kind of a block. Kinds come back in ascending
  /// order. The same number for all blocks: any order of blocks comes back.
  std::function<int(const ElementBlock&)> kind = [](const ElementBlock&) { return 0; };
  std::function<bool(const Values&, Of)> values = [](const Values&, Of) { return false; };
  /// For values of integers that are not held: whether they are stored as reals, each of which is the
  /// integer.
  std::function<bool(const Values&, Of)> as_reals = [](const Values&, Of) { return false; };
  /// For values that are not held: what is stored of them nevertheless. Not set: nothing, for all values.
  std::function<std::optional<HeldNumbers>(const Values&, Of)> numbers;
  /// Whether the roles of values come back that are held, or of which the numbers are.
  std::function<bool(const Values&, Of)> roles = [](const Values& of, Of) { return of.roles.empty(); };
  /// Whether the physical groups of a block's elements come back, all or the first of them, where this
  /// depends on the block. Not set: as `groups` says.
  std::function<bool(const ElementBlock&)> groups_of;
  std::function<bool(const GroupName&)> name = [](const GroupName&) { return false; };
  std::function<bool(const Table&)> table = [](const Table&) { return false; };
  std::function<bool(const Section&)> section = [](const Section&) { return false; };
};

/// Lists everything that is not held, item by item.
std::vector<Loss> unheld(const Document& document, const Holds& holds);

/// Elements that are written though they name nodes which do not exist. Our reader takes them back; the
/// format's own programs refuse the file or read something else. One item, or none.
std::vector<Loss> dangling(const Document& document, const Holds& holds);

}  // namespace tetproof::io
