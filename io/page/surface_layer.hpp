// SPDX-License-Identifier: GPL-3.0-or-later
// A surface as a layer of a scene, with as many triangles as a page bears.
#pragma once

#include <string>

#include "io/page/scene.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::io {

inline constexpr std::size_t most_surface_triangles = 30'000;

struct SurfaceLayer {
  SceneLayer layer;      ///< opaque; its points are in the scene, with the numbers -1
  std::string left_out;  ///< a sentence, if it is drawn by fewer triangles; else empty
};

/// Adds the surface's points to the scene, and makes the layer. All vertices that triangles name must be
/// finite.
SurfaceLayer surface_layer(Scene& scene, const TriangleSurface& surface);

}  // namespace tetproof::io
