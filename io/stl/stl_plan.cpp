// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/stl/stl_plan.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "io/model/block_of.hpp"
#include "io/model/values.hpp"
#include "io/stl/stl.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {
namespace {

using Names = std::map<std::pair<int, std::int64_t>, std::string>;  // by dimension and group

StlGroup group_of(const Document& document, const ElementBlock& block, const Names& names) {
  const auto& groups = document.tag_sets[static_cast<std::size_t>(block.groups)];
  if (groups.empty()) return {};
  const auto name = names.find({block.dim, groups[0]});
  return {name == names.end() ? "" : name->second, groups[0]};
}

bool new_solid(const ElementBlock& last, const ElementBlock& block) {
  return last.groups != block.groups || last.dim != block.dim;
}

std::vector<StlSolid> solids_of(const Document& document) {
  Names names;
  for (const GroupName& name : document.group_names) names.try_emplace({name.dim, name.group}, name.name);
  std::vector<StlSolid> solids;
  const ElementBlock* last = nullptr;
  for (const ElementBlock& block : document.blocks) {
    if (corners_kept(block) < 3 || block.count == 0) continue;
    if (!last || new_solid(*last, block)) solids.push_back({group_of(document, block, names), {}});
    last = &block;
    solids.back().blocks.push_back(&block);
  }
  // A group that no element is in, but that has a name, becomes an empty solid.
  std::set<std::int64_t> used;
  for (const StlSolid& solid : solids) used.insert(solid.group.number);
  for (const GroupName& name : document.group_names)
    if (name.dim == 2 && name.group != 0 && !name.name.empty() && used.insert(name.group).second)
      solids.push_back({{name.name, name.group}, {}});
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

// The number of corners of each element if these are triangles that are written as they are. Those of a facet
// with holes are cut with it.
std::function<int(const ElementBlock&)> corners_of_triangles(const Document& document) {
  return [facets = Facets(document)](const ElementBlock& block) {
    return corners_kept(block) == 3 && !facets.any_in(block.first, block.count) ? 3 : 0;
  };
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
  if (&facet == last_facet_ && element != first_face_) return last_is_cut_;
  last_facet_ = &facet;
  first_face_ = element;
  facets_.cut(facet, {}, document_.points, cut_);
  last_is_cut_ = cut_.fault.empty() && !cut_.triangles.empty();
  if (!last_is_cut_) return false;
  bends_.add(cut_, 0);
  triangles.insert(triangles.end(), cut_.triangles.begin(), cut_.triangles.end());
  return true;
}

namespace {

// Blocks with faces of a facet that comes into the solid of its first face, which is of another group.
std::set<const ElementBlock*> blocks_in_other_solids(const Document& document) {
  std::set<const ElementBlock*> others;
  for (const Facet& facet : document.facets) {
    const ElementBlock& first = block_of(document.blocks, facet.first);
    for (std::size_t e = facet.first; e < facet.first + facet.polygons;) {
      const ElementBlock& block = block_of(document.blocks, e);
      if (block.dim == 2 && block.groups != first.groups) others.insert(&block);
      e = block.first + block.count;
    }
  }
  return others;
}

}  // namespace

StlPlan stl_plan(const Document& document, bool binary) {
  StlPlan plan{.solids = solids_of(document)};
  if (binary && keeps_all_elements(document, corners_of_triangles(document)))
    plan.attributes = attributes_of(document);
  return plan;
}

Holds stl_holds(const Document& document, const StlPlan& plan, bool binary) {
  Holds holds;
  holds.which_nodes = Holds::Nodes::of_elements;
  holds.nodes_by_place = true;
  holds.single = binary;
  holds.nodes_each = corners_of_triangles(document);
  holds.cut_into = [cutter = StlCutter(document)](const ElementBlock& block, std::size_t e,
                                                  std::vector<std::array<Index, 3>>& triangles) mutable {
    return cutter.cut(block, e, triangles);
  };
  holds.title = document.title.empty() ||
                (binary && document.title == stl_title(document.title) && document.title.size() <= 80);
  holds.values = [attributes = plan.attributes](const Values& values, Of) { return &values == attributes; };

  if (binary) return holds;
  holds.groups = Holds::Groups::first;
  if (!document.facets.empty())
    holds.groups_of = [others = blocks_in_other_solids(document)](const ElementBlock& block) {
      return others.count(&block) == 0;
    };
  std::set<std::pair<std::int64_t, std::string>> names;
  for (const StlSolid& solid : plan.solids)
    if (!solid.group.name.empty()) names.insert({solid.group.number, solid.group.name});
  holds.name = [names](const GroupName& name) {
    return name.dim == 2 && names.count({name.group, name.name}) > 0;
  };
  return holds;
}

}  // namespace tetproof::io
