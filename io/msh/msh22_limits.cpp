// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/msh/msh22_limits.hpp"

#include <algorithm>
#include <limits>

#include "io/model/element_types.hpp"
#include "io/msh/msh_entities.hpp"
#include "io/msh/msh_write.hpp"

namespace tetproof::io {

int dimension22(int type) {
  if (const ElementType* known = element_type(type)) return known->dim;
  return type == polygon || type == polygon_border ? 2 : 3;
}

Msh22Limits msh22_limits(const Document& document, bool binary) {
  Msh22Limits limits;
  const std::int64_t most = binary ? largest_int : std::numeric_limits<std::int64_t>::max();
  const auto fits = [&](const std::pair<std::int64_t, std::int64_t>& range) {
    return range.first >= -most - 1 && range.second <= most;
  };
  const auto unknown = range_of(document.unknown.size(), [&](std::size_t k) { return document.unknown[k]; });
  const auto elements = range_of(document.element_tags, document.first_element, 0, document.elements());
  for (const ElementBlock& block : document.blocks)
    limits.copies += block.count * (groups22(document, block).size() - 1);
  // Copies are numbered after all elements, and after those that data names although they do not exist.
  const bool names_elements = !document.element_values.empty() || !document.element_node_values.empty();
  const std::int64_t last = std::max({std::int64_t{0}, elements.second, names_elements ? unknown.second : 0});
  limits.renumber = counts_from_zero(document) || !fits(unknown) || !fits(elements) ||
                    !fits(range_of(document.node_tags, document.first_node, 0, document.points.size())) ||
                    (limits.copies > 0 && static_cast<std::uint64_t>(most - last) < limits.copies);
  if (limits.renumber) {
    limits.first_copy = static_cast<std::int64_t>(document.elements()) + 1;
    limits.first_unknown =
        static_cast<std::int64_t>(std::max(document.points.size(), document.elements() + limits.copies)) + 1;
  } else if (limits.copies > 0) {
    limits.first_copy = last + 1;
  }
  const auto parametric = [](const NodeBlock& block) { return block.parameters_each > 0 && block.dim < 3; };
  const auto complete = [](const NodeBlock& block) {
    return block.dim == 0 || block.dim == 3 || block.parameters_each == block.dim;
  };
  if (!std::any_of(document.node_blocks.begin(), document.node_blocks.end(), parametric)) return limits;
  // The blocks as they are written: nodes of no block join one.
  limits.node_blocks = plan_entities(document).node_blocks;
  limits.parametric = std::all_of(limits.node_blocks.begin(), limits.node_blocks.end(), complete);
  return limits;
}

std::vector<std::int64_t> groups22(const Document& document, const ElementBlock& block) {
  std::vector<std::int64_t> groups;
  for (const std::int64_t group : document.tag_sets[static_cast<std::size_t>(block.groups)])
    if (group != 0 && groups.size() < most_groups22 &&
        std::find(groups.begin(), groups.end(), group) == groups.end())
      groups.push_back(group);
  if (groups.empty()) groups.push_back(0);
  return groups;
}

}  // namespace tetproof::io
