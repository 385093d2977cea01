// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh's boundary and the surface side by side: the evidence that the checks against a surface share.
// Internal.
#pragma once

#include <optional>
#include <vector>

#include "verify/checks/check_against_surface.hpp"
#include "verify/checks/surface_judgement.hpp"
#include "verify/distance/triangle_tree.hpp"
#include "verify/hausdorff.hpp"
#include "verify/voxels/surface_voxels.hpp"

namespace tetproof::verify {

/// The boundary faces that should lie on the surface, and a search tree for either side. With region outside,
/// the sheets that are the mesh's own outer boundary are left out. So are faces at elements that are not
/// judged.
struct Comparison {
  const JudgedMesh& judged_mesh;
  const TriangleSurface& surface;
  const SurfaceJudgement& judged;
  double allowed = 0;             ///< distance [length]
  std::vector<Triangle> faces{};  ///< vertices of the mesh
  std::vector<FaceId> ids{};      ///< of `faces`
  std::vector<Index> sheets{};    ///< of `faces`: their sheets of the boundary
  std::int64_t at_unjudged = 0;   ///< faces that are left out because they are at unjudged elements
  /// Absent when doubles cannot measure the box of mesh and surface.
  std::optional<TriangleTree> mesh_tree{}, surface_tree{};

  /// `own`: 1 for the sheets of the boundary that are the mesh's own.
  Comparison(const JudgedMesh& mesh, const JudgedSurface& surface, const std::vector<int>& own);
  // The trees refer to `faces`.
  Comparison(const Comparison&) = delete;
  Comparison& operator=(const Comparison&) = delete;

  Finding at_face(Index face) const { return {.tets = {tet_of(ids[face])}, .faces = {faces[face]}}; }
};

/// A boundary vertex that is farther from the surface than allowed.
struct OffVertex {
  Index vertex;
  double distance;  ///< [length], at least
  Index nearest;    ///< triangle of the surface
};

/// The distances between boundary and surface.
struct DistanceEvidence {
  /// For each face the surface's triangle that is nearest to its centroid, -1 if none is as near as allowed;
  /// empty if it was not searched for.
  std::vector<Index> nearest_triangle;
  std::optional<DirectedDistance> to_surface, to_mesh;
  /// The farthest first. Only of the first 64 is the distance exact; the others may be a thousandth farther.
  std::vector<OffVertex> off_vertices;
  bool undecided_vertices = false;  ///< some vertices are within the rounding error of the allowed distance
};
/// bounding-box.
void check_bounding_box(const Comparison& comparison, Record& record);
/// Makes a finding of bounding-box the cause of what all other checks against the surface found.
void name_bounding_box(Record& record);
DistanceEvidence measure_distances(const Comparison& comparison, Record& record);
/// off-surface-vertex, mesh-to-surface, surface-to-mesh.
void check_distances(const Comparison& comparison, const DistanceEvidence& distances, Record& record);
/// normals.
void check_normals(const Comparison& comparison, const DistanceEvidence& distances, Record& record);
/// topology, of a closed boundary.
void check_topology(const Comparison& comparison, Record& record);

/// Regions that are missing or in excess.
struct RegionEvidence {
  /// The region at each vertex of `DistanceEvidence::off_vertices`; empty if regions were not looked for.
  std::vector<std::optional<Cause>> at_off_vertex;
  std::optional<Cause> largest;
};
/// missing-region, excess-region. `own`: 1 for the sheets of the boundary that are the mesh's own. `voxels`:
/// of the surface, or null. VoxelRangeError where doubles cannot lay voxels over mesh and surface.
RegionEvidence check_missing_and_excess(const Comparison& comparison, const DistanceEvidence& distances,
                                        const std::vector<int>& own, const SurfaceVoxels* voxels,
                                        Record& record);

}  // namespace tetproof::verify
