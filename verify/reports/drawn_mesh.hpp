// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a mesh that a page holds: all of it, or what a browser bears. Internal.
#pragma once

#include <string>
#include <vector>

#include "io/page/reduced.hpp"
#include "io/page/scene.hpp"
#include "verify/mesh/faces.hpp"
#include "verify/report_page.hpp"

namespace tetproof::verify {

/// Puts points and tetrahedra of the mesh into a scene, and knows where they are there. Refers to all that it
/// is given.
class DrawnMesh {
 public:
  /// What is not drawn is said in `left_out`, a sentence each.
  DrawnMesh(const PageSubject& subject, io::Scene& scene, std::vector<std::string>& left_out);

  /// Whether the vertex is a point of the mesh with finite coordinates.
  bool usable(Index v) const;
  /// Whether the tetrahedron has four different usable points.
  bool drawable(Index t) const { return !undrawable_[static_cast<std::size_t>(t)]; }

  /// Chooses what the page holds: all tetrahedra if they fit into `most_bytes`, before base64; else those
  /// that planes through the middle meet, and the boundary by fewer triangles. To be called before `point`
  /// and `tet`, so that the tetrahedra that can be cut come first.
  void choose(std::size_t most_bytes);

  /// The position in the scene of a usable point and of a drawable tetrahedron, which are added when first
  /// asked for.
  Index point(Index v);
  Index tet(Index t);

  /// The layer of the boundary, with the distances to the subject's surface if `with_distances`.
  io::SceneLayer boundary(bool with_distances);

 private:
  std::size_t tet_bytes() const { return subject_.regions.empty() ? 12 : 16; }
  void hold_middle(std::size_t most_bytes);

  const PageSubject& subject_;
  const TetMesh& mesh_;
  io::Scene& scene_;
  std::vector<std::string>& left_out_;
  std::vector<std::uint8_t> undrawable_;
  std::vector<Index> place_of_point_, place_of_tet_;  // in the scene; -1: not there
  std::vector<FaceId> faces_;                         // of the boundary
  std::vector<std::array<Index, 3>> triangles_;       // of these faces
  io::ReducedTriangles fewer_;                        // drawn in their place, if there are any
};

}  // namespace tetproof::verify
