// SPDX-License-Identifier: GPL-3.0-or-later
// Which places of the boundary lie at elements that are not judged, and may be inside the mesh. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "verify/mesh/boundary.hpp"
#include "verify/verify.hpp"

namespace tetproof::verify {

/// A vertex is at an unjudged element if it is in the closed box of one, which holds the element, or if the
/// places of such elements are not known. A face all of whose vertices are so may be the side of one. Exact,
/// and on the safe side: faces near such elements may be boundary all the same.
class UnjudgedPlaces {
 public:
  /// `options` must outlive the places.
  UnjudgedPlaces(const TetMesh& mesh, const Boundary& boundary, const Options& options);

  bool any() const { return any_; }      ///< there are unjudged elements in the mesh
  bool known() const { return known_; }  ///< all of them are in `boxes`
  const std::vector<std::array<Eigen::Vector3d, 2>>& boxes() const { return *boxes_; }

  /// For a vertex of the boundary.
  bool at(Index v) const { return any_ && (!known_ || at_[static_cast<std::size_t>(v)]); }
  bool at(const Triangle& face) const { return at(face[0]) && at(face[1]) && at(face[2]); }

 private:
  bool any_, known_;
  const std::vector<std::array<Eigen::Vector3d, 2>>* boxes_;
  std::vector<std::uint8_t> at_;
};

}  // namespace tetproof::verify
