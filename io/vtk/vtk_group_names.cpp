// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk/vtk_group_names.hpp"

#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "io/bytes/xml_text.hpp"
#include "io/vtk/vtk_tag_plan.hpp"

namespace tetproof::io {
namespace {

using Groups = std::set<std::pair<int, std::int64_t>>;  // dimension and number

// Those of all elements, or of those that a file of VTK has.
Groups groups_of_elements(const Document& document, bool written) {
  Groups groups;
  for (const ElementBlock& block : document.blocks)
    if (block.groups != 0 && (written ? is_written_in_vtk(document, block) : block.count > 0))
      for (const std::int64_t group : document.tag_sets[static_cast<std::size_t>(block.groups)])
        groups.emplace(block.dim, group);
  return groups;
}

bool is_name(const Table& table, const Groups& groups) {
  if (table.columns.size() != 1 || table.columns[0].name != table.name) return false;
  const std::vector<std::int64_t>& numbers = table.columns[0].integers;
  return table.columns[0].components == 1 && numbers.size() == 2 && numbers[1] >= 0 && numbers[1] <= 3 &&
         groups.contains({static_cast<int>(numbers[1]), numbers[0]});
}

}  // namespace

std::vector<const GroupName*> names_in_vtk(const Document& document) {
  std::vector<const GroupName*> names;
  if (document.group_names.empty()) return names;
  const Groups groups = groups_of_elements(document, true);
  std::set<std::string> taken;
  Groups named;
  for (const GroupName& name : document.group_names)
    if (!name.name.empty() && is_xml_text(name.name) && groups.contains({name.dim, name.group}) &&
        !taken.contains(name.name) && named.emplace(name.dim, name.group).second) {
      taken.insert(name.name);
      names.push_back(&name);
    }
  return names;
}

Table table_of_names(const std::vector<const GroupName*>& names) {
  Table table{.name = "groups", .rows = 2, .columns = {}};
  for (const GroupName* name : names) {
    const bool is_short = name->group <= std::numeric_limits<std::int32_t>::max() &&
                          name->group >= std::numeric_limits<std::int32_t>::min();
    table.columns.push_back({.name = name->name, .type = is_short ? "Int32" : "Int64"});
    table.columns.back().integers = {name->group, name->dim};
  }
  return table;
}

void take_group_names(Document& document) {
  if (document.tables.empty()) return;
  const Groups groups = groups_of_elements(document, false);
  Groups named;
  std::erase_if(document.tables, [&](const Table& table) {
    if (!is_name(table, groups)) return false;
    const std::vector<std::int64_t>& numbers = table.columns[0].integers;
    if (!named.emplace(static_cast<int>(numbers[1]), numbers[0]).second) return false;
    document.group_names.push_back({static_cast<int>(numbers[1]), numbers[0], table.name});
    return true;
  });
}

std::vector<const Table*> tables_taken_for_names(const Document& document) {
  std::vector<const Table*> taken;
  if (document.tables.empty()) return taken;
  const Groups groups = groups_of_elements(document, true);
  Groups named;
  for (const GroupName* name : names_in_vtk(document)) named.emplace(name->dim, name->group);
  for (const Table& table : document.tables)
    if (is_name(table, groups)) {
      const std::vector<std::int64_t>& numbers = table.columns[0].integers;
      if (named.emplace(static_cast<int>(numbers[1]), numbers[0]).second) taken.push_back(&table);
    }
  return taken;
}

}  // namespace tetproof::io
