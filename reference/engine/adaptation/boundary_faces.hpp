// SPDX-License-Identifier: GPL-3.0-or-later
// The faces that no other tetrahedron shares, by place: so that a point that moves to the parametric surface
// does not carry the boundary through itself (reading D12).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::reference {

struct BoundaryFace {
  std::array<Index, 3> names;  ///< of its points, in any order
  std::array<Eigen::Vector3d, 3> corners;
};

/// Whether two faces have a point in common beside the vertices, or the edge, that they share by name. Exact.
bool faces_meet(const BoundaryFace& f, const BoundaryFace& g);

/// Faces in the cells of a uniform grid. Adding, removing and asking take constant time where faces are no
/// larger than a few cells and no cell holds many.
class BoundaryFaces {
 public:
  /// `cell`: side of the cells [length], positive; about the size of a face.
  explicit BoundaryFaces(double cell) : cell_(cell) {}

  void add(const BoundaryFace& face);
  void remove(const BoundaryFace& face);  ///< with the corners that it was added with
  /// Whether the face meets one of those held that `counts` accepts.
  bool meets(const BoundaryFace& face, const std::function<bool(const BoundaryFace&)>& counts) const;

 private:
  template <class Visit>
  void visit_cells(const BoundaryFace& face, const Visit& visit) const;

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<BoundaryFace>> faces_;
};

}  // namespace tetproof::reference
