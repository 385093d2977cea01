// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk/vtk_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "io/bytes/xml_text.hpp"
#include "io/model/element_types.hpp"
#include "io/model/values.hpp"
#include "io/surface/surface_document.hpp"
#include "io/vtk/vtk_cells.hpp"
#include "io/vtk/vtk_group_names.hpp"
#include "io/vtk/vtk_polyhedron.hpp"
#include "io/vtk/vtk_tag_plan.hpp"
#include "io/vtk/vtk_types.hpp"
#include "io/vtk/vtk_words.hpp"

namespace tetproof::io {
namespace {

// What is stored of values of nodes or elements. None, unless each node or element has at most one value, and
// one of those that are written has a value.
std::optional<HeldNumbers> held_numbers(const Document& document, const Values& values, bool of_nodes) {
  const std::size_t items = of_nodes ? document.points.size() : document.elements();
  if (covers(values, items) && (of_nodes || items == 0)) return HeldNumbers{};
  if (!values.nodes.empty() || values.components < 1 ||
      values.size() != values.items() * static_cast<std::size_t>(values.components))
    return std::nullopt;
  std::vector<bool> given(items);
  for (std::size_t k = 0; k < values.items(); ++k) {
    const std::int64_t at =
        values.at.empty() ? static_cast<std::int64_t>(values.first + k) : std::int64_t{values.at[k]};
    if (at < 0 || at >= static_cast<std::int64_t>(items) || given[static_cast<std::size_t>(at)])
      return std::nullopt;
    given[static_cast<std::size_t>(at)] = true;
  }
  HeldNumbers held;
  bool any = false;
  const auto look_at = [&](std::size_t item) {
    if (given[item])
      any = true;
    else if (held.gaps++ == 0)
      held.first_gap = item;
  };
  if (of_nodes)
    for (std::size_t i = 0; i < items; ++i) look_at(i);
  else
    for (const ElementBlock& block : document.blocks) {
      if (vtk_cell(block).nodes == 0) continue;
      const Index* node = document.connectivity.data() + block.nodes;
      for (std::size_t e = 0; e < block.count; ++e, node += block.nodes_each)
        if (nodes_exist(node, block.nodes_each)) look_at(block.first + e);
    }
  return any ? std::optional(held) : std::nullopt;
}

bool all_of_blocks(const Document& document, auto&& predicate) {
  return std::all_of(document.blocks.begin(), document.blocks.end(), predicate);
}

// Whether an array can have all of its roles in the file: each role only once.
bool has_roles_alone(const std::vector<Values>& all, const Values& values) {
  for (const std::string& role : values.roles)
    for (const Values& other : all)
      if (&other != &values && std::find(other.roles.begin(), other.roles.end(), role) != other.roles.end())
        return false;
  return true;
}

// Gives out names for arrays, each once: VTK 9.1 crashes at two cell data of one name.
class Names {
 public:
  std::string operator()(
      const std::string& wanted,
      const std::function<bool(const std::string&)>& avoid = [](const std::string&) { return false; }) {
    const std::string plain = wanted.empty() ? "values" : wanted;
    std::string name = plain;
    while (avoid(name) || taken_.contains(name)) name = fmt::format("{} #{}", plain, ++last_[plain] + 1);
    taken_.insert(name);
    return name;
  }

