// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/surface_numbers.hpp"

#include <numeric>
#include <utility>

namespace tetproof::io {

SurfaceNumbers::SurfaceNumbers(const Document& document, std::size_t points,
                               const std::function<int(const ElementBlock&)>& corners_of)
    : document_(document),
      points_(points),
      counts_faces_(document.format == "stl" || document.format == "off" || document.format == "obj" ||
                    document.format == "ply") {
  bool cut = !document.facets.empty(), others = false;
  for (const ElementBlock& block : document.blocks) {
    cut = cut || (block.count > 0 && corners_of(block) > 3);
    others = others || (block.count > 0 && corners_of(block) == 0);
  }
  numbering_.first_vertex = document.first_node;
  numbering_.first_triangle = counts_faces_ ? document.first_node : document.first_element;
  numbering_.numbers_vertices = document.format != "stl";
  numbering_.word = document.format == "stl" ? "facet" : cut ? "face" : "triangle";
  if (numbering_.numbers_vertices) numbering_.vertices = document.node_tags;
  lists_triangles_ = cut || (!counts_faces_ && (others || !document.element_tags.empty()));
}

void SurfaceNumbers::spell_out() {
  if (!numbering_.vertices.empty()) return;
  numbering_.vertices.resize(points_);
  std::iota(numbering_.vertices.begin(), numbering_.vertices.end(), document_.first_node);
}

void SurfaceNumbers::move(std::size_t to, std::size_t from) {
  if (!numbering_.numbers_vertices || to == from) return;
  spell_out();
  numbering_.vertices[to] = numbering_.vertices[from];
}

void SurfaceNumbers::keep(std::size_t vertices) {
  if (!numbering_.vertices.empty()) numbering_.vertices.resize(vertices);
}

void SurfaceNumbers::weld(std::span<const Index> moved, std::size_t vertices) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < moved.size(); ++i)
    if (static_cast<std::size_t>(moved[i]) == kept) move(kept++, i);
  keep(vertices);
}

void SurfaceNumbers::list(std::size_t element, std::size_t triangles) {
  numbering_.triangles.resize(triangles, counts_faces_
                                             ? document_.first_node + static_cast<std::int64_t>(faces_)
                                             : document_.element_tag(element));
}

void SurfaceNumbers::keep_triangles(std::span<const std::size_t> kept) {
  std::vector<std::int64_t> numbers;
  for (const std::size_t triangle : kept)
    numbers.push_back(numbering_.triangle(static_cast<Index>(triangle)));
  numbering_.triangles = std::move(numbers);
}

SurfaceNumbering SurfaceNumbers::take() && {
  return std::move(numbering_);
}

}  // namespace tetproof::io
