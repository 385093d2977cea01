// SPDX-License-Identifier: GPL-3.0-or-later
// The surface vertex closest to a point, for eq. (3.2).
#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::reference {

/// A k-d tree on the surface's vertices. Immutable; asked from any number of threads.
class VertexTree {
 public:
  explicit VertexTree(std::vector<Eigen::Vector3d> vertices);
  ~VertexTree();
  VertexTree(VertexTree&&) noexcept;

  struct Nearest {
    Index vertex;     ///< of several at the same distance the one with the lexicographically smallest
                      ///< coordinates (D15)
    double distance;  ///< eq. (3.2): sqrt(dx^2 + dy^2 + dz^2), summed in this order [length]
  };
  /// The vertex closest to a point: the same as going through all of them. `within`: a distance that is known
  /// to be enough, to prune by.
  Nearest nearest(const Eigen::Vector3d& point,
                  double within = std::numeric_limits<double>::infinity()) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace tetproof::reference
