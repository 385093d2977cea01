// SPDX-License-Identifier: GPL-3.0-or-later
// The surface vertex closest to a point, for eq. (3.2).
#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::reference {

/// A k-d tree on the surface's vertices. Immutable; asked from any number of threads.
class VertexTree {
 public:
  explicit VertexTree(std::vector<Eigen::Vector3d> vertices);
  ~VertexTree();
  VertexTree(VertexTree&&) noexcept;

  /// Eq. (3.2): the smallest distance of a vertex, sqrt(dx^2 + dy^2 + dz^2) summed in this order [length];
  /// the same as by going through all vertices. `within`: a distance at which a vertex is known to be, to
  /// prune by.
  double distance(const Eigen::Vector3d& point,
                  double within = std::numeric_limits<double>::infinity()) const;
  /// The vertex at the smallest distance. Distances that differ by less than 1e-12, relative, are equal, and
  /// of several vertices it is the one with the lexicographically smallest coordinates (reading D15).
  Index nearest(const Eigen::Vector3d& point, double smallest_distance) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

/// "nanoflann" and its version.
std::string vertex_tree_library();

}  // namespace tetproof::reference
