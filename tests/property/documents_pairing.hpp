// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs the nodes and elements of a document with those that came back.
#pragma once

#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof::test {

/// An element on its own, without its block.
struct Element {
  int type = 0, dim = 0;
  std::int64_t entity = 0, tag = 0;
  std::vector<std::int64_t> groups, partitions;
  bool of_boundary = false;
  std::vector<Index> nodes;
  bool names_unknown() const;  ///< whether it names a node that does not exist
};
std::vector<Element> elements_of(const Document& document);

constexpr Index none = -1;

struct Pairing {
  std::vector<Index> node_before;     ///< for each node of `after`; `none`: it is new
  std::vector<Index> node_after;      ///< for each node of `before`; `none`: it is lost
  std::vector<Index> element_before;  ///< likewise
  std::vector<Index> element_after;
  std::vector<Index> cut_before;  ///< for each element of `after`, the polygon that it is a triangle of
  std::vector<Index> cut_after;   ///< for each element of `before`, the first of its triangles
};

/// Which elements a format can hold; nothing else is known of it. All elements, those whose nodes all exist,
/// or only triangles (polygons are cut) whose nodes all exist.
enum class Holding { elements, elements_of_nodes, triangles };

/// Pairs nodes by the 32-bit value of their x. Pairs elements by their type and nodes, or by their corners if
/// a higher-order element lost its other nodes. Equal elements are paired in order. If the format holds only
/// triangles, a polygon of n corners is paired with n - 2 consecutive triangles that cover it, and every face
/// of a facet with the consecutive triangles that cover the facet.
Pairing pair_up(const Document& before, const std::vector<Element>& elements_before, const Document& after,
                const std::vector<Element>& elements_after, Holding holding);

}  // namespace tetproof::test
