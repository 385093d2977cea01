// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/msh/msh_entities.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "io/model/entities.hpp"

namespace tetproof::io {
namespace {

// Whether a set contains only partitions of an entity. In 2.2 a negative number means a ghost.
bool are_partitions(const Document& document, std::int32_t set) {
  const auto& tags = document.tag_sets[set];
  return std::all_of(tags.begin(), tags.end(), [](std::int64_t tag) { return tag > 0; });
}

class Planner {
 public:
  explicit Planner(const Document& document) : document_(document) {
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
      const std::int32_t partitions = are_partitions(document_, block.partitions) ? block.partitions : 0;
      const std::int64_t tag = tag_for(block.dim, block.entity, {block.groups, partitions});
      plan_.block_tags.push_back(tag);
    }
    cover_nodes();
    std::stable_sort(plan_.entities.begin(), plan_.entities.end(), [](const Entity& a, const Entity& b) {
      return std::pair(a.parent_dim >= 0, a.dim) < std::pair(b.parent_dim >= 0, b.dim);
    });
    plan_.partitions = document_.partitions;
    cover_ghosts();
    for (const GhostEntity& ghost : plan_.ghosts)
      if (document_.partitions == 0) plan_.partitions = std::max(plan_.partitions, ghost.partition);
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

  std::int64_t tag_for(int dim, std::int64_t tag, Belongs to) {
    if (last_ && std::tie(last_dim_, last_wanted_, last_to_) == std::tie(dim, tag, to)) return last_;
    last_dim_ = dim, last_wanted_ = tag, last_to_ = to;
    return last_ = find_tag(dim, tag, to);
  }

  std::int64_t find_tag(int dim, std::int64_t tag, Belongs to) {
    if (const auto renamed = renamed_.find({dim, tag, to}); renamed != renamed_.end()) return renamed->second;
    if (tag != 0) {
      // Elements of a partition get an entity of their own; its parent is the one that they name.
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
    plan_.new_entities.emplace_back(entity.dim, entity.tag);
    plan_.entities.push_back(std::move(entity));
  }

  // Gmsh keeps ghost elements only of partitions that have an entity for them. A document without partitions
  // gets none.
  void cover_ghosts() {
    plan_.ghosts = document_.ghosts;
    const auto is_partitioned = [](const ElementBlock& block) { return block.partitions != 0; };
    if (std::none_of(document_.blocks.begin(), document_.blocks.end(), is_partitioned)) return;
    std::set<std::int64_t> missing;
    for (const GhostElement& ghost : document_.ghost_elements)
      for (const std::int64_t partition : ghost.ghosts)
        if (partition > 0) missing.insert(partition);
    int dim = 0;
    for (const ElementBlock& block : document_.blocks) dim = std::max(dim, block.dim);
    std::int64_t tag = largest_[dim];
    for (const GhostEntity& ghost : document_.ghosts) {
      missing.erase(ghost.partition);
      tag = std::max(tag, ghost.tag);
    }
    for (const std::int64_t partition : missing) plan_.ghosts.push_back({++tag, partition});
  }

  // Nodes without an entity join the entity of the first block of the highest dimension.
  void cover_nodes() {
    int dim = 3;
    std::int64_t tag = 0;
    for (std::size_t b = 0; b < document_.blocks.size(); ++b)
      if (tag == 0 || document_.blocks[b].dim > dim) dim = document_.blocks[b].dim, tag = plan_.block_tags[b];
    std::size_t covered = 0;
    const auto give = [&](std::size_t to) {
      if (to <= covered) return;
      if (tag == 0) tag = tag_for(dim, 1, {});
      plan_.node_blocks.push_back({.dim = dim, .entity = tag, .first = covered, .count = to - covered});
    };
    for (NodeBlock block : document_.node_blocks) {
      give(block.first);
      covered = block.first + block.count;
      if (block.entity == 0 || !known_.count({block.dim, block.entity}))
        block.entity = tag_for(block.dim, block.entity, {});
      plan_.node_blocks.push_back(block);
    }
    give(document_.points.size());
  }

  const Document& document_;
  EntityPlan plan_;
  std::map<std::pair<int, std::int64_t>, Belongs> known_;
  std::map<std::tuple<int, std::int64_t, Belongs>, std::int64_t> renamed_;
  std::map<int, std::int64_t> largest_;
  int last_dim_ = -1;
  std::int64_t last_wanted_ = 0, last_ = 0;
  Belongs last_to_;
};

}  // namespace

EntityPlan plan_entities(const Document& document) {
  return Planner(document).plan();
}

void compute_new_boxes(const Document& document, EntityPlan& plan) {
  std::map<std::pair<int, std::int64_t>, EntityBox> boxes;
  for (const auto& entity : plan.new_entities) boxes[entity] = empty_box;
  const auto box_of = [&](int dim, std::int64_t tag) {
    const auto box = boxes.find({dim, tag});
    return box == boxes.end() ? nullptr : &box->second;
  };
  for (std::size_t b = 0; b < document.blocks.size(); ++b) {
    const ElementBlock& block = document.blocks[b];
    const std::int64_t tag = plan.block_tags[b];
    if (EntityBox* box = box_of(block.dim, tag)) grow(*box, document, block);
    if (block.partitions == 0 || !are_partitions(document, block.partitions) || tag == block.entity) continue;
    if (EntityBox* parent = box_of(block.dim, block.entity)) grow(*parent, document, block);
  }
  for (const NodeBlock& block : plan.node_blocks)
    if (EntityBox* box = box_of(block.dim, block.entity)) grow(*box, document, block);
  for (Entity& entity : plan.entities) {
    const EntityBox* box = box_of(entity.dim, entity.tag);
    if (!box) continue;
    entity.box = (*box)[0] <= (*box)[3] ? *box : EntityBox{};
    if (entity.dim == 0) std::copy_n(entity.box.begin(), 3, entity.box.begin() + 3);
  }
}

}  // namespace tetproof::io
