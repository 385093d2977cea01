// SPDX-License-Identifier: GPL-3.0-or-later
// Plans which elements of a document become polygons and edges of a .poly or .smesh.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "io/model/element_types.hpp"
#include "io/tetgen/tetgen_plan.hpp"
#include "io/tetgen/tetgen_plan_parts.hpp"

namespace tetproof::io {
namespace {

enum class PlcPart { facets, edges, none };

bool says_boundary(const Document& document) {
  return std::any_of(document.blocks.begin(), document.blocks.end(),
                     [](const ElementBlock& block) { return block.of_boundary && block.count > 0; });
}

// Where the elements of a block go. `said`: the document says which elements are of the boundary.
PlcPart part_of(const ElementBlock& block, bool said) {
  const ElementType* type = element_type(block.type);
  const bool has_corners = type ? type->dim <= 2 && type->shape != Shape::other : block.type == polygon;
  if (!has_corners || block.nodes_each < 1) return PlcPart::none;
  if (said ? block.of_boundary : !type || type->dim == 2) return PlcPart::facets;
  return !block.of_boundary && has_shape(block, Shape::line) ? PlcPart::edges : PlcPart::none;
}

// The number in the column of tags behind each polygon.
std::vector<std::int64_t> numbers_of(const Document& document, const TetgenList& list,
                                     const TetgenTags& tags) {
  if (tags.values) return tags.values->integers;
  std::vector<std::int64_t> numbers;
  if (!tags.groups) return numbers;
  for (const ElementBlock* block : list.blocks)
    for (std::size_t e = block->first; e < block->first + block->count; ++e)
      numbers.push_back(tags.group_of(document, *block, e));
  return numbers;
}

}  // namespace

TetgenPlan tetgen_plc_plan(const Document& document) {
  TetgenPlan plan = plan_of_nodes(document);
  plan.plc = true;
  const bool said = says_boundary(document);
  for (const ElementBlock& block : document.blocks)
    if (const PlcPart part = part_of(block, said); part != PlcPart::none)
      add_block(part == PlcPart::facets ? plan.polygons : plan.edges, block);
  plan.edges.nodes_each = 2;
  plan.renumber_elements = !counts_up(document, plan.base, {&plan.polygons, &plan.edges});
  plan.facet_tags = tags_of(document, plan.polygons, "markers", false, 1);
  plan_edge_values(document, plan);

  const std::vector<std::int64_t> numbers = document.facets.empty()
                                                ? std::vector<std::int64_t>{}
                                                : numbers_of(document, plan.polygons, plan.facet_tags);
  const bool run = plan.polygons.count > 0 && is_run(plan.polygons, plan.polygons.blocks[0]->first);
  std::size_t next = run ? plan.polygons.blocks[0]->first : 0;
  const std::size_t end = run ? next + plan.polygons.count : 0;
  for (std::size_t f = 0; f < document.facets.size(); ++f) {
    const Facet& facet = document.facets[f];
    if (facet.first < next || facet.first >= end || facet.polygons < 1 ||
        facet.polygons > end - facet.first || (facet.polygons == 1 && facet.holes.empty())) {
      plan.facets_as_said = false;
      continue;
    }
    plan.facets.push_back(f);
    next = facet.first + facet.polygons;
    if (numbers.empty()) continue;
    const auto its = std::span(numbers).subspan(facet.first - plan.polygons.blocks[0]->first, facet.polygons);
    if (std::any_of(its.begin(), its.end(), [&](std::int64_t number) { return number != its[0]; }))
      plan.facet_tags = {};  // a facet has one marker
  }
  return plan;
}

Holds tetgen_plc_holds(const Document& document, const TetgenPlan& plan, bool smesh) {
  Holds holds = tetgen_holds_of_values(document, plan);
  holds.facets = plan.facets_as_said && !smesh;
  holds.holes = holds.regions = holds.boundary = true;
  const bool said = says_boundary(document);
  holds.makes_boundary = !said;
  holds.nodes_each = [said](const ElementBlock& block) {
    const PlcPart part = part_of(block, said);
    const ElementType* type = element_type(block.type);
    return part == PlcPart::none ? 0 : type ? type->corners : block.nodes_each;
  };
  holds.groups = Holds::Groups::first;
  holds.groups_of = [&document, said, edge_tags = plan.edge_tags,
                     facet_tags = plan.facet_tags](const ElementBlock& block) {
    return groups_come_back(document, block, part_of(block, said) == PlcPart::edges ? edge_tags : facet_tags);
  };
  holds.kind = [said](const ElementBlock& block) { return part_of(block, said) == PlcPart::edges ? 1 : 0; };
  return holds;
}

}  // namespace tetproof::io