  void take(const std::string& name) { taken_.insert(name); }

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> last_;  // the last number for a name, less 1
};

// The columns that can be written. If a table has one column, of the same name, that is the array's name,
// too.
void add_fields(const Document& document, Names& names, std::vector<VtkPlan::Field>& fields) {
  for (const Table& table : document.tables)
    for (const Column& column : table.columns) {
      if (!column.lengths.empty() || column.components < 1 ||
          column_size(column) % static_cast<std::size_t>(column.components) != 0)
        continue;
      const bool plain = table.columns.size() == 1 && column.name == table.name;
      fields.push_back({&table, &column, names(plain ? table.name : table.name + "." + column.name)});
    }
}

// What both formats hold.
Holds holds_of_both(const Document& document, const VtkPlan& plan) {
  Holds holds;
  holds.element_entities = !plan.entities.empty() && all_of_blocks(document, [](const ElementBlock& block) {
    return block.dim == dimension_of_type(block.type);
  });
  holds.groups = Holds::Groups::all;
  holds.groups_of = [&document](const ElementBlock& block) {  // 0 stands for none
    const auto& set = document.tag_sets[static_cast<std::size_t>(block.groups)];
    return std::find(set.begin(), set.end(), 0) == set.end();
  };
  holds.name = [names = names_in_vtk(document)](const GroupName& name) {
    return std::find(names.begin(), names.end(), &name) != names.end();
  };
  holds.nodes_each = [](const ElementBlock& block) { return vtk_cell(block).nodes; };

  std::map<const Values*, std::string> names;
  for (std::size_t k = 0; k < plan.node_values.size(); ++k) names[&document.node_values[k]] = plan.back[k];
  for (std::size_t k = 0; k < plan.element_values.size(); ++k)
    names[&document.element_values[k]] = plan.element_values[k];
  holds.numbers = [names, &document](const Values& values, Of of) -> std::optional<HeldNumbers> {
    if (of == Of::element_node) return std::nullopt;
    std::optional<HeldNumbers> held = held_numbers(document, values, of == Of::node);
    if (held) held->name = names.at(&values);
    return held;
  };
  holds.values = [numbers = holds.numbers, &document, negative = plan.negative](const Values& values, Of of) {
    if (&values == negative) return true;
    const auto held = numbers(values, of);
    const std::size_t items = of == Of::node ? document.points.size() : document.elements();
    return held && held->gaps == 0 && held->name == values.name && !has_step(values) &&
           (values.labels.empty() || are_texts(values, items));
  };
  const std::vector<const Table*> taken = tables_taken_for_names(document);
  std::set<const Table*> tables;
  for (const auto& [of, in, name] : plan.fields) {
    const Table& table = *of;
    const Column& column = *in;
    if (table.columns.size() == 1 && column.name == table.name && name == table.name &&
        fits_its_type(column) &&
        table.rows * static_cast<std::size_t>(column.components) == column_size(column) &&
        std::find(taken.begin(), taken.end(), &table) == taken.end())
      tables.insert(&table);
  }
  holds.table = [tables](const Table& table) { return tables.contains(&table); };
  return holds;
}

}  // namespace

bool are_texts(const Values& values, std::size_t items) {
  if (values.labels.empty() || !values.texts || !covers(values, items) || !are_vtu_strings(values.labels))
    return false;
  // The numbers are the reader's, which gives them out as texts come up. Edits leave them in another order.
  return values.reals.empty() &&
         std::all_of(values.integers.begin(), values.integers.end(), [&](std::int64_t label) {
           return label >= 0 && label < static_cast<std::int64_t>(values.labels.size());
         });
}

bool has_vtk_role(const Values& values, bool beside_entities) {
  if (values.roles.empty()) return false;
  const std::string& role = values.roles[0];
  const int n = values.components;
  // VTK takes the first array of scalars, which the entities are.
  if (role == "Scalars") return n >= 1 && n <= 4 && !beside_entities && values.labels.empty();
  if (role == "Vectors" || role == "Normals") return n == 3;
  if (role == "Tensors") return n == 9 || n == 6;
  if (role == "TCoords") return n >= 1 && n <= 3;
  return n == 1 && (role == "GlobalIds" || role == "PedigreeIds" || role == "EdgeFlag");
}

bool covers(const Values& values, std::size_t items) {
  for (std::size_t k = 0; k < values.at.size(); ++k)
    if (values.at[k] != static_cast<Index>(k)) return false;
  return values.nodes.empty() && values.first == 0 && values.components > 0 &&
         values.size() == items * static_cast<std::size_t>(values.components);
}

VtkPlan vtk_plan(const Document& document, const std::string& entities) {
  VtkPlan plan;
  if (has_vtk_entities(document)) plan.entities = entities;
  plan.groups = vtk_names_of_groups(document);
  plan.negative = negative_vtk_groups(document, plan.groups);
  Names of_nodes, of_cells, of_fields;
  if (!plan.entities.empty()) of_cells.take(plan.entities);
  for (const std::string& group : plan.groups) of_cells.take(group);
  for (const Values& values : document.node_values) {
    VtkNodeName name = vtk_node_name(document, values);
    plan.node_values.push_back(of_nodes(name.array));
    // Behind another array of this name it has a number, which comes back.
    plan.back.push_back(plan.node_values.back() == name.array ? std::move(name.back)
                                                              : plan.node_values.back());
  }
  for (const Values& values : document.element_values)
    plan.element_values.push_back(
        &values == plan.negative ? values.name : of_cells(values.name, [&](const std::string& name) {
          return is_taken_for_tags(values, name, plan);
        }));
  if (const auto named = names_in_vtk(document); !named.empty()) {
    plan.group_names = std::make_shared<Table>(table_of_names(named));
    for (const Column& column : plan.group_names->columns)
      plan.fields.push_back({plan.group_names.get(), &column, of_fields(column.name)});
  }
  add_fields(document, of_fields, plan.fields);
  return plan;
}

Holds vtk_holds(const Document& document, const VtkPlan& plan) {
  Holds holds = holds_of_both(document, plan);
  holds.nodes_each = [](const ElementBlock& block) {  // the faces of a polyhedron stand for its nodes
    const VtkCell cell = vtk_cell(block);
    return cell.type == vtk_polyhedron ? nodes_of_faces(block) : cell.nodes;
  };
  holds.title = document.title.size() <= longest_vtk_title && document.title != made_up_vtk_title &&
                document.title.find_first_of(std::string_view("\n\r\0", 3)) == std::string::npos;
  holds.roles = [&document, &plan](const Values& values, Of of) {
    if (values.roles.empty()) return true;
    const auto& all = of == Of::node ? document.node_values : document.element_values;
    return values.roles.size() == 1 && has_roles_alone(all, values) &&
           has_vtk_role(values, of == Of::element && !plan.entities.empty());
  };
  return holds;
}

Holds vtu_holds(const Document& document, const VtkPlan& plan) {
  Holds holds = holds_of_both(document, plan);
  holds.values = [common = holds.values](const Values& values, Of of) {
    return common(values, of) && is_xml_text(values.name);
  };
  holds.numbers = [common = holds.numbers](const Values& values, Of of) {
    return is_xml_text(values.name) ? common(values, of) : std::nullopt;
  };
  holds.roles = [&document](const Values& values, Of of) {
    const auto& all = of == Of::node ? document.node_values : document.element_values;
    return has_roles_alone(all, values) && std::all_of(values.roles.begin(), values.roles.end(), is_vtk_role);
  };
  holds.table = [common = holds.table](const Table& table) {
    return common(table) && is_xml_text(table.name) && are_vtu_strings(table.columns[0].texts);
  };
  return holds;
}

bool are_vtu_strings(std::span<const std::string> texts) {
  return std::none_of(texts.begin(), texts.end(),
                      [](const std::string& text) { return text.find('\0') != std::string::npos; });
}

}  // namespace tetproof::io
