// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/obj/obj_plan.hpp"
#include "io/model/values.hpp"
#include "io/surface/titles.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <unordered_set>

namespace tetproof::io {
namespace {

// Whether these are values of corners of faces: of all corners of each face that has any, and of nothing
// else.
bool of_corners(const Document& document, const Values& values) {
  const std::size_t elements = document.elements();
  if (values.nodes.empty() || values.components < 1 || values.reals.empty() || !values.integers.empty() ||
      !values.labels.empty() || values.first != 0 || has_step(values))
    return false;
  if (values.at.empty() ? values.nodes.size() != elements
                        : values.nodes.size() != values.at.size() || values.at.size() >= elements)
    return false;
  std::size_t items = 0, i = 0;
  for (const ElementBlock& block : document.blocks) {
    const bool face = block.dim == 2 && corners_kept(block) == block.nodes_each;
    for (std::size_t e = block.first; e < block.first + block.count; ++e) {
      const bool here = values.at.empty() || (i < values.at.size() && values.at[i] == static_cast<Index>(e));
      if (!here) continue;
      if (!face || values.nodes[i] != block.nodes_each) return false;
      items += static_cast<std::size_t>(values.nodes[i++]);
    }
  }
  return i == values.nodes.size() &&
         values.reals.size() == items * static_cast<std::size_t>(values.components);
}

// Whether each element has one label, and the labels are listed in the order of their first use.
bool of_labels(const Document& document, const Values& values) {
  const std::size_t elements = document.elements();
  if (values.components != 1 || values.labels.empty() || values.integers.size() != elements || elements == 0)
    return false;
  Values numbers;  // the same values without labels: they must be plain numbers
  numbers.integers = values.integers, numbers.first = values.first, numbers.at = values.at;
  numbers.nodes = values.nodes, numbers.of_view = values.of_view, numbers.time = values.time;
  numbers.step = values.step, numbers.partition = values.partition, numbers.reals = values.reals;
  numbers.interpolation = values.interpolation;
  if (!of_all(numbers, elements)) return false;
  std::int64_t next = 0;
  for (const std::int64_t label : values.integers) {
    if (label < 0 || label > next) return false;
    next += label == next;
  }
  std::unordered_set<std::string_view> different(values.labels.begin(), values.labels.end());
  return static_cast<std::size_t>(next) == values.labels.size() && different.size() == values.labels.size();
}

}  // namespace

bool is_libraries(const Table& table) {
  if (table.name != "mtllib" || table.columns.size() != 1) return false;
  const Column& column = table.columns[0];
  return column.name == "file" && column.type == "text" && column.components == 1 && column.reals.empty() &&
         column.integers.empty() && column.lengths.empty() && !column.texts.empty() &&
         column.texts.size() == table.rows &&
         std::none_of(column.texts.begin(), column.texts.end(),
                      [](const std::string& t) { return t.empty(); });
}

ObjPlan::ObjPlan(const Document& document) : behind(document.points.size()), words(document) {
  for (const Values& values : document.node_values) {
    const int each = values.components;
    if (values.integers.empty() &&
        ((values.name == "color" && (each == 3 || each == 4)) || (values.name == "weight" && each == 1)))
      behind.add(values);
  }
  for (const Values& values : document.element_node_values) {
    const int each = values.components;
    const bool is_texture = values.name == "texture" && (each == 2 || each == 3);
    const bool is_normal = values.name == "normal" && each == 3;
    const Values*& place = is_texture ? texture : normal;
    if ((is_texture || is_normal) && !place && of_corners(document, values)) place = &values;
  }
  for (const Values& values : document.element_values) {
    if (values.name == "object" && !object && of_labels(document, values)) object = &values;
    if (values.name == "material" && !material && of_labels(document, values)) material = &values;
    if (values.name == "smoothing" && !smoothing && values.components == 1 && values.reals.empty() &&
        of_all(values, document.elements()) &&
        std::any_of(values.integers.begin(), values.integers.end(), [](std::int64_t n) { return n != 0; }))
      smoothing = &values;
  }
}

Holds obj_holds(const Document& document, const ObjPlan& plan) {
  Holds holds;
  holds.title = title_in_lines(document.title);
  holds.nodes_each = corners_kept;
  const bool libraries_only = document.tables.size() == 1 && is_libraries(document.tables[0]);
  holds.table = [libraries_only](const Table&) { return libraries_only; };
  std::vector<const Values*> held = plan.behind.held();
  if (keeps_all_elements(document, corners_kept))
    held.insert(held.end(), {plan.texture, plan.normal, plan.object, plan.material, plan.smoothing});
  holds.values = [held](const Values& values, Of) {
    return std::find(held.begin(), held.end(), &values) != held.end();
  };
  holds.groups = Holds::Groups::all;
  holds.name = [words = plan.words](const GroupName& name) { return words.holds(name); };
  return holds;
}

}  // namespace tetproof::io
