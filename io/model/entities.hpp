// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes of entities, and what of a document's entities its elements and nodes tell.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// The least coordinates, then the largest. Empty: the least are infinite.
using EntityBox = std::array<double, 6>;
inline constexpr EntityBox empty_box = [] {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return EntityBox{infinity, infinity, infinity, -infinity, -infinity, -infinity};
}();

/// Makes the box contain the point, unless a coordinate of the point is not finite.
void grow(EntityBox& box, const Eigen::Vector3d& point);
/// Makes the box contain all nodes of a block's elements.
void grow(EntityBox& box, const Document& document, const ElementBlock& block);
/// Makes the box contain all nodes of a block.
void grow(EntityBox& box, const Document& document, const NodeBlock& block);

/// The document's entities that its elements and nodes alone do not tell: with a boundary, part of a
/// partition, in groups that their elements are not in, without elements, or with another box than their
/// elements have.
std::vector<Entity> underived_entities(const Document& document);

}  // namespace tetproof::io
