// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/document.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "io/bytes/large_pages.hpp"
#include "io/model/element_types.hpp"

namespace tetproof {
namespace {

using io::ElementType;
using io::Shape;

bool has_shape(const ElementBlock& block, Shape shape) {
  const ElementType* type = io::element_type(block.type);
  return type && type->shape == shape;
}

// The nodes that `tet_mesh` keeps: all but those that only stand between corners. Empty: all.
std::vector<bool> kept_nodes(const Document& document) {
  const bool first_order =
      std::all_of(document.blocks.begin(), document.blocks.end(), [](const ElementBlock& block) {
        const ElementType* type = io::element_type(block.type);
        return type && type->nodes == type->corners;
      });
  if (first_order) return {};
  enum : unsigned char { unused, between_corners, corner };
  std::vector<unsigned char> uses(document.points.size(), unused);
  for (const ElementBlock& block : document.blocks) {
    const ElementType* type = io::element_type(block.type);
    const int corners = type ? type->corners : block.nodes_each;
    const Index* node = document.connectivity.data() + block.nodes;
    for (std::size_t e = 0; e < block.count; ++e)
      for (int k = 0; k < block.nodes_each; ++k, ++node)
        if (*node >= 0)
          uses[*node] = std::max<unsigned char>(uses[*node], k < corners ? corner : between_corners);
  }
  std::vector<bool> kept(uses.size());
  for (std::size_t i = 0; i < uses.size(); ++i) kept[i] = uses[i] != between_corners;
  return kept;
}

// The numbers that stand more than once.
std::vector<RepeatedNumber> repeated(const std::vector<std::int64_t>& numbers) {
  std::vector<RepeatedNumber> found;
  if (std::adjacent_find(numbers.begin(), numbers.end(), std::greater_equal<>()) == numbers.end())
    return found;
  std::vector<std::pair<std::int64_t, Index>> sorted;
  sorted.reserve(numbers.size());
  for (const std::int64_t number : numbers) sorted.emplace_back(number, static_cast<Index>(sorted.size()));
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0, k; i < sorted.size(); i = k) {
    for (k = i + 1; k < sorted.size() && sorted[k].first == sorted[i].first;) ++k;
    for (std::size_t j = i; j < k && k - i > 1; ++j)
      found.push_back({sorted[j].second, static_cast<std::int32_t>(j - i + 1)});
  }
  std::sort(found.begin(), found.end(),
            [](const RepeatedNumber& a, const RepeatedNumber& b) { return a.at < b.at; });
  return found;
}

template <std::size_t Corners>
Document document_of_elements(const std::vector<Eigen::Vector3d>& points,
                              const std::vector<std::array<Index, Corners>>& elements, int type, int dim) {
  Document document;
  io::reserve_in_large_pages(document.points, points.size());
  document.points = points;
  if (!points.empty()) document.node_blocks.push_back({.dim = dim, .entity = 1, .count = points.size()});
  if (elements.empty()) return document;
  document.blocks.push_back(
      {.type = type, .dim = dim, .entity = 1, .nodes_each = Corners, .count = elements.size()});
  io::reserve_in_large_pages(document.connectivity, elements.size() * Corners);
  std::map<Index, Index> unknown;
  const Index nodes = static_cast<Index>(points.size());
  for (const auto& element : elements)
    for (Index i : element) {
      if (i < 0 || i >= nodes) {
        const auto [place, is_new] = unknown.try_emplace(i, -1 - static_cast<Index>(document.unknown.size()));
        if (is_new) document.unknown.push_back(std::int64_t{i} + 1);
        i = place->second;
      }
      document.connectivity.push_back(i);
    }
  return document;
}

}  // namespace

TetMesh tet_mesh(const Document& document) {
  TetMesh mesh;
  const std::vector<bool> kept = kept_nodes(document);
  std::vector<Index> position;
  if (kept.empty()) {
    io::reserve_in_large_pages(mesh.points, document.points.size());
    mesh.points = document.points;
  } else {
    position.resize(kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
      position[i] = static_cast<Index>(mesh.points.size());
      if (kept[i]) mesh.points.push_back(document.points[i]);
    }
  }
  std::size_t count = 0;
  for (const ElementBlock& block : document.blocks)
    if (has_shape(block, Shape::tetrahedron)) count += block.count;
  io::reserve_in_large_pages(mesh.tets, count);
  for (const ElementBlock& block : document.blocks) {
    if (!has_shape(block, Shape::tetrahedron)) continue;
    const Index* nodes = document.connectivity.data() + block.nodes;
    for (std::size_t e = 0; e < block.count; ++e, nodes += block.nodes_each) {
      std::array<Index, 4>& corners = mesh.tets.emplace_back();
      for (std::size_t k = 0; k < 4; ++k)
        corners[k] = nodes[k] >= 0 && !position.empty() ? position[nodes[k]] : nodes[k];
    }
  }
  return mesh;
}

