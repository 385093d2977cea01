// SPDX-License-Identifier: GPL-3.0-or-later
// A document in VTK's terms, and what is left of it there.
#include "io/vtk/vtk_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "io/model/element_types.hpp"
#include "io/model/second_order.hpp"
#include "io/surface/surface_document.hpp"
#include "io/vtk/vtk_cells.hpp"

namespace tetproof::io {
namespace {

bool covers(const Values& values, std::size_t items) {
  for (std::size_t k = 0; k < values.at.size(); ++k)
    if (values.at[k] != static_cast<Index>(k)) return false;
  return values.nodes.empty() && values.first == 0 && values.components > 0 &&
         values.size() == items * static_cast<std::size_t>(values.components);
}

// What is there of values of nodes or elements, if each has one value at most and what is written any.
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

std::string group_array(std::size_t k) {
  return k == 0 ? "group" : fmt::format("group {}", k + 1);
}

bool all_of_blocks(const Document& document, auto&& predicate) {
  return std::all_of(document.blocks.begin(), document.blocks.end(), predicate);
}

// 0 and 1, the only one or none, go without saying.
bool has_entities(const Document& document) {
  return !all_of_blocks(document,
                        [](const ElementBlock& block) { return block.entity == 0 || block.entity == 1; });
}

std::size_t most_groups(const Document& document) {
  std::size_t most = 0;
  for (const ElementBlock& block : document.blocks)
    most = std::max(most, document.tag_sets[static_cast<std::size_t>(block.groups)].size());
  return most;
}

// Names for arrays, each once; a name of ours is not for others.
class Names {
 public:
  std::string ours(const std::string& name) {
    taken_.insert(name);
    return name;
  }
  std::string operator()(const std::string& wanted, bool of_cells = false) {
    std::string name = wanted.empty() ? "values" : wanted;
    for (int k = 2; (of_cells && is_array_of_tags(name)) || !taken_.insert(name).second; ++k)
      name = fmt::format("{} #{}", wanted.empty() ? "values" : wanted, k);
    return name;
  }

 private:
  std::set<std::string> taken_;
};

// Columns that are written, with the name of their array: a table of one column has its name twice.
void each_field(const Document& document, auto&& each) {
  Names names;
  for (const Table& table : document.tables)
    for (const Column& column : table.columns) {
      if (!column.lengths.empty() || column.components < 1 ||
          column_size(column) % static_cast<std::size_t>(column.components) != 0)
        continue;
      const bool plain = table.columns.size() == 1 && column.name == table.name;
      each(table, column, names(plain ? table.name : table.name + "." + column.name));
    }
}

class Maker {
 public:
  Maker(const Document& document, const std::string& entity_name) : document_(document) {
    cells();
    Names names;
    for (const Values& values : document.node_values)
      add_values(mesh_.point_data, names(values.name), values, nullptr, document.points.size());
    Names cell_names;
    if (has_entities(document))
      of_blocks(cell_names.ours(entity_name), [](const ElementBlock& block) { return block.entity; });
    for (std::size_t k = 0; k < most_groups(document); ++k)
      of_blocks(cell_names.ours(group_array(k)), [&](const ElementBlock& block) {
        const auto& tags = document.tag_sets[static_cast<std::size_t>(block.groups)];
        return k < tags.size() ? tags[k] : 0;
      });
    for (const Values& values : document.element_values)
      add_values(mesh_.cell_data, cell_names(values.name, true), values, &mesh_.elements,
                 document.elements());
    fields();
  }

  VtkMesh mesh() { return std::move(mesh_); }

 private:
  void cells() {
    for (const ElementBlock& block : document_.blocks) {
      const VtkCell cell = vtk_cell(block);
      if (cell.type == 0) continue;
      const auto order = cell.nodes == block.nodes_each
                             ? node_order(block.type, NodeOrder::vtk)
                             : node_order(gmsh_type_of_cell(cell.type, static_cast<std::size_t>(cell.nodes)),
                                          NodeOrder::vtk);
      for (std::size_t e = 0; e < block.count; ++e) {
        const Index* nodes = document_.connectivity.data() + block.nodes + e * block.nodes_each;
        if (!nodes_exist(nodes, block.nodes_each)) continue;
        mesh_.elements.push_back(block.first + e);
        mesh_.types.push_back(static_cast<unsigned char>(cell.type));
        for (int k = 0; k < cell.nodes; ++k)
          mesh_.connectivity.push_back(nodes[order.empty() ? k : order[k]]);
        mesh_.ends.push_back(static_cast<std::int64_t>(mesh_.connectivity.size()));
      }
    }
  }

