// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model/document_positions.hpp"

namespace tetproof::io {
namespace {

// `items`: the number of nodes or elements in the document.
bool fits(const Document& d, const Values& v, std::size_t items, bool of_nodes) {
  if (v.components < 0 || (!v.reals.empty() && !v.integers.empty())) return false;
  for (const Index i : v.at)
    if (i >= 0 ? static_cast<std::size_t>(i) >= items
               : static_cast<std::size_t>(-1 - static_cast<std::int64_t>(i)) >= d.unknown.size())
      return false;
  const std::size_t here = v.items();
  if (v.at.empty() ? v.first > items || here > items - v.first : v.at.size() != here) return false;
  if (of_nodes != !v.nodes.empty() && here > 0) return false;
  std::size_t each = 0;
  for (const std::int32_t nodes : v.nodes) {
    if (nodes < 0) return false;
    each += static_cast<std::size_t>(nodes);
  }
  return v.size() == (of_nodes ? each : here) * static_cast<std::size_t>(v.components);
}

// Whether the faces of polyhedra are whole, and name only nodes that the elements have.
bool are_faces(const ElementBlock& block) {
  for (std::size_t at = 0; at < block.faces.size();) {
    const std::int32_t corners = block.faces[at++];
    if (corners < 0 || static_cast<std::size_t>(corners) > block.faces.size() - at) return false;
    for (const std::size_t end = at + static_cast<std::size_t>(corners); at < end; ++at)
      if (block.faces[at] < 0 || block.faces[at] >= block.nodes_each) return false;
  }
  return true;
}

}  // namespace

const char* misplaced(const Document& d) {
  const char* wrong = nullptr;
  const auto expect = [&](bool good, const char* what) {
    if (!good && !wrong) wrong = what;
  };
  const auto is_set = [&](std::int32_t set) {
    return set >= 0 && static_cast<std::size_t>(set) < d.tag_sets.size();
  };
  const auto is_position = [&](Index i, std::size_t size) {
    return i < 0 ? static_cast<std::size_t>(-1 - static_cast<std::int64_t>(i)) < d.unknown.size()
                 : static_cast<std::size_t>(i) < size;
  };
  const auto is_dim = [](int dim) { return dim >= 0 && dim <= 3; };
  expect(!d.tag_sets.empty() && d.tag_sets[0].empty(), "sets of tags");
  for (const ElementBlock& b : d.blocks)
    expect(is_set(b.groups) && is_set(b.partitions) && is_dim(b.dim) && are_faces(b), "blocks of elements");
  for (const Index i : d.connectivity) expect(is_position(i, d.points.size()), "nodes of elements");
  expect(d.node_tags.empty() || d.node_tags.size() == d.points.size(), "numbers of nodes");
  expect(d.element_tags.empty() || d.element_tags.size() == d.elements(), "numbers of elements");
  std::size_t nodes = 0;
  for (const NodeBlock& b : d.node_blocks) {
    expect(is_dim(b.dim) && b.first >= nodes && b.first <= d.points.size() &&
               b.count <= d.points.size() - b.first && b.parameters_each >= 0 && b.parameters_each <= 3,
           "blocks of nodes");
    expect(b.parameters <= d.parameters.size() &&
               b.count * static_cast<std::size_t>(b.parameters_each) <= d.parameters.size() - b.parameters,
           "parametric coordinates");
    nodes = b.first + b.count;
  }
  for (const Entity& e : d.entities)
    expect(
        is_dim(e.dim) && e.parent_dim >= -1 && e.parent_dim <= 3 && is_set(e.groups) && is_set(e.partitions),
        "entities");
  for (const GroupName& n : d.group_names) expect(is_dim(n.dim), "groups");
  for (const GhostElement& g : d.ghost_elements) expect(is_position(g.element, d.elements()), "ghosts");
  for (const PeriodicLink& link : d.periodic)
    for (const auto& pair : link.nodes)
      expect(is_position(pair[0], d.points.size()) && is_position(pair[1], d.points.size()),
             "periodic links");
  for (const Values& v : d.node_values) expect(fits(d, v, d.points.size(), false), "values of nodes");
  for (const Values& v : d.element_values) expect(fits(d, v, d.elements(), false), "values of elements");
  for (const Values& v : d.element_node_values)
    expect(fits(d, v, d.elements(), true), "values of elements' nodes");
  for (const Facet& f : d.facets)
    expect(f.first <= d.elements() && f.polygons <= d.elements() - f.first, "facets");
  for (const LengthBound& b : d.length_bounds)
    expect(is_position(b.nodes[0], d.points.size()) && is_position(b.nodes[1], d.points.size()),
           "bounds of lengths");
  return wrong;
}

}  // namespace tetproof::io
