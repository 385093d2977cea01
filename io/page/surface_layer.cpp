// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/page/surface_layer.hpp"

#include <fmt/core.h>

#include "io/bytes/words.hpp"
#include "io/page/reduced.hpp"

namespace tetproof::io {

SurfaceLayer surface_layer(Scene& scene, const TriangleSurface& surface) {
  const ReducedTriangles fewer = reduced(surface.vertices, surface.triangles, most_surface_triangles);
  SurfaceLayer made{.layer = {.id = "surface", .name = "surface", .colour = "#7a8f3c"}, .left_out = {}};
  if (fewer.cell > 0)
    made.left_out =
        fmt::format("The surface of {} is drawn by {}: points within {:.3g} of each other may be joined.",
                    counted(surface.triangles.size(), "triangles"), fewer.triangles.size(), fewer.cell);
  std::vector<Index> place(surface.vertices.size(), -1);
  for (std::array<Index, 3> t : fewer.triangles) {
    for (Index& v : t) {
      Index& here = place[static_cast<std::size_t>(v)];
      if (here < 0) {
        here = static_cast<Index>(scene.points.size());
        scene.points.push_back(surface.vertices[static_cast<std::size_t>(v)]);
        scene.point_numbers.push_back(-1);
      }
      v = here;
    }
    made.layer.triangles.push_back(t);
  }
  return made;
}

}  // namespace tetproof::io
