// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary faces of the grid, found by their place. They are searched before a point is moved to the
// parametric surface, so that the move does not make the boundary meet itself (reading D12).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::reference {

struct BoundaryFace {
  std::array<Index, 3> names;  ///< the numbers of its points, in any order
  std::array<Eigen::Vector3d, 3> corners;
};

/// Whether two faces have more in common than the vertex or the edge whose numbers they share. Exact.
bool faces_meet(const BoundaryFace& f, const BoundaryFace& g);

/// Faces, stored by the cells of a uniform grid that they meet. Adding, removing and searching take constant
/// time if a face meets only a few cells and a cell holds only a few faces.
class BoundaryFaces {
 public:
  /// `cell`: the side of the cells [length], positive; best about the size of a face.
  explicit BoundaryFaces(double cell) : cell_(cell) {}

  void add(const BoundaryFace& face);
  void remove(const BoundaryFace& face);  ///< needs the same corners as `add` got
  /// Whether `face` meets one of the stored faces for which `counts` is true.
  bool meets(const BoundaryFace& face, const std::function<bool(const BoundaryFace&)>& counts) const;

 private:
  template <class Visit>
  void visit_cells(const BoundaryFace& face, const Visit& visit) const;

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<BoundaryFace>> faces_;
};

}  // namespace tetproof::reference