  // Values of `items` nodes or elements, of which `written` are written; null: all.
  void add_values(std::vector<VtkArray>& to, const std::string& name, const Values& values,
                  const std::vector<std::size_t>* written, std::size_t items) {
    if (values.components < 1 || !values.nodes.empty()) return;
    VtkArray array{.name = name, .components = values.components};
    const bool whole = covers(values, items) && (!written || written->size() == items);
    const auto take = [&](const auto& from, auto& own, auto& span, auto filler) {
      if (whole) {
        span = from;
        return;
      }
      const auto each = static_cast<std::size_t>(values.components);
      auto all = std::remove_cvref_t<decltype(from)>(items * each, filler);
      for (std::size_t k = 0; k < std::min(values.items(), from.size() / each); ++k) {
        const std::int64_t at =
            values.at.empty() ? static_cast<std::int64_t>(values.first + k) : std::int64_t{values.at[k]};
        if (at < 0 || at >= static_cast<std::int64_t>(items)) continue;
        std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(k * each), each,
                    all.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(at) * each));
      }
      if (written && written->size() != items) {
        std::size_t n = 0;
        for (const std::size_t e : *written)
          for (std::size_t c = 0; c < each; ++c) all[n++] = all[e * each + c];
        all.resize(n);
      }
      own.push_back(std::move(all));
      span = own.back();
    };
    if (values.integers.empty())
      take(values.reals, mesh_.own_reals, array.reals, std::numeric_limits<double>::quiet_NaN());
    else
      take(values.integers, mesh_.own_integers, array.integers, std::int64_t{0});
    if (!values.integers.empty()) array.type = "Int64";
    to.push_back(std::move(array));
  }

  template <class Of>
  void of_blocks(const std::string& name, const Of& of) {
    std::vector<std::int64_t> values;
    values.reserve(mesh_.elements.size());
    std::size_t b = 0;
    for (const std::size_t e : mesh_.elements) {
      while (e >= document_.blocks[b].first + document_.blocks[b].count) ++b;
      values.push_back(of(document_.blocks[b]));
    }
    mesh_.own_integers.push_back(std::move(values));
    mesh_.cell_data.push_back({.name = name, .type = "Int64", .integers = mesh_.own_integers.back()});
  }

  void fields() {
    each_field(document_, [&](const Table&, const Column& column, const std::string& name) {
      VtkArray array{.name = name,
                     .components = column.components,
                     .reals = column.reals,
                     .integers = column.integers,
                     .texts = column.texts};
      array.type = fits_its_type(column)      ? column.type
                   : !column.texts.empty()    ? "String"
                   : !column.integers.empty() ? "Int64"
                                              : "Float64";
      mesh_.field_data.push_back(std::move(array));
    });
  }

  const Document& document_;
  VtkMesh mesh_;
};

}  // namespace

VtkMesh vtk_mesh(const Document& document, const std::string& entity_name) {
  return Maker(document, entity_name).mesh();
}

std::string first_place_of(bool (*wanted)(double), const Document& document, const VtkMesh& mesh) {
  for (const Eigen::Vector3d& point : document.points)
    if (std::any_of(point.begin(), point.end(), wanted)) return "a point";
  const std::pair<const char*, const std::vector<VtkArray>*> kinds[] = {
      {"point", &mesh.point_data}, {"cell", &mesh.cell_data}, {"field", &mesh.field_data}};
  for (const auto& [kind, arrays] : kinds)
    for (const VtkArray& array : *arrays)
      if (std::any_of(array.reals.begin(), array.reals.end(), wanted))
        return fmt::format("{} data \"{}\"", kind, array.name);
  return {};
}

Holds vtk_holds_common(const Document& document) {
  Holds holds;
  holds.element_entities = has_entities(document) && all_of_blocks(document, [](const ElementBlock& block) {
                             const ElementType* type = element_type(block.type);
                             return block.dim == (type ? type->dim : 2);
                           });
  holds.groups = Holds::Groups::all;
  holds.groups_of = [&document](const ElementBlock& block) {  // 0 stands for none
    const auto& set = document.tag_sets[static_cast<std::size_t>(block.groups)];
    return std::find(set.begin(), set.end(), 0) == set.end();
  };
  holds.nodes_each = [](const ElementBlock& block) { return vtk_cell(block).nodes; };

  std::map<const Values*, std::string> names;
  Names node_names, cell_names;
  for (const Values& values : document.node_values) names[&values] = node_names(values.name);
  for (const Values& values : document.element_values) names[&values] = cell_names(values.name, true);
  holds.numbers = [names, &document](const Values& values, Of of) -> std::optional<HeldNumbers> {
    if (of == Of::element_node) return std::nullopt;
    std::optional<HeldNumbers> held = held_numbers(document, values, of == Of::node);
    if (held) held->name = names.at(&values);
    return held;
  };
  holds.values = [numbers = holds.numbers](const Values& values, Of of) {
    const auto held = numbers(values, of);
    return held && held->gaps == 0 && held->name == values.name && values.labels.empty() && !has_step(values);
  };
  std::set<const Table*> tables;
  each_field(document, [&](const Table& table, const Column& column, const std::string& name) {
    if (table.columns.size() == 1 && column.name == table.name && name == table.name &&
        fits_its_type(column) &&
        table.rows * static_cast<std::size_t>(column.components) == column_size(column))
      tables.insert(&table);
  });
  holds.table = [tables](const Table& table) { return tables.contains(&table); };
  return holds;
}

}  // namespace tetproof::io
