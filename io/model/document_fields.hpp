// SPDX-License-Identifier: GPL-3.0-or-later
// Lists the fields of each part of a document, for code that writes or reads all of them.
#pragma once

#include <concepts>
#include <type_traits>

#include "io/document.hpp"

namespace tetproof::io {

/// `fields(part, archive)` calls `archive(part.a, part.b, ...)`.
template <class T, class Part>
concept Is = std::same_as<std::remove_const_t<T>, Part>;

/// Without the block's place in the document's arrays: `first` and `nodes` follow from the blocks before it.
void fields(Is<ElementBlock> auto& b, auto&& archive) {
  archive(b.type, b.dim, b.entity, b.groups, b.partitions, b.nodes_each, b.count, b.of_boundary);
}
void fields(Is<NodeBlock> auto& b, auto&& archive) {
  archive(b.dim, b.entity, b.first, b.count, b.parameters_each, b.parameters);
}
void fields(Is<Entity> auto& e, auto&& archive) {
  archive(e.dim, e.groups, e.tag, e.box, e.boundary, e.parent_dim, e.parent, e.partitions);
}
void fields(Is<GhostEntity> auto& g, auto&& archive) {
  archive(g.tag, g.partition);
}
void fields(Is<GroupName> auto& n, auto&& archive) {
  archive(n.dim, n.group, n.name);
}
void fields(Is<GhostElement> auto& g, auto&& archive) {
  archive(g.element, g.partition, g.ghosts);
}
void fields(Is<PeriodicLink> auto& p, auto&& archive) {
  archive(p.dim, p.entity, p.master, p.affine, p.nodes);
}
/// Without the numbers themselves, `reals` and `integers`.
void fields(Is<Values> auto& v, auto&& archive) {
  archive(v.name, v.components, v.labels, v.first, v.at, v.nodes, v.of_view, v.time, v.step, v.partition,
          v.interpolation);
}
void fields(Is<Facet> auto& f, auto&& archive) {
  archive(f.first, f.polygons, f.holes);
}
void fields(Is<Region> auto& r, auto&& archive) {
  archive(r.point, r.attribute, r.max_volume);
}
void fields(Is<AreaBound> auto& b, auto&& archive) {
  archive(b.marker, b.area);
}
void fields(Is<LengthBound> auto& b, auto&& archive) {
  archive(b.nodes, b.length);
}
void fields(Is<Voronoi::Edge> auto& e, auto&& archive) {
  archive(e.points, e.direction);
}
void fields(Is<Voronoi::Face> auto& f, auto&& archive) {
  archive(f.cells, f.edges);
}
void fields(Is<Voronoi> auto& v, auto&& archive) {
  archive(v.points, v.edges, v.faces, v.cells, v.first);
}
void fields(Is<Column> auto& c, auto&& archive) {
  archive(c.name, c.type, c.components, c.reals, c.integers, c.texts, c.lengths);
}
void fields(Is<Table> auto& t, auto&& archive) {
  archive(t.name, t.rows, t.columns);
}
/// Without its body.
void fields(Is<Section> auto& s, auto&& archive) {
  archive(s.name, s.format, s.binary, s.swapped, s.before_nodes);
}

}  // namespace tetproof::io
