// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model/entities.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace tetproof::io {

void grow(EntityBox& box, const Eigen::Vector3d& point) {
  if (!point.allFinite()) return;
  for (int k = 0; k < 3; ++k) {
    box[k] = std::min(box[k], point[k]);
    box[3 + k] = std::max(box[3 + k], point[k]);
  }
}

namespace {

// Of equal numbers the first stays, as if the items came one by one: 0 and -0 are equal and written
// differently.
EntityBox joined(EntityBox box, const EntityBox& next) {
  for (int k = 0; k < 3; ++k) {
    box[k] = std::min(box[k], next[k]);
    box[3 + k] = std::max(box[3 + k], next[k + 3]);
  }
  return box;
}

// Grows the box by `count` items, in parallel. grow_by(box, i) grows a box by item i.
template <class GrowBy>
void grow_by_all(EntityBox& box, std::size_t count, const GrowBy& grow_by) {
  using Range = tbb::blocked_range<std::size_t>;
  const EntityBox all = tbb::parallel_reduce(
      Range(0, count, 1 << 16), empty_box,
      [&](const Range& range, EntityBox part) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) grow_by(part, i);
        return part;
      },
      joined);
  box = joined(box, all);
}

}  // namespace

void grow(EntityBox& box, const Document& document, const ElementBlock& block) {
  grow_by_all(box, block.count * block.nodes_each, [&](EntityBox& part, std::size_t i) {
    const Index node = document.connectivity[block.nodes + i];
    if (node >= 0) grow(part, document.points[node]);
  });
}

void grow(EntityBox& box, const Document& document, const NodeBlock& block) {
  grow_by_all(box, block.count,
              [&](EntityBox& part, std::size_t i) { grow(part, document.points[block.first + i]); });
}

std::vector<Entity> underived_entities(const Document& document) {
  std::map<std::pair<int, std::int64_t>, EntityBox> boxes;
  std::set<std::tuple<int, std::int64_t, std::int32_t>> of_elements;
  for (const ElementBlock& block : document.blocks) {
    of_elements.insert({block.dim, block.entity, block.groups});
    grow(boxes.try_emplace({block.dim, block.entity}, empty_box).first->second, document, block);
  }
  for (const NodeBlock& block : document.node_blocks)
    if (const auto box = boxes.find({block.dim, block.entity}); box != boxes.end())
      grow(box->second, document, block);
  for (auto& [id, box] : boxes)
    if (id.first == 0) std::copy_n(box.begin(), 3, box.begin() + 3);  // as they are written for points
  std::vector<Entity> underived;
  for (const Entity& entity : document.entities)
    if (!entity.boundary.empty() || entity.parent_dim >= 0 ||
        !of_elements.count({entity.dim, entity.tag, entity.groups}) ||
        boxes.at({entity.dim, entity.tag}) != entity.box)
      underived.push_back(entity);
  return underived;
}

}  // namespace tetproof::io
