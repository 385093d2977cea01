// SPDX-License-Identifier: GPL-3.0-or-later
// What .msh files hold of a document by themselves.
#include <fmt/format.h>

#include "io/msh.hpp"
#include "io/msh22_limits.hpp"
#include "io/msh_entities.hpp"
#include "io/msh_write.hpp"

namespace tetproof::io {
namespace {

// Partitions belong to partitioned entities in 4.
bool has_partitions_of_entities(const Document& document) {
  for (const ElementBlock& block : document.blocks) {
    if (block.partitions == 0) continue;
    bool found = false;
    for (const Entity& entity : document.entities)
      found = found || (entity.parent_dim >= 0 && entity.dim == block.dim && entity.tag == block.entity &&
                        entity.partitions == block.partitions);
    if (!found) return false;
  }
  return true;
}

void ask_msh4(const Document& document, Holds& holds) {
  holds.node_tags = holds.element_tags = true;
  holds.entities = holds.node_entities = true;
  holds.groups = Holds::Groups::all;
  holds.parameters = holds.ghosts = holds.partition_count = true;
  holds.partitions = has_partitions_of_entities(document);
  const EntityPlan plan = plan_entities(document);
  for (std::size_t b = 0; b < document.blocks.size(); ++b) {
    const ElementBlock& block = document.blocks[b];
    if (block.entity == 0 || plan.block_tags[b] == block.entity) continue;
    if (holds.changed_entities == 0)
      holds.changed_entity = fmt::format("element {} in entity {} comes into entity {}",
                                         document.element_tag(block.first), block.entity, plan.block_tags[b]);
    holds.changed_entities += static_cast<std::int64_t>(block.count);
  }
}

void ask_msh22(const Document& document, bool binary, Holds& holds) {
  const Msh22Limits limits = msh22_limits(document, binary);
  holds.node_tags = !limits.renumber_nodes;
  if (limits.renumber_nodes)
    holds.unknown_number = [nodes = document.points.size()](std::size_t k) {
      return static_cast<std::int64_t>(nodes + k + 1);
    };
  holds.element_tags = !limits.renumber_elements;
  holds.groups = Holds::Groups::first;
  holds.partitions = true;
  holds.node_entities = limits.parametric;
  holds.parameters = true;
  for (const NodeBlock& block : document.node_blocks)
    if (block.parameters_each > 0 && !(limits.parametric && block.dim < 3)) holds.parameters = false;
}

}  // namespace

Holds msh_holds(const Document& document, const std::string& format, bool binary) {
  Holds holds;
  holds.kept_in = "$TetproofSupplement";
  holds.unknown_nodes = holds.element_entities = holds.group_names = true;
  holds.nodes_each = [&document, format, binary](const ElementBlock& block) {
    return msh_holds(document, block, format, binary) ? block.nodes_each : 0;
  };
  format == "msh22" ? ask_msh22(document, binary, holds) : ask_msh4(document, holds);
  const bool numbers = holds.node_tags && holds.element_tags;  // sections speak of them
  holds.section = [format, binary, numbers](const Section& section) {
    return numbers && section.body.ends_with('\n') && keeps_section(section, format, binary);
  };
  return holds;
}

}  // namespace tetproof::io
