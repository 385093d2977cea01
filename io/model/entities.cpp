// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model/entities.hpp"

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

void grow(EntityBox& box, const Document& document, const ElementBlock& block) {
  for (std::size_t k = 0; k < block.count * block.nodes_each; ++k) {
    const Index node = document.connectivity[block.nodes + k];
    if (node >= 0) grow(box, document.points[node]);
  }
}

void grow(EntityBox& box, const Document& document, const NodeBlock& block) {
  for (std::size_t i = 0; i < block.count; ++i) grow(box, document.points[block.first + i]);
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
