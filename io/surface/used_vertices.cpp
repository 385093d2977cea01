// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/used_vertices.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace tetproof::io {

std::optional<TriangleSurface> without_unused_vertices(const TriangleSurface& surface) {
  std::vector<Index> number(surface.vertices.size(), -1);
  for (const auto& triangle : surface.triangles)
    for (const Index v : triangle) number[v] = 0;
  if (std::find(number.begin(), number.end(), -1) == number.end()) return std::nullopt;
  TriangleSurface used{
      .triangles = surface.triangles, .parameters = surface.parameters, .evaluate = surface.evaluate};
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<Index>(used.vertices.size());
    used.vertices.push_back(surface.vertices[v]);
  }
  for (auto& triangle : used.triangles)
    for (Index& v : triangle) v = number[v];
  return used;
}

std::optional<TriangleSurface> without_unused_vertices(const TriangleSurface& surface,
                                                       SurfaceNumbering& numbering) {
  std::optional<TriangleSurface> used = without_unused_vertices(surface);
  if (!used) return used;
  std::vector<std::int64_t> numbers(used->vertices.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      numbers[static_cast<std::size_t>(used->triangles[t][k])] = numbering.vertex(surface.triangles[t][k]);
  numbering.vertices = std::move(numbers);
  return used;
}

}  // namespace tetproof::io
