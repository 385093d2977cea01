// SPDX-License-Identifier: GPL-3.0-or-later
// Plans the entities that a .msh 4.0 or 4.1 file must list: those of the document, and those that its blocks
// only name.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

struct EntityPlan {
  /// The entities in the order in which they are written: by dimension, new ones after the document's, all
  /// entities of partitions last.
  std::vector<Entity> entities;
  /// Dimension and tag of those that the document does not list. Their boxes are not computed yet.
  std::vector<std::pair<int, std::int64_t>> new_entities;
  std::int64_t partitions = 0;           ///< the number of partitions
  std::vector<GhostEntity> ghosts;       ///< the document's, and one for each further partition with ghosts
  std::vector<std::int64_t> block_tags;  ///< the tag under which each element block is written
  std::vector<NodeBlock> node_blocks;    ///< covering all nodes, in order
};

/// In 4.0 and 4.1 groups and partitions belong to entities: blocks of one entity with different groups or
/// partitions become different entities.
EntityPlan plan_entities(const Document& document);

/// Gives the new entities of a plan the boxes of their elements and nodes. Only the writer needs them.
void compute_new_boxes(const Document& document, EntityPlan& plan);

}  // namespace tetproof::io
