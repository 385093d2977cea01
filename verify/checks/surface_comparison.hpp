// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh's boundary and the surface side by side: what the checks against a surface share. Internal.
#pragma once

#include <optional>
#include <vector>

#include "verify/checks/judgement.hpp"
#include "verify/checks/surface_judgement.hpp"
#include "verify/distance/triangle_tree.hpp"
#include "verify/hausdorff.hpp"

namespace tetproof::verify {

/// The boundary faces that should be the surface's: all, but with region outside those of the sheets that are
/// the mesh's own outer boundary. The trees are absent when doubles cannot measure the common box.
struct Comparison {
  const TriangleSurface& surface;
  const SurfaceJudgement& judged;
  double allowed = 0;  ///< distance [length]
  std::vector<Triangle> faces{};
  std::vector<FaceId> ids{};    ///< of `faces`
  std::vector<Index> sheets{};  ///< of `faces`, in the boundary's sheets
  std::optional<TriangleTree> mesh_tree{}, surface_tree{};
  /// For each face a triangle of the surface that is nearest to its centroid, and the other way round; empty
  /// if the distance was not asked for.
  std::vector<Index> nearest_triangle{}, nearest_face{};
  std::optional<DirectedDistance> to_surface{}, to_mesh{};
  /// What off-surface-vertex found, in its order, and the missing or excess region at each; the largest
  /// region.
  std::vector<Index> off_vertices{};
  std::vector<std::optional<Cause>> region_at_off_vertex{};
  std::optional<Cause> region{};

  Comparison(const Judgement& j, const TriangleSurface& surface, const SurfaceJudgement& judged,
             const std::vector<int>& own);
  // The trees refer to `faces`.
  Comparison(const Comparison&) = delete;
  Comparison& operator=(const Comparison&) = delete;

  Finding at_face(Index face) const { return {.tets = {tet_of(ids[face])}, .faces = {faces[face]}}; }
};

/// off-surface-vertex, mesh-to-surface, surface-to-mesh.
void check_distances(Judgement& j, Comparison& comparison);
/// topology, of a closed boundary.
void check_topology(Judgement& j, const MeshVolumes& volumes, const Comparison& comparison);
/// missing-region, excess-region. VoxelRangeError where doubles cannot lay the voxels.
void check_missing_and_excess(Judgement& j, Comparison& comparison, const std::vector<int>& own);
/// normals.
void check_normals(Judgement& j, const Comparison& comparison);

}  // namespace tetproof::verify
