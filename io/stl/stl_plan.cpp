// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/stl/stl_plan.hpp"

#include <algorithm>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "io/model/values.hpp"
#include "io/stl/stl.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {
namespace {

StlGroup group_of(const Document& document, const ElementBlock& block) {
  const auto& groups = document.tag_sets[static_cast<std::size_t>(block.groups)];
  if (groups.empty()) return {};
  for (const GroupName& name : document.group_names)
    if (name.dim == block.dim && name.group == groups[0]) return {name.name, groups[0]};
  return {"", groups[0]};
}

bool new_solid(const ElementBlock& last, const ElementBlock& block) {
  return last.groups != block.groups || last.dim != block.dim;
}

std::vector<StlSolid> solids_of(const Document& document) {
  std::vector<StlSolid> solids;
  const ElementBlock* last = nullptr;
  for (const ElementBlock& block : document.blocks) {
    if (corners_kept(block) < 3 || block.count == 0) continue;
    if (!last || new_solid(*last, block)) solids.push_back({group_of(document, block), {}});
    last = &block;
    solids.back().blocks.push_back(&block);
  }
  // A group that no element is in, but that has a name, becomes an empty solid.
  for (const GroupName& name : document.group_names) {
    const bool used = std::any_of(solids.begin(), solids.end(),
                                  [&](const StlSolid& solid) { return solid.group.number == name.group; });
    if (name.dim == 2 && name.group != 0 && !name.name.empty() && !used)
      solids.push_back({{name.name, name.group}, {}});
  }
  return solids;
}

const Values* attributes_of(const Document& document) {
  for (const Values& values : document.element_values)
    if (values.name == "attribute" && values.components == 1 && values.reals.empty() &&
        of_all(values, document.elements()) &&
        std::all_of(values.integers.begin(), values.integers.end(),
                    [](std::int64_t a) { return a >= 0 && a <= 65535; }) &&
        std::any_of(values.integers.begin(), values.integers.end(), [](std::int64_t a) { return a != 0; }))
      return &values;
  return nullptr;
}

// Whether the elements are triangles that are written as they are. Those of a facet with holes are cut with
// it.
bool triangles_only(const Document& document, const ElementBlock& block) {
  return corners_kept(block) == 3 &&
         std::none_of(document.facets.begin(), document.facets.end(), [&](const Facet& facet) {
           return facet.first < block.first + block.count && block.first < facet.first + facet.polygons;
         });
}

}  // namespace

bool StlCutter::cut(const ElementBlock& block, std::size_t e, std::vector<std::array<Index, 3>>& triangles) {
  const auto corners = static_cast<std::size_t>(corners_kept(block));
  const Index* nodes =
      document_.connectivity.data() + block.nodes + e * static_cast<std::size_t>(block.nodes_each);
  if (corners < 3 || !nodes_exist(nodes, block.nodes_each)) return false;
  if (!document_.facets.empty())
    if (const Facet* facet = facets_.of(block.first + e))
      return cut_facet(*facet, block.first + e, triangles);
  cut_polygon({nodes, corners}, document_.points, cut_);
  if (!cut_.fault.empty()) return false;
  // A polygon with sides that it runs back and forth outside of itself would come back as another one.
  if (cut_.triangles.size() != corners - 2) return false;
  bends_.add(cut_, corners);
  triangles.insert(triangles.end(), cut_.triangles.begin(), cut_.triangles.end());
  return true;
}

bool StlCutter::cut_facet(const Facet& facet, std::size_t element,
                          std::vector<std::array<Index, 3>>& triangles) {
  facets_.cut(facet, {}, document_.points, cut_);
  if (!cut_.fault.empty() || cut_.triangles.empty()) return false;
  for (const ElementBlock& block : document_.blocks) {
    const std::size_t first = std::max(block.first, facet.first);
    if (corners_kept(block) < 3 || first >= std::min(block.first + block.count, facet.first + facet.polygons))
      continue;
    if (first == element) {
      bends_.add(cut_, 0);
      triangles.insert(triangles.end(), cut_.triangles.begin(), cut_.triangles.end());
    }
    break;
  }
  return true;
}

StlPlan stl_plan(const Document& document) {
  return {solids_of(document), attributes_of(document)};
}

Holds stl_holds(const Document& document, const StlPlan& plan, bool binary) {
  Holds holds;
  holds.which_nodes = Holds::Nodes::of_elements;
  holds.nodes_by_place = true;
  holds.single = binary;
  holds.nodes_each = [&document](const ElementBlock& block) {
    return triangles_only(document, block) ? 3 : 0;
  };
  holds.cut_into = [cutter = StlCutter(document)](const ElementBlock& block, std::size_t e,
                                                  std::vector<std::array<Index, 3>>& triangles) mutable {
    return cutter.cut(block, e, triangles);
  };
  holds.title = document.title.empty() ||
                (binary && document.title == stl_title(document.title) && document.title.size() <= 80);
  const bool all = keeps_all_elements(document, holds.nodes_each);
  const Values* attributes = binary && all ? plan.attributes : nullptr;
  holds.values = [attributes](const Values& values, Of) { return &values == attributes; };

  if (binary) return holds;
  holds.groups = Holds::Groups::first;
  std::set<std::pair<std::int64_t, std::string>> names;
  for (const StlSolid& solid : plan.solids)
    if (!solid.group.name.empty()) names.insert({solid.group.number, solid.group.name});
  holds.name = [names](const GroupName& name) {
    return name.dim == 2 && names.count({name.group, name.name}) > 0;
  };
  return holds;
}

}  // namespace tetproof::io