Numbering numbering(const Document& document) {
  Numbering names;
  names.unknown = document.unknown;
  const std::vector<bool> kept = kept_nodes(document);
  const bool only_tets = std::all_of(document.blocks.begin(), document.blocks.end(),
                                     [](const ElementBlock& b) { return has_shape(b, Shape::tetrahedron); });
  if (kept.empty() && only_tets && document.node_tags.empty() && document.element_tags.empty() &&
      document.first_node == document.first_element) {
    names.first = document.first_node;
    return names;
  }
  for (std::size_t i = 0; i < document.points.size(); ++i)
    if (kept.empty() || kept[i]) names.points.push_back(document.node_tag(i));
  for (const ElementBlock& block : document.blocks)
    if (has_shape(block, Shape::tetrahedron))
      for (std::size_t e = 0; e < block.count; ++e)
        names.tets.push_back(document.element_tag(block.first + e));
  names.repeated_points = repeated(names.points);
  names.repeated_tets = repeated(names.tets);
  return names;
}

bool has_other_cells(const ElementBlock& block) {
  if (const ElementType* type = io::element_type(block.type))
    return type->dim == 3 && type->shape != Shape::tetrahedron;
  return block.type == io::polyhedron;
}

std::vector<Index> points_of_other_cells(const Document& document) {
  if (std::none_of(document.blocks.begin(), document.blocks.end(), has_other_cells)) return {};
  std::vector<bool> used(document.points.size(), false);
  for (const ElementBlock& block : document.blocks) {
    if (!has_other_cells(block)) continue;
    const Index* node = document.connectivity.data() + block.nodes;
    for (const Index* end = node + block.count * static_cast<std::size_t>(block.nodes_each); node != end;
         ++node)
      if (*node >= 0) used[static_cast<std::size_t>(*node)] = true;
  }
  const std::vector<bool> kept = kept_nodes(document);
  std::vector<Index> points;
  Index position = 0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!kept.empty() && !kept[i]) continue;
    if (used[i]) points.push_back(position);
    ++position;
  }
  return points;
}

TetRegions tet_regions(const Document& document) {
  const auto attributes =
      std::find_if(document.element_values.begin(), document.element_values.end(), [&](const Values& values) {
        return document.format == "tetgen" && values.name == "attributes" && !values.reals.empty();
      });
  enum Kind { physical, entity, attribute };
  const bool of_tetgen = document.format == "tetgen";
  const char* const kinds[] = {document.format == "medit" ? "reference"
                               : of_tetgen                ? "attribute"
                                                          : "physical",
                               "entity", "attribute"};
  std::map<std::pair<Kind, std::int64_t>, std::int64_t> regions;  // numbered as they come up
  TetRegions result;
  std::size_t alike = 0;  // as long as all are in the first region, they are only counted
  const auto add = [&](Kind kind, std::int64_t tag, std::size_t count) {
    if (count == 0) return;
    const std::int64_t region =
        regions.try_emplace({kind, tag}, static_cast<std::int64_t>(regions.size())).first->second;
    if (regions.size() == 1) {
      alike += count;
      return;
    }
    if (result.of_tet.empty()) result.of_tet.assign(alike, 0);
    result.of_tet.insert(result.of_tet.end(), count, region);
  };
  for (const ElementBlock& block : document.blocks) {
    if (!has_shape(block, Shape::tetrahedron)) continue;
    if (attributes == document.element_values.end()) {
      const auto& groups = document.tag_sets[static_cast<std::size_t>(block.groups)];
      if (groups.empty() && !of_tetgen)
        add(entity, block.entity, block.count);
      else
        add(physical, groups.empty() ? 0 : groups[0], block.count);
      continue;
    }
    for (std::size_t e = block.first; e < block.first + block.count; ++e) {
      const double value = attributes->reals[e * static_cast<std::size_t>(attributes->components)];
      if (!(std::abs(value) < 9e15) || value != std::floor(value)) return {};
      add(attribute, static_cast<std::int64_t>(value), 1);
    }
  }
  if (regions.size() < 2) return {};
  std::vector<std::int64_t> place(regions.size());  // of each region among those sorted
  for (const auto& [key, region] : regions) {
    place[static_cast<std::size_t>(region)] = static_cast<std::int64_t>(result.tags.size());
    const auto name = std::find_if(
        document.group_names.begin(), document.group_names.end(),
        [&tag = key.second](const GroupName& named) { return named.dim == 3 && named.group == tag; });
    const bool named = key.first == physical && name != document.group_names.end();
    result.tags.push_back({kinds[key.first], key.second, named ? name->name : ""});
  }
  for (std::int64_t& region : result.of_tet) region = place[static_cast<std::size_t>(region)];
  return result;
}

Document document_of(const TetMesh& mesh) {
  return document_of_elements(mesh.points, mesh.tets, io::tetrahedron4, 3);
}

Document document_of(const TriangleSurface& surface) {
  Document document = document_of_elements(surface.vertices, surface.triangles, io::triangle3, 2);
  if (surface.parameters.empty()) return document;
  Values& texture = document.element_node_values.emplace_back();
  texture.name = "texture";
  texture.components = 2;
  texture.nodes.assign(surface.triangles.size(), 3);
  for (const auto& corners : surface.parameters)
    for (const Eigen::Vector2d& uv : corners) texture.reals.insert(texture.reals.end(), {uv[0], uv[1]});
  return document;
}

}  // namespace tetproof
