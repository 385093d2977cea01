// SPDX-License-Identifier: GPL-3.0-or-later
// Which node and which element of a document came back as which.
#pragma once

#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof::test {

/// An element by itself, out of its block.
struct Element {
  int type = 0, dim = 0;
  std::int64_t entity = 0, tag = 0;
  std::vector<std::int64_t> groups, partitions;
  bool of_boundary = false;
  std::vector<Index> nodes;
  bool names_unknown() const;  ///< a node that does not exist
};
std::vector<Element> elements_of(const Document& document);

constexpr Index none = -1;

struct Pairing {
  std::vector<Index> node_before;     ///< of each node of `after`; `none` for one that was not there
  std::vector<Index> node_after;      ///< of each node of `before`
  std::vector<Index> element_before;  ///< likewise
  std::vector<Index> element_after;
  std::vector<Index> cut_before;  ///< of each element of `after` the polygon that it is a triangle of
  std::vector<Index> cut_after;   ///< of each element of `before` the first of its triangles
};

/// What a format, of which nothing else is known, has place for: any elements, those of nodes that exist, or
/// triangles of nodes that exist and so no others but what is cut into them.
enum class Holding { elements, elements_of_nodes, triangles };

/// Pairs nodes by the 32-bit value of their x, and elements by their type and nodes, or by their corners
/// where those of a higher order lost what stands between. Elements alike are paired in their order. If
/// there are triangles only, a polygon of n corners is paired with n - 2 of them, one after the other, that
/// all start at the same corner and go around it.
Pairing pair_up(const Document& before, const std::vector<Element>& elements_before, const Document& after,
                const std::vector<Element>& elements_after, Holding holding);

}  // namespace tetproof::test
