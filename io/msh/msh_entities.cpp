// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/msh/msh_entities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace tetproof::io {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array<double, 6> empty_box{infinity, infinity, infinity, -infinity, -infinity, -infinity};

void grow(std::array<double, 6>& box, const Eigen::Vector3d& point) {
  if (!point.allFinite()) return;
  for (int k = 0; k < 3; ++k) {
    box[k] = std::min(box[k], point[k]);
    box[3 + k] = std::max(box[3 + k], point[k]);
  }
}

class Planner {
 public:
  Planner(const Document& document, bool with_boxes) : document_(document), with_boxes_(with_boxes) {
    for (const Entity& entity : document.entities) {
      plan_.entities.push_back(entity);
      known_.try_emplace({entity.dim, entity.tag}, Belongs{entity.groups, entity.partitions});
      largest_[entity.dim] = std::max(largest_[entity.dim], entity.tag);
    }
    for (const ElementBlock& block : document.blocks)
      largest_[block.dim] = std::max(largest_[block.dim], block.entity);
    for (const NodeBlock& block : document.node_blocks)
      largest_[block.dim] = std::max(largest_[block.dim], block.entity);
  }

  EntityPlan plan() {
    for (std::size_t b = 0; b < document_.blocks.size(); ++b) {
      const ElementBlock& block = document_.blocks[b];
      const std::int32_t partitions = are_partitions(block.partitions) ? block.partitions : 0;
      const std::int64_t tag = tag_for(block.dim, block.entity, {block.groups, partitions});
      plan_.block_tags.push_back(tag);
      if (tag != block.entity && block.entity != 0 && plan_.changed_blocks++ == 0) plan_.first_changed = b;
      grow_by(block, tag);
      if (partitions != 0 && tag != block.entity) grow_by(block, block.entity);
    }
    cover_nodes();
    for (auto& entity : plan_.entities) {
      const auto box = new_boxes_.find({entity.dim, entity.tag});
      if (box == new_boxes_.end()) continue;
      entity.box = box->second[0] <= box->second[3] ? box->second : std::array<double, 6>{};
      if (entity.dim == 0) std::copy_n(entity.box.begin(), 3, entity.box.begin() + 3);
    }
    std::stable_sort(plan_.entities.begin(), plan_.entities.end(), [](const Entity& a, const Entity& b) {
      return std::pair(a.parent_dim >= 0, a.dim) < std::pair(b.parent_dim >= 0, b.dim);
    });
    plan_.partitions = document_.partitions;
    for (const Entity& entity : plan_.entities)
      for (const std::int64_t partition : document_.tag_sets[entity.partitions])
        if (document_.partitions == 0) plan_.partitions = std::max(plan_.partitions, partition);
    return std::move(plan_);
  }

 private:
  struct Belongs {  // positions in `Document::tag_sets`
    std::int32_t groups = 0, partitions = 0;
    auto operator<=>(const Belongs&) const = default;
  };

  // Ghosts, which 2.2 gives a negative number, are no partitions of an entity.
  bool are_partitions(std::int32_t set) const {
    const auto& tags = document_.tag_sets[set];
    return std::all_of(tags.begin(), tags.end(), [](std::int64_t tag) { return tag > 0; });
  }

  void grow_by(const ElementBlock& block, std::int64_t tag) {
    const auto box = new_boxes_.find({block.dim, tag});
    if (box == new_boxes_.end()) return;
    const std::size_t size = block.count * block.nodes_each;
    for (std::size_t k = 0; k < size; ++k) {
      const Index node = document_.connectivity[block.nodes + k];
      if (node >= 0) grow(box->second, document_.points[node]);
    }
  }

  std::int64_t tag_for(int dim, std::int64_t tag, Belongs to) {
    if (last_ && std::tie(last_dim_, last_wanted_, last_to_) == std::tie(dim, tag, to)) return last_;
    last_dim_ = dim, last_wanted_ = tag, last_to_ = to;
    return last_ = find_tag(dim, tag, to);
  }

