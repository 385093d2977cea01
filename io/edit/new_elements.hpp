// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces the elements of a document by others that are made of them, with all that belongs to elements.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// Collects the new elements. Each comes from one old element: it is this element, a part of it or a side of
/// it, and inherits its values.
class NewElements {
 public:
  explicit NewElements(const Document& document);

  /// Adds an element with the type, dimension, entity, groups and partitions of `like`, whose nodes are the
  /// nodes `local` of element `from`; `nodes` points to that element's nodes.
  void add(const ElementBlock& like, std::size_t from, const Index* nodes,
           std::span<const std::int32_t> local);
  /// Adds an element with nodes of its own choice, as for a facet of several polygons. Values of nodes of
  /// elements go to no such element.
  void add_free(const ElementBlock& like, std::size_t from, std::span<const Index> nodes);

  std::size_t size() const { return from_.size(); }

  enum class Numbers { kept, anew };
  /// Puts the new elements in the place of the old ones. `kept`: the first new element of an old one has its
  /// number, further ones are numbered behind the largest; in formats that number no elements, all count up.
  /// `anew`: all are numbered from 1. Returns what is lost: values that are numbers of elements, and sections
  /// that may name numbers which are no longer the same.
  std::vector<Loss> replace(Document& document, Numbers numbers = Numbers::kept) &&;

 private:
  void add_place(const ElementBlock& like, std::size_t from, std::size_t nodes);
  void number(Document& document) const;
  void move_values(Document& document) const;
  void move_positions(Document& document) const;

  bool wants_local_;  // the document has values of elements' nodes
  std::vector<ElementBlock> blocks_;
  std::vector<Index> connectivity_;
  std::vector<std::int32_t> local_;  // for each of `connectivity_`: which node of the old element; -1: none
  std::vector<Index> from_;          // of each new element: the old one
  std::vector<std::size_t> starts_;  // by old element: where its new ones start in `made_`
  std::vector<Index> made_;          // new elements, by old ones
};

/// Removes TetGen's values that are numbers of elements ("neighbours", "faces", "edges"), and lists them.
std::vector<Loss> without_element_numbers(Document& document);

/// Removes the sections, which may name numbers of nodes or elements, and lists them.
void leave_out_sections(Document& document, std::vector<Loss>& lost);

}  // namespace tetproof::io
