// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>
#include <utility>

#include "io/loss/loss_finder.hpp"
#include "io/model/entities.hpp"

namespace tetproof::io {
namespace {

class EntityLosses : LossFinder {
 public:
  using LossFinder::LossFinder;

  void find() {
    entities_of_elements();
    entities_of_nodes();
    entities();
    groups();
    partitions();
    parameters();
  }

 private:
  // An entity that is only a number, 0 (none) or 1, is not a loss.
  void entities_of_elements() {
    if (holds_.element_entities) {
      add("numbers of entities", static_cast<std::size_t>(holds_.changed_entities), holds_.changed_entity);
      return;
    }
    each_written([&](const ElementBlock& block, std::size_t count, const std::string& name) {
      if (block.entity != 0 && block.entity != 1)
        add("entities of elements", count, fmt::format("{} in entity {}", name, block.entity));
    });
  }

  void entities_of_nodes() {
    const auto& blocks = document_.node_blocks;
    if (holds_.node_entities || blocks.empty() ||
        (blocks.size() == 1 && blocks[0].count == document_.points.size()))
      return;
    const NodeBlock& block = blocks[0];
    add("entities of nodes", document_.points.size(),
        fmt::format("node {} on entity {} of dimension {}", document_.node_tag(block.first), block.entity,
                    block.dim));
  }

  void entities() {
    if (holds_.entities) return;
    std::set<std::pair<int, std::int64_t>> underived;
    for (const Entity& entity : underived_entities(document_)) underived.insert({entity.dim, entity.tag});
    for (const Entity& entity : document_.entities) {
      const bool told_by_elements = !underived.count({entity.dim, entity.tag});
      if (told_by_elements && (holds_.element_entities || entity.tag == 0 || entity.tag == 1)) continue;
      add("entities with their boxes and boundaries", 1,
          fmt::format("{} of dimension {}", entity.tag, entity.dim));
    }
  }

  void groups() {
    each_written([&](const ElementBlock& block, std::size_t count, const std::string& name) {
      const auto& tags = document_.tag_sets[static_cast<std::size_t>(block.groups)];
      const std::string first = fmt::format("{} in groups {}", name, fmt::join(tags, " "));
      const bool held =
          holds_.groups_of ? holds_.groups_of(block) : holds_.groups != Holds::Groups::none || tags.empty();
      if (!held)
        add("physical groups of elements", count, first);
      else if (holds_.groups == Holds::Groups::first && tags.size() > 1)
        add("physical groups beyond an element's first", count, first);
    });
    for (const GroupName& name : document_.group_names)
      if (!holds_.name(name)) add("names of physical groups", 1, name.name);
  }

  void partitions() {
    std::int64_t largest = 0;
    each_written([&](const ElementBlock& block, std::size_t count, const std::string& name) {
      if (block.partitions == 0) return;
      const auto& tags = document_.tag_sets[static_cast<std::size_t>(block.partitions)];
      if (!holds_.partitions)
        add("partitions of elements", count, fmt::format("{} in partition {}", name, fmt::join(tags, " ")));
      for (const std::int64_t tag : tags) largest = std::max(largest, tag < 0 ? -tag : tag);
    });
    if (!holds_.partition_count && document_.partitions != 0 &&
        document_.partitions != (holds_.partitions ? largest : 0))
      add("number of partitions", 1, fmt::format("{}", document_.partitions));
    if (!holds_.ghost_entities && !document_.ghosts.empty())
      add("entities of ghost elements", document_.ghosts.size(),
          fmt::format("entity {} of partition {}", document_.ghosts[0].tag, document_.ghosts[0].partition));
    if (!holds_.ghosts && !document_.ghost_elements.empty()) {
      const GhostElement& ghost = document_.ghost_elements[0];
      add("ghost elements", document_.ghost_elements.size(),
          ghost.element >= 0
              ? fmt::format("element {} of partition {}",
                            document_.element_tag(static_cast<std::size_t>(ghost.element)), ghost.partition)
              : fmt::format("of partition {}", ghost.partition));
    }
  }

  void parameters() {
    if (!holds_.parameters)
      for (const NodeBlock& block : document_.node_blocks)
        if (block.parameters_each > 0)
          add("nodes with parametric coordinates", block.count,
              fmt::format("node {}", document_.node_tag(block.first)));
    if (!holds_.periodic && !document_.periodic.empty())
      add("periodic links", document_.periodic.size(),
          fmt::format("entity {} of dimension {} to {}", document_.periodic[0].entity,
                      document_.periodic[0].dim, document_.periodic[0].master));
  }
};

}  // namespace

void find_losses_of_entities(const Document& document, const Holds& holds, const WrittenPart& written,
                             std::vector<Loss>& losses) {
  EntityLosses(document, holds, written, losses).find();
}

}  // namespace tetproof::io
