// SPDX-License-Identifier: GPL-3.0-or-later
// Plans which arrays of VTK's two file formats store which parts of a document, and under which names. The
// writers and the list of what is held share this plan.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/document.hpp"
#include "io/loss/holds.hpp"

namespace tetproof::io {

struct VtkPlan {
  std::string entities;  ///< the name of the cell data that has the tags of entities; empty: there is none
  std::vector<std::string> groups;   ///< the names of the cell data that have the first, second, ... group
  const Values* negative = nullptr;  ///< values that stand in the first of these, for elements without groups
  std::vector<std::string> node_values,
      element_values;  ///< the names of the arrays of each of the document's

  std::vector<std::string> back;  ///< the names with which the reader gives values of nodes back

  /// A column of a table, which is written as field data.
  struct Field {
    const Table* table;
    const Column* column;
    std::string name;
  };
  std::vector<Field> fields;
  std::shared_ptr<const Table> group_names;  ///< as field data, for which a document has no table
};
/// `entities`: the name of the array of entity tags, if there is one.
VtkPlan vtk_plan(const Document& document, const std::string& entities);

/// Whether there is one value for each of `items` nodes or elements, in their order.
bool covers(const Values& values, std::size_t items);

/// Whether values are written as the texts that their labels are. So are those that came from such a file;
/// not those of other formats, since few programs read texts. The texts come back, with numbers of their own.
bool are_texts(const Values& values, std::size_t items);

/// Whether a legacy file gives the values the first of their roles, which makes them an attribute instead of
/// an array in a FIELD. `beside_entities`: behind the array of entities.
bool has_vtk_role(const Values& values, bool beside_entities);

/// What the legacy format holds, and what the XML format holds.
Holds vtk_holds(const Document& document, const VtkPlan& plan);
Holds vtu_holds(const Document& document, const VtkPlan& plan);

/// The most bytes of a title in a legacy file. VTK's limit for the line is 256, its end included.
inline constexpr std::size_t longest_vtk_title = 255;
/// The title that VTK's writer makes up, which says nothing.
inline constexpr std::string_view made_up_vtk_title = "vtk output";

/// Whether the strings of an array can be told apart in XML, where a zero byte ends each of them.
bool are_vtu_strings(std::span<const std::string> texts);

}  // namespace tetproof::io