  std::int64_t find_tag(int dim, std::int64_t tag, Belongs to) {
    if (const auto renamed = renamed_.find({dim, tag, to}); renamed != renamed_.end()) return renamed->second;
    if (tag != 0) {
      // Elements of a partition get an entity of their own, with the one that they name as its parent.
      const auto [place, is_new] = known_.try_emplace({dim, tag}, Belongs{to.groups, 0});
      if (is_new) add({.dim = dim, .groups = to.groups, .tag = tag});
      if (place->second == to) return tag;
    }
    const std::int64_t fresh = ++largest_[dim];
    renamed_[{dim, tag, to}] = fresh;
    known_[{dim, fresh}] = to;
    Entity entity{.dim = dim, .groups = to.groups, .tag = fresh, .partitions = to.partitions};
    if (to.partitions != 0) entity.parent_dim = dim, entity.parent = tag;
    add(std::move(entity));
    return fresh;
  }

  void add(Entity entity) {
    if (with_boxes_) new_boxes_[{entity.dim, entity.tag}] = empty_box;
    plan_.entities.push_back(std::move(entity));
  }

  // Nodes that belong to no entity are given to that of the block of the highest dimension.
  void cover_nodes() {
    int dim = 3;
    std::int64_t tag = 0;
    for (std::size_t b = 0; b < document_.blocks.size(); ++b)
      if (tag == 0 || document_.blocks[b].dim > dim) dim = document_.blocks[b].dim, tag = plan_.block_tags[b];
    std::size_t covered = 0;
    const auto give = [&](std::size_t to) {
      if (to <= covered) return;
      if (tag == 0) tag = tag_for(dim, 1, {});
      add_node_block({.dim = dim, .entity = tag, .first = covered, .count = to - covered});
    };
    for (NodeBlock block : document_.node_blocks) {
      give(block.first);
      covered = block.first + block.count;
      if (block.entity == 0 || !known_.count({block.dim, block.entity}))
        block.entity = tag_for(block.dim, block.entity, {});
      add_node_block(block);
    }
    give(document_.points.size());
  }

  void add_node_block(const NodeBlock& block) {
    plan_.node_blocks.push_back(block);
    const auto box = new_boxes_.find({block.dim, block.entity});
    if (box == new_boxes_.end()) return;
    for (std::size_t i = 0; i < block.count; ++i) grow(box->second, document_.points[block.first + i]);
  }

  const Document& document_;
  const bool with_boxes_;
  EntityPlan plan_;
  std::map<std::pair<int, std::int64_t>, Belongs> known_;
  std::map<std::tuple<int, std::int64_t, Belongs>, std::int64_t> renamed_;
  std::map<int, std::int64_t> largest_;
  std::map<std::pair<int, std::int64_t>, std::array<double, 6>> new_boxes_;
  int last_dim_ = -1;
  std::int64_t last_wanted_ = 0, last_ = 0;
  Belongs last_to_;
};

}  // namespace

EntityPlan plan_entities(const Document& document, bool with_boxes) {
  return Planner(document, with_boxes).plan();
}

std::vector<Entity> underived_entities(const Document& document) {
  std::map<std::pair<int, std::int64_t>, std::array<double, 6>> boxes;
  std::set<std::tuple<int, std::int64_t, std::int32_t>> of_elements;
  for (const ElementBlock& block : document.blocks) {
    of_elements.insert({block.dim, block.entity, block.groups});
    auto& box = boxes.try_emplace({block.dim, block.entity}, empty_box).first->second;
    for (std::size_t k = 0; k < block.count * block.nodes_each; ++k) {
      const Index node = document.connectivity[block.nodes + k];
      if (node >= 0) grow(box, document.points[node]);
    }
  }
  for (const NodeBlock& block : document.node_blocks)
    if (const auto box = boxes.find({block.dim, block.entity}); box != boxes.end())
      for (std::size_t i = 0; i < block.count; ++i) grow(box->second, document.points[block.first + i]);
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
