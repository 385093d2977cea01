// SPDX-License-Identifier: GPL-3.0-or-later
// Names for the parts of a surface, as its file has them. Internal.
#pragma once

#include <fmt/core.h>

#include <string>

#include "io/triangle_surface.hpp"

namespace tetproof::verify {

/// "(0, 0.5, 1)", exactly.
inline std::string place_name(const Eigen::Vector3d& p) {
  return fmt::format("({}, {}, {})", p.x(), p.y(), p.z());
}

/// "triangle 7", "facet 7", "face 7".
inline std::string triangle_name(const SurfaceNumbering& numbering, Index triangle) {
  return fmt::format("{} {}", numbering.word, numbering.triangle(triangle));
}

/// "triangle 7 (1 2 3) at (0, 0, 1)": the numbers of its vertices, if the file has some, and the first one's
/// coordinates.
inline std::string triangle_place(const TriangleSurface& surface, const SurfaceNumbering& numbering,
                                  Index triangle) {
  const auto& [a, b, c] = surface.triangles[static_cast<std::size_t>(triangle)];
  const std::string vertices =
      numbering.numbers_vertices
          ? fmt::format(" ({} {} {})", numbering.vertex(a), numbering.vertex(b), numbering.vertex(c))
          : "";
  return fmt::format("{}{} at {}", triangle_name(numbering, triangle), vertices,
                     place_name(surface.vertices[static_cast<std::size_t>(a)]));
}

}  // namespace tetproof::verify
