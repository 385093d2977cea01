// SPDX-License-Identifier: GPL-3.0-or-later
// The second triangulation while it changes: which tetrahedra share a face, which edges are shared, and the
// exchange of a few tetrahedra for others.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::reference {

using Corners = std::array<Index, 4>;

/// Tetrahedra that can be replaced. Each one keeps its number, a new one gets the next number, and the number
/// of a replaced one is not used again (reading D16).
class Triangulation {
 public:
  /// `mesh`: conforming, with positive tetrahedra. `on_surface`: for each point, whether it is a surface
  /// point. Throws std::logic_error if a face belongs to more than two tetrahedra.
  Triangulation(TetMesh mesh, std::vector<std::uint8_t> on_surface);

  const Eigen::Vector3d& point(Index p) const { return mesh_.points[p]; }
  bool on_surface(Index p) const { return on_surface_[p] != 0; }
  Index points() const { return static_cast<Index>(mesh_.points.size()); }

  const Corners& corners(Index tet) const { return mesh_.tets[tet]; }
  std::array<Eigen::Vector3d, 4> corner_points(Index tet) const;
  bool alive(Index tet) const { return neighbours_[tet][0] != replaced; }
  /// The tetrahedron that shares the face opposite to a corner, or -1.
  Index neighbour(Index tet, int face) const { return neighbours_[tet][face]; }
  /// Whether another tetrahedron has the edge between two corners. Both must be surface points.
  bool edge_is_shared(Index tet, int i, int j) const;

  std::int64_t tets() const { return alive_; }  ///< how many there are now
  Index numbers() const {
    return static_cast<Index>(mesh_.tets.size());
  }  ///< how many numbers have been given

  Index add_point(const Eigen::Vector3d& point, bool on_surface);
  /// Exchanges tetrahedra for others that fill the same space. Returns the number of the first new one; the
  /// others have the next numbers. Throws std::logic_error if a face towards another tetrahedron would be
  /// lost.
  Index replace(std::span<const Index> old, std::span<const Corners> fresh);

  /// The present mesh: points as numbered here, tetrahedra in ascending order of their numbers.
  TetMesh mesh() const;

 private:
  static constexpr Index replaced = -2;
  void count_edges(const Corners& tet, int change);

  TetMesh mesh_;
  std::vector<std::uint8_t> on_surface_;
  std::vector<std::array<Index, 4>> neighbours_;
  // For each edge between surface points, the number of tetrahedra that have it.
  std::unordered_map<std::uint64_t, std::int32_t> surface_edges_;
  std::int64_t alive_ = 0;
};

}  // namespace tetproof::reference
