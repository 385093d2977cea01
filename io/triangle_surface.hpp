// SPDX-License-Identifier: GPL-3.0-or-later
// A triangulated surface as plain arrays, with an optional parametric definition, and the file's numbers of
// its vertices and triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof {

/// A triangulated surface. Outward orientation: (b-a) x (c-a) points out of the solid. There are no promises:
/// `verify/surface.hpp` judges whether it is closed, manifold, oriented and free of self-intersections.
struct TriangleSurface {
  std::vector<Eigen::Vector3d> vertices;        ///< coordinates [length]; the paper's x_1 .. x_n
  std::vector<std::array<Index, 3>> triangles;  ///< three positions in `vertices` each

  /// The parametric definition, if the surface has one (reading D12): (u,v) at each corner of each triangle,
  /// so that seams and poles are unambiguous, and the evaluator. Otherwise both are empty.
  std::vector<std::array<Eigen::Vector2d, 3>> parameters;
  std::function<Eigen::Vector3d(const Eigen::Vector2d&)> evaluate;
};

/// The file's numbers of a surface's vertices and triangles, for messages. Empty vectors: numbered from the
/// first on. Equal vertices that were welded have the number of the first of them, and all triangles into
/// which a polygon was cut have the polygon's number.
struct SurfaceNumbering {
  std::vector<std::int64_t> vertices{}, triangles{};
  std::int64_t first_vertex = 0, first_triangle = 0;
  bool numbers_vertices = true;  ///< false: the file repeats coordinates and numbers no vertices (STL)
  std::string word =
      "triangle";  ///< what the file calls a triangle: "facet" in STL, "face" if it has polygons

  std::int64_t vertex(Index i) const {
    return vertices.empty() ? first_vertex + i : vertices[static_cast<std::size_t>(i)];
  }
  std::int64_t triangle(Index i) const {
    return triangles.empty() ? first_triangle + i : triangles[static_cast<std::size_t>(i)];
  }
};

}  // namespace tetproof
