// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the sections that only .msh 3 has: entities without boxes, and nodes that may name their entity.
#include <fmt/format.h>

#include "io/msh/msh_sections.hpp"

namespace tetproof::io {
namespace {

std::vector<std::int64_t> read_tags(Numbers& in, const char* how_many, const char* one) {
  const std::int64_t count = in.integer(how_many);
  in.check_count(count, how_many, 2);
  std::vector<std::int64_t> tags(static_cast<std::size_t>(count));
  for (std::int64_t& tag : tags) tag = in.integer(one);
  return tags;
}

}  // namespace

void read_entities3(Numbers& in, Document& document, TagSets& sets) {
  std::array<std::int64_t, 4> counts;
  for (std::int64_t& count : counts) {
    count = in.integer("the number of entities");
    in.check_count(count, "the number of entities", 4);
  }
  for (int dim = 0; dim < 4; ++dim) {
    in.check_count(counts[static_cast<std::size_t>(dim)], "the number of entities", 4);
    for (std::int64_t i = 0; i < counts[static_cast<std::size_t>(dim)]; ++i) {
      Entity entity{.dim = dim, .tag = in.integer("the tag of an entity")};
      if (dim > 0)
        entity.boundary = read_tags(in, "the number of bounding entities", "the tag of a bounding entity");
      entity.groups = sets(read_tags(in, "the number of physical groups", "a physical group"));
      document.entities.push_back(std::move(entity));
    }
  }
}

void read_nodes3(Numbers& in, std::int64_t count, Document& document) {
  Tags tags(document.node_tags, document.first_node);
  check_node_count(in, document.points.size() + static_cast<std::size_t>(count));
  document.points.reserve(document.points.size() + static_cast<std::size_t>(count));
  for (std::int64_t i = 0; i < count; ++i) {
    const std::size_t position = document.points.size();
    tags.add(position, in.integer("the tag of a node"));
    const double x = in.real("a coordinate"), y = in.real("a coordinate"), z = in.real("a coordinate");
    document.points.emplace_back(x, y, z);
    const std::int64_t entity = in.integer("the tag of a node's entity, 0 for none");
    if (entity == 0) continue;
    const std::int64_t dim = in.integer("the dimension of a node's entity");
    if (dim < 0 || dim > 3)
      in.fail(fmt::format("expected the dimension of a node's entity, 0 to 3, found {}", dim));
    NodeBlock* block = document.node_blocks.empty() ? nullptr : &document.node_blocks.back();
    if (!block || block->dim != dim || block->entity != entity || block->first + block->count != position)
      block = &document.node_blocks.emplace_back(NodeBlock{.dim = static_cast<int>(dim),
                                                           .entity = entity,
                                                           .first = position,
                                                           .parameters_each = static_cast<int>(dim),
                                                           .parameters = document.parameters.size()});
    ++block->count;
    for (std::int64_t k = 0; k < dim; ++k) document.parameters.push_back(in.real("a parametric coordinate"));
  }
}

}  // namespace tetproof::io
