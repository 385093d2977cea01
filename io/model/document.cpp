// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/document.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

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

// How an element uses a node.
enum Use : unsigned char { nothing = 0, wanted_corner = 1, other_corner = 2, between_corners = 4 };

std::vector<unsigned char> uses_of_nodes(const Document& document, Shape wanted) {
  std::vector<unsigned char> uses(document.points.size(), nothing);
  for (const ElementBlock& block : document.blocks) {
    const ElementType* type = io::element_type(block.type);
    const int corners = type ? type->corners : block.nodes_each;
    const Use corner = type && type->shape == wanted ? wanted_corner : other_corner;
    const Index* node = document.connectivity.data() + block.nodes;
    for (std::size_t e = 0; e < block.count; ++e)
      for (int k = 0; k < block.nodes_each; ++k, ++node)
        if (*node >= 0) uses[*node] |= k < corners ? corner : between_corners;
  }
  return uses;
}

// Which nodes a view of `wanted` elements keeps. Empty: all.
std::vector<bool> kept_nodes(const Document& document, Shape wanted) {
  const bool all_wanted =
      std::all_of(document.blocks.begin(), document.blocks.end(), [&](const ElementBlock& block) {
        const ElementType* type = io::element_type(block.type);
        return type && type->nodes == type->corners &&
               (wanted == Shape::tetrahedron || type->shape == wanted);
      });
  if (all_wanted) return {};
  const std::vector<unsigned char> uses = uses_of_nodes(document, wanted);
  std::vector<bool> kept(uses.size());
  for (std::size_t i = 0; i < uses.size(); ++i)
    kept[i] = wanted == Shape::tetrahedron ? uses[i] != between_corners
                                           : uses[i] == nothing || (uses[i] & wanted_corner) != 0;
  return kept;
}

// The wanted elements by their corners, and the points that are kept.
template <std::size_t Corners>
void view(const Document& document, Shape wanted, std::vector<Eigen::Vector3d>& points,
          std::vector<std::array<Index, Corners>>& elements) {
  const std::vector<bool> kept = kept_nodes(document, wanted);
  std::vector<Index> position;
  if (kept.empty()) {
    io::reserve_in_large_pages(points, document.points.size());
    points = document.points;
  } else {
    position.resize(kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
      position[i] = static_cast<Index>(points.size());
      if (kept[i]) points.push_back(document.points[i]);
    }
  }
  std::size_t count = 0;
  for (const ElementBlock& block : document.blocks)
    if (has_shape(block, wanted)) count += block.count;
  io::reserve_in_large_pages(elements, count);
  for (const ElementBlock& block : document.blocks) {
    if (!has_shape(block, wanted)) continue;
    const Index* nodes = document.connectivity.data() + block.nodes;
    for (std::size_t e = 0; e < block.count; ++e, nodes += block.nodes_each) {
      std::array<Index, Corners> corners;
      for (std::size_t k = 0; k < Corners; ++k)
        corners[k] = nodes[k] >= 0 && !position.empty() ? position[nodes[k]] : nodes[k];
      elements.push_back(corners);
    }
  }
}

template <std::size_t Corners>
Document document_of_elements(const std::vector<Eigen::Vector3d>& points,
                              const std::vector<std::array<Index, Corners>>& elements, int type, int dim) {
  Document document;
  document.points = points;
  if (!points.empty()) document.node_blocks.push_back({.dim = dim, .entity = 1, .count = points.size()});
  if (elements.empty()) return document;
  document.blocks.push_back(
      {.type = type, .dim = dim, .entity = 1, .nodes_each = Corners, .count = elements.size()});
  document.connectivity.reserve(elements.size() * Corners);
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
  view(document, Shape::tetrahedron, mesh.points, mesh.tets);
  return mesh;
}

Numbering numbering(const Document& document) {
  Numbering names;
  names.unknown = document.unknown;
  const std::vector<bool> kept = kept_nodes(document, Shape::tetrahedron);
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
  const std::vector<bool> kept = kept_nodes(document, Shape::tetrahedron);
  std::vector<Index> points;
  Index position = 0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!kept.empty() && !kept[i]) continue;
    if (used[i]) points.push_back(position);
    ++position;
  }
  return points;
}

std::vector<std::int64_t> tet_regions(const Document& document) {
  const auto attributes =
      std::find_if(document.element_values.begin(), document.element_values.end(), [&](const Values& values) {
        return document.format == "tetgen" && values.name == "attributes" && !values.reals.empty();
      });
  std::vector<std::int64_t> regions;  // empty as long as all are like the first
  std::int64_t first = 0;
  std::size_t alike = 0;
  const auto add = [&](std::int64_t region, std::size_t count) {
    if (count == 0) return;
    if (regions.empty() && alike == 0) first = region;
    if (regions.empty() && region == first) {
      alike += count;
      return;
    }
    if (regions.empty()) regions.assign(alike, first);
    regions.insert(regions.end(), count, region);
  };
  for (const ElementBlock& block : document.blocks) {
    if (!has_shape(block, Shape::tetrahedron)) continue;
    if (attributes == document.element_values.end()) {
      const auto& groups = document.tag_sets[static_cast<std::size_t>(block.groups)];
      add(groups.empty() ? block.entity : groups[0], block.count);
      continue;
    }
    for (std::size_t e = block.first; e < block.first + block.count; ++e) {
      const double attribute = attributes->reals[e * static_cast<std::size_t>(attributes->components)];
      if (!(std::abs(attribute) < 9e15) || attribute != std::floor(attribute)) return {};
      add(static_cast<std::int64_t>(attribute), 1);
    }
  }
  return regions;
}

TriangleSurface surface_of(const Document& document) {
  TriangleSurface surface;
  view(document, Shape::triangle, surface.vertices, surface.triangles);
  return surface;
}

Document document_of(const TetMesh& mesh) {
  return document_of_elements(mesh.points, mesh.tets, io::tetrahedron4, 3);
}

Document document_of(const TriangleSurface& surface) {
  return document_of_elements(surface.vertices, surface.triangles, io::triangle3, 2);
}

}  // namespace tetproof
