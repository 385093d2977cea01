// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/off/off_plan.hpp"
#include "io/model/values.hpp"
#include "io/surface/titles.hpp"

#include <algorithm>

namespace tetproof::io {

OffPlan off_plan(const Document& document) {
  OffPlan plan{.came_from_off = document.format == "off", .face_colors = RowsOf(document.elements())};
  const std::size_t nodes = document.points.size();
  for (const Values& values : document.node_values) {
    const auto take = [&](const Values*& place, const char* name) {
      if (!place && values.name == name) place = &values;
    };
    RowsOf rows(nodes);  // refuses numbers that change when they are read as doubles
    if (!of_all(values, nodes) || !rows.add(values)) continue;
    if (values.components == 3 && values.integers.empty()) take(plan.normal, "normal");
    if (values.components == 2 && values.integers.empty()) take(plan.texture, "texture");
    if (values.components == 3 || values.components == 4) take(plan.color, "color");
  }
  for (const Values& values : document.element_values)
    if (values.name == "color" &&
        (values.components == 1 || values.components == 3 || values.components == 4))
      plan.face_colors.add(values);
  return plan;
}

Holds off_holds(const Document& document, const OffPlan& plan) {
  const auto nodes_each = [thin = plan.came_from_off](const ElementBlock& block) {
    const int corners = corners_kept(block);
    return corners >= 3 || thin ? corners : 0;
  };
  std::vector<const Values*> held{plan.normal, plan.color, plan.texture};
  if (keeps_all_elements(document, nodes_each))
    held.insert(held.end(), plan.face_colors.held().begin(), plan.face_colors.held().end());
  Holds holds;
  holds.title = plan.came_from_off && title_in_lines(document.title);
  holds.nodes_each = nodes_each;
  holds.values = [held](const Values& values, Of) {
    return std::find(held.begin(), held.end(), &values) != held.end();
  };
  return holds;
}

}  // namespace tetproof::io
