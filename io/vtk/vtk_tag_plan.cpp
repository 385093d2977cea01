// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk/vtk_tag_plan.hpp"

#include <algorithm>

#include "io/model/tag_words.hpp"
#include "io/model/values.hpp"
#include "io/surface/surface_document.hpp"
#include "io/vtk/vtk_cells.hpp"
#include "io/vtk/vtk_tags.hpp"

namespace tetproof::io {
namespace {

const std::vector<std::int64_t>& groups_of(const Document& document, const ElementBlock& block) {
  return document.tag_sets[static_cast<std::size_t>(block.groups)];
}

// The groups of an element; null: there is no such element.
const std::vector<std::int64_t>* groups_at(const Document& document, Index element) {
  const auto block = std::upper_bound(
      document.blocks.begin(), document.blocks.end(), element, [](Index e, const ElementBlock& one) {
        return static_cast<std::int64_t>(e) < static_cast<std::int64_t>(one.first);
      });
  if (element < 0 || block == document.blocks.begin() ||
      static_cast<std::size_t>(element) >= document.elements())
    return nullptr;
  return &groups_of(document, *std::prev(block));
}

}  // namespace

bool is_of_vtk(const Document& document) {
  return document.format == "vtk" || document.format == "vtu";
}

bool is_written_in_vtk(const Document& document, const ElementBlock& block) {
  if (vtk_cell(block).nodes == 0) return false;
  for (std::size_t e = 0; e < block.count; ++e)
    if (nodes_exist(
            document.connectivity.data() + block.nodes + e * static_cast<std::size_t>(block.nodes_each),
            block.nodes_each))
      return true;
  return false;
}

bool has_vtk_entities(const Document& document) {
  return std::any_of(document.blocks.begin(), document.blocks.end(),
                     [&, of_vtk = is_of_vtk(document)](const ElementBlock& block) {
                       return block.entity != 0 && (block.entity != 1 || of_vtk) &&
                              is_written_in_vtk(document, block);
                     });
}

std::vector<std::string> vtk_names_of_groups(const Document& document) {
  std::size_t most = 0;
  bool common = true;
  for (const ElementBlock& block : document.blocks) {
    const auto& groups = groups_of(document, block);
    if (groups.empty() || !is_written_in_vtk(document, block)) continue;
    most = std::max(most, groups.size());
    common &= std::all_of(groups.begin(), groups.end(), is_common_group);
  }
  std::vector<std::string> names(most);
  for (std::size_t k = 1; k < names.size(); ++k) names[k] = vtk_group_array(k + 1);
  if (names.empty()) return names;
  names[0] = !document.group_word.empty() ? document.group_word
             : document.format == "medit" ? std::string(medit_group_word)
                                          : std::string(own_group_word);
  if (!common && !has_any_group(names[0])) names[0] = own_group_word;
  return names;
}

const Values* negative_vtk_groups(const Document& document, const std::vector<std::string>& groups) {
  if (groups.empty() || has_any_group(groups[0])) return nullptr;
  for (const Values& values : document.element_values) {
    if (values.name != groups[0] || values.at.empty() || values.components != 1 || !values.labels.empty() ||
        values.integers.size() != values.at.size() || !values.nodes.empty() || has_step(values) ||
        !values.roles.empty())
      continue;
    bool fits = true;
    for (std::size_t k = 0; fits && k < values.at.size(); ++k) {
      const auto* set = groups_at(document, values.at[k]);
      fits = set && set->empty() && is_common_group(-values.integers[k]) &&
             (k == 0 || values.at[k - 1] < values.at[k]);
    }
    if (fits) return &values;
  }
  return nullptr;
}

VtkNodeName vtk_node_name(const Document& document, const Values& values) {
  const auto others = [&](std::string_view name) {
    return std::any_of(document.node_values.begin(), document.node_values.end(),
                       [&](const Values& other) { return &other != &values && other.name == name; });
  };
  const bool numbers = values.components == 1 && values.labels.empty();
  if (values.name == node_references && numbers && !others(node_reference_word) && !others(node_references))
    return {std::string(node_reference_word), values.name};
  if (values.name == node_reference_word && values.components == 1 &&
      !are_texts(values, document.points.size()) && !others(node_references) && !others(node_reference_word))
    return {values.name, std::string(node_references)};
  return {values.name, values.name};
}

bool is_taken_for_tags(const Values& values, const std::string& name, const VtkPlan& plan) {
  if (values.components != 1 || !may_be_vtk_tag_name(name) ||
      !may_be_tags(name, values.integers, values.reals))
    return false;
  const std::string groups = plan.groups.empty() ? "" : plan.groups[0];
  if (!groups.empty() && name.starts_with("group ") &&
      name.find_first_not_of("0123456789", 6) == std::string::npos)
    return true;
  bool has_entities = false, has_groups = false;
  for (const TagWord& word : tag_words) {
    if (word.word == name) return word.tag == Tag::entity ? !has_entities : !has_groups;
    has_entities |= word.word == plan.entities;
    has_groups |= word.word == groups;
  }
  return false;
}

}  // namespace tetproof::io
