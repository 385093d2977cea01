// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tetgen/tetgen_plan_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "io/model/groups_of_values.hpp"
#include "io/model/node_tags.hpp"
#include "io/model/values.hpp"

namespace tetproof::io {
namespace {

bool is_plain(const Values& values, const char* name) {
  return values.name == name && values.at.empty() && values.nodes.empty() && values.labels.empty() &&
         !values.of_view && values.reals.empty() != values.integers.empty();
}

bool has_columns(const Values& values, std::size_t items, bool reals, int components) {
  return values.components >= 1 && (components == 0 || values.components == components) &&
         values.reals.empty() != reals &&
         values.size() == items * static_cast<std::size_t>(values.components);
}

const Values* node_values(const Document& document, const char* name, bool reals, int components) {
  if (document.points.empty()) return nullptr;
  for (const Values& values : document.node_values)
    if (is_plain(values, name) && values.first == 0 &&
        has_columns(values, document.points.size(), reals, components))
      return &values;
  return nullptr;
}

// Whether values may belong to elements of a list.
bool touches(const Values& values, const TetgenList& list) {
  const auto in_list = [&](std::size_t first, std::size_t count) {
    return std::any_of(list.blocks.begin(), list.blocks.end(), [&](const ElementBlock* block) {
      return first < block->first + block->count && block->first < first + count;
    });
  };
  if (values.at.empty()) return in_list(values.first, values.items());
  const auto [least, most] = std::minmax_element(values.at.begin(), values.at.end());
  return *least < 0 ||
         in_list(static_cast<std::size_t>(*least), static_cast<std::size_t>(*most - *least) + 1);
}

// The number that value k is. None: it is no whole number that the reader takes for a tag.
std::optional<std::int64_t> whole_number(const Values& values, std::size_t k) {
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (values.reals.empty()) {
    const std::int64_t integer = values.integers[k];
    return integer >= -most && integer <= most ? std::optional(integer) : std::nullopt;
  }
  const double real = values.reals[k];
  if (!(std::abs(real) <= static_cast<double>(most)) || real != std::trunc(real)) return std::nullopt;
  return static_cast<std::int64_t>(real);
}

// The negative numbers that elements of the list have, where these have no groups; 0 is no number. None: the
// values say something else too of elements of the list.
std::optional<std::vector<std::pair<Index, std::int64_t>>> others_of(const Document& document,
                                                                     const Values& values,
                                                                     const TetgenList& list) {
  if (values.components != 1 || !plain_numbers(values, values.items())) return std::nullopt;
  std::vector<std::pair<Index, std::int64_t>> others;
  for (std::size_t k = 0; k < values.items(); ++k) {
    const Index element = values.at.empty() ? static_cast<Index>(values.first + k) : values.at[k];
    const auto behind = std::upper_bound(
        list.blocks.begin(), list.blocks.end(), static_cast<std::int64_t>(element),
        [](std::int64_t e, const ElementBlock* b) { return e < static_cast<std::int64_t>(b->first); });
    if (behind == list.blocks.begin()) continue;
    const ElementBlock& block = **(behind - 1);
    if (static_cast<std::size_t>(element) >= block.first + block.count) continue;
    const auto number = whole_number(values, k);
    if (!number || *number > 0 ||
        (*number < 0 && !document.tag_sets[static_cast<std::size_t>(block.groups)].empty()))
      return std::nullopt;
    if (*number < 0) others.emplace_back(element, *number);
  }
  std::sort(others.begin(), others.end());
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  if (std::adjacent_find(others.begin(), others.end(), same) != others.end()) return std::nullopt;
  return others;
}

// Whether the others come back as these values: integers of these elements, in ascending order.
bool come_back(const TetgenTags& tags) {
  const Values& values = *tags.of_others;
  return !values.of_view && !values.integers.empty() && values.at.size() == tags.others.size() &&
         std::equal(values.at.begin(), values.at.end(), tags.others.begin(),
                    [](Index at, const auto& other) { return at == other.first; });
}

// Whether each number of some values, except 0, is in one of the columns.
bool are_in_columns(const Values& values, const std::vector<const TetgenTags*>& all) {
  std::size_t written = 0, numbers = 0;
  for (const TetgenTags* tags : all)
    if (tags->of_others == &values) written += tags->others.size();
  for (std::size_t k = 0; k < values.size(); ++k)
    numbers += values.reals.empty() ? values.integers[k] != 0 : values.reals[k] != 0;
  return written > 0 && written == numbers;
}

}  // namespace

bool has_shape(const ElementBlock& block, Shape shape) {
  const ElementType* type = element_type(block.type);
  return type && type->shape == shape;
}

void add_block(TetgenList& list, const ElementBlock& block) {
  if (block.count == 0) return;
  list.blocks.push_back(&block);
  list.count += block.count;
}

bool is_run(const TetgenList& list, std::size_t first) {
  for (const ElementBlock* block : list.blocks) {
    if (block->first != first) return false;
    first += block->count;
  }
  return true;
}

bool counts_up(const Document& document, std::int64_t base, std::initializer_list<const TetgenList*> lists) {
  for (const TetgenList* list : lists)
    for (const ElementBlock* block : list->blocks)
      for (std::size_t e = 0; e < block->count; ++e)
        if (document.element_tag(block->first + e) != base++) return false;
  return true;
}

const Values* values_of(const Document& document, const TetgenList& list, const char* name, bool reals,
                        int components) {
  if (list.count == 0 || !is_run(list, list.blocks[0]->first)) return nullptr;
  for (const Values& values : document.element_values)
    if (is_plain(values, name) && values.first == list.blocks[0]->first &&
        has_columns(values, list.count, reals, components))
      return &values;
  return nullptr;
}

TetgenTags tags_of(const Document& document, const TetgenList& list, const char* name, bool reals,
                   int components) {
  if (const Values* values = values_of(document, list, name, reals, components)) return {.values = values};
  TetgenTags tags;
  for (const ElementBlock* block : list.blocks)
    tags.groups |= !document.tag_sets[static_cast<std::size_t>(block->groups)].empty();
  for (const Values& values : document.element_values) {
    if (!tags.groups || values.name != name || tags.of_others || !touches(values, list)) continue;
    auto others = others_of(document, values, list);
    if (!others || others->empty()) continue;  // such values are kept aside
    tags.others = std::move(*others);
    tags.of_others = &values;
  }
  return tags;
}

bool groups_come_back(const Document& document, const ElementBlock& block, const TetgenTags& tags) {
  const auto& groups = document.tag_sets[static_cast<std::size_t>(block.groups)];
  return groups.empty() ||
         (tags.groups && groups[0] > 0 && groups[0] <= std::numeric_limits<std::int32_t>::max());
}

TetgenPlan plan_of_nodes(const Document& document) {
  TetgenPlan plan;
  plan.renumber_nodes = !document.node_tags.empty() || (document.first_node != 0 && document.first_node != 1);
  plan.base = plan.renumber_nodes ? 1 : document.first_node;
  plan.attributes = node_values(document, "attributes", true, 0);
  plan.markers = node_tags(document, "markers");
  plan.sizes = node_values(document, "sizes", true, 0);
  if (plan.sizes && plan.sizes->components != 1 && plan.sizes->components != 3 && plan.sizes->components != 6)
    plan.sizes = nullptr;
  plan.bounds = !document.area_bounds.empty() || !document.length_bounds.empty();
  return plan;
}

void plan_edge_values(const Document& document, TetgenPlan& plan) {
  plan.edge_tags = tags_of(document, plan.edges, "markers", false, 1);
  plan.edge_tets = values_of(document, plan.edges, "neighbours", false, 1);
  // Values with the same name are told apart by their order, and those of edges are read last.
  const TetgenTags& before = plan.plc ? plan.facet_tags : plan.face_tags;
  for (const Values* values : {before.values, before.of_others})
    if (const Values* mine = plan.edge_tags.values ? plan.edge_tags.values : plan.edge_tags.of_others;
        values && mine && mine < values)
      plan.edge_tags = {};
}

Holds tetgen_holds_of_values(const Document& document, const TetgenPlan& plan) {
  Holds holds;
  holds.element_tags = !plan.renumber_elements;
  holds.node_tags = !plan.renumber_nodes;
  holds.unknown_nodes = true;
  holds.unknown_number = [&document, base = plan.base](std::size_t k) {
    return tetgen_unknown(document, base, k);
  };
  holds.kept_in = "comments";
  holds.bounds = true;
  std::vector<const Values*> held{plan.attributes, plan.markers,   plan.sizes,     plan.volume_bounds,
                                  plan.neighbours, plan.tet_faces, plan.tet_edges, plan.face_tets,
                                  plan.face_edges, plan.edge_tets};
  std::vector<const Values*> in_columns;
  const std::vector<const TetgenTags*> all_tags{&plan.tet_tags, &plan.face_tags, &plan.edge_tags,
                                                &plan.facet_tags};
  for (const TetgenTags* tags : all_tags) {
    // Values that our reader takes for groups do not come back as values.
    if (tags->values && !are_tags(*tags->values)) held.push_back(tags->values);
    if (!tags->of_others) continue;
    if (come_back(*tags))
      held.push_back(tags->of_others);
    else if (are_in_columns(*tags->of_others, all_tags))
      in_columns.push_back(tags->of_others);
  }
  held.erase(std::remove(held.begin(), held.end(), nullptr), held.end());
  holds.values = [held, markers = plan.markers](const Values& values, Of of) {
    return of != Of::element_node && std::find(held.begin(), held.end(), &values) != held.end() &&
           (&values != markers || values.name == "markers");
  };
  // Other tools' words for markers do not come back.
  holds.numbers = [markers = plan.markers, in_columns](const Values& values,
                                                       Of of) -> std::optional<HeldNumbers> {
    if (of == Of::node && &values == markers) return HeldNumbers{.name = "markers"};
    if (std::find(in_columns.begin(), in_columns.end(), &values) == in_columns.end()) return std::nullopt;
    return HeldNumbers{.name = values.name};
  };
  return holds;
}

}  // namespace tetproof::io
