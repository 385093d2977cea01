// SPDX-License-Identifier: GPL-3.0-or-later
// A closed surface whose edges can be collapsed while its vertices keep their numbers. Internal.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// The surface without unused vertices and without a parametric definition. The order of vertices and
/// triangles stays.
TriangleSurface without_unused_vertices(const TriangleSurface& surface);

/// Vertex `gone` becomes vertex `stays`, which moves to `place`.
struct Collapse {
  Index gone, stays;
  Eigen::Vector3d place;
};

class EditableSurface {
 public:
  /// `surface` must be closed, manifold, oriented and free of self-intersections.
  explicit EditableSurface(const TriangleSurface& surface);

  const std::vector<Eigen::Vector3d>& vertices() const { return vertices_; }
  /// Each edge once, the lower vertex first, ascending.
  std::vector<std::array<Index, 2>> edges() const;
  /// The neighbours of a vertex, ascending.
  std::vector<Index> neighbours(Index v) const;

  /// Whether the two vertices are an edge that can go: the link condition holds (the triangles then stay a
  /// manifold of the same genus), and at the new place no triangle is degenerate or meets another one.
  /// Exact.
  bool allows(const Collapse& collapse) const;
  /// Collapses the edge, which `allows` allows.
  void apply(const Collapse& collapse);

  TriangleSurface surface() const;

 private:
  bool link_condition(Index u, Index v) const;
  bool embedded_after(const Collapse& collapse) const;

  std::vector<Eigen::Vector3d> vertices_;
  std::vector<std::array<Index, 3>> triangles_;  // {-1, -1, -1}: gone
  std::vector<std::vector<Index>> at_;           // the triangles at each vertex
};

}  // namespace tetproof::corpus
