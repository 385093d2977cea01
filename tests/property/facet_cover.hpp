// SPDX-License-Identifier: GPL-3.0-or-later
// Whether triangles may be those into which a facet of several polygons was cut.
#pragma once

#include <array>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "documents_pairing.hpp"
#include "io/document.hpp"

namespace tetproof::test {

class FacetCover {
 public:
  FacetCover(const Document& document, const std::vector<Element>& elements, const Facet& facet);

  /// Whether the triangles have corners of the facet only, turn as its largest face does, and end at its
  /// sides. If no hole is near, they have all corners of its faces. Where rounding may decide, the answer is
  /// yes.
  bool may_be(std::span<const std::array<Index, 3>> triangles) const;

 private:
  using Side = std::pair<Index, Index>;

  long double area(std::span<const Index> corners, std::size_t axis) const;
  bool hole_is_near(const Facet& facet) const;
  bool is_on(Index node, const Side& side) const;

  const Document& document_;
  std::vector<Side> sides_;
  std::set<Index> corners_;         // of all its polygons
  std::set<Index> always_covered_;  // corners that no hole can take away
  std::size_t axis_ = 0;            // the one along which the largest face is seen best
  long double largest_ = 0;         // its area as seen so; 0: no face has any
};

}  // namespace tetproof::test
