// SPDX-License-Identifier: GPL-3.0-or-later
// The entities that a 4.0 or 4.1 file must list: the document's own, and those that its blocks only name.
#pragma once

#include <cstdint>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

struct EntityPlan {
  std::vector<Entity>
      entities;  ///< as they are written: those of partitions last, by dimension, new ones last
  std::int64_t partitions = 0;           ///< how many
  std::vector<std::int64_t> block_tags;  ///< the tag under which each element block is written
  std::vector<NodeBlock> node_blocks;    ///< covering all nodes, in order
  std::size_t changed_blocks =
      0;  ///< blocks with a tag that had to be another: the same entity in other groups
  std::size_t first_changed = 0;
};

/// In 4.0 and 4.1 groups and partitions belong to entities: blocks of one entity with different ones become
/// different entities. Without boxes, those of new entities are not computed.
EntityPlan plan_entities(const Document& document, bool with_boxes = true);

/// The document's entities that its elements and nodes alone do not tell: with a boundary, part of a
/// partition, in groups that their elements are not in, without elements, or with another box than their
/// elements have.
std::vector<Entity> underived_entities(const Document& document);

}  // namespace tetproof::io
