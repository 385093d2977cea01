// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/document_surface.hpp"

#include <fmt/core.h>

#include "io/error.hpp"
#include "io/model/element_types.hpp"
#include "io/model/weld.hpp"

namespace tetproof::io {

TriangleSurface welded_surface(const Document& document) {
  std::size_t triangles = 0;
  for (const ElementBlock& block : document.blocks) {
    const ElementType* type = element_type(block.type);
    if ((type ? type->dim : block.dim) != 2 || block.count == 0) continue;
    const auto fail = [&](std::size_t element, const std::string& message) {
      throw InputError(fmt::format("{}: element {} {}", document.path,
                                   document.element_tag(block.first + element), message));
    };
    if (!type || type->shape != Shape::triangle) fail(0, "is no triangle; cut it into triangles");
    for (std::size_t e = 0; e < block.count; ++e)
      for (int k = 0; k < 3; ++k) {
        const Index node = document.connectivity[block.nodes + e * block.nodes_each + k];
        if (node < 0) fail(e, fmt::format("names node {}, which does not exist", document.named(node)));
      }
    triangles += block.count;
  }
  if (triangles == 0)
    throw InputError(fmt::format("{}: expected a surface, found no triangles", document.path));
  TriangleSurface surface = surface_of(document);
  const std::vector<Index> moved = weld(surface.vertices);
  for (auto& triangle : surface.triangles)
    for (Index& corner : triangle) corner = moved[corner];
  return surface;
}

}  // namespace tetproof::io
