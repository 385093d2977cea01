// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of a tetrahedral mesh: is it a valid triangulation of a solid, and does it fill the surface?
#pragma once

#include <string>
#include <vector>

#include "io/tet_mesh.hpp"
#include "io/triangle_surface.hpp"
#include "verify/report.hpp"
#include "verify/surface.hpp"

namespace tetproof::verify {

/// What of the surface the mesh should fill: the solid, or the space between the solid and an outer boundary
/// of the mesh's own.
enum class Region { none, inside, outside };

struct Options {
  Region region = Region::none;  ///< none with a surface given: only the surface's own account is made
  double fidelity =
      1e-3;  ///< allowed distance [the surface's box diagonal]; 0: the mesh reproduces the surface exactly
  bool strict_topology =
      false;  ///< topology, cavities and non-manifold edges and vertices fail; so they do at fidelity 0
  int voxels = 128;  ///< along the longest side, for the independent account of volume; 0: without
  /// For a mesh whose maker could not do better than the allowed distance, as a lattice with cells of that
  /// size: what is thinner than a cell is lost, and surface-to-mesh and missing-region only warn. To be fast,
  /// the distances are only decided, not measured more closely than that, and normals are skipped: at a tenth
  /// of the cost of such a mesh they would tell what its maker knows.
  bool coarse = false;
  std::vector<std::string> check, skip;  ///< ids; `check` empty: all
  /// The region of each tetrahedron, as element tags say; empty: one region. Regions may share faces. The
  /// mesh is judged as a whole, and each region gets its account.
  std::vector<std::int64_t> regions;
  bool timings = false;
  bool quality = true;  ///< measure angles and aspect ratios
};

/// Judges the mesh as it is written: nothing is re-wound, merged or repaired. All decisions are exact; what
/// is measured states its error.
///
/// A mesh is a valid triangulation of a solid if every tetrahedron is exactly positive, every face belongs to
/// one or two tetrahedra and two induce opposite orientations, the boundary does not intersect itself, and no
/// part of it lies inside another part's solid. Then every point off the boundary is covered as often as the
/// boundary winds around it: once inside, never outside. Same report for any number of threads. Throws
/// InputError for an unknown id in the options.
Report verify(const TetMesh& mesh, const Options& options = {});

/// The same, and against a surface. Throws InputError when the surface is not usable (`judge_surface`).
Report verify(const TetMesh& mesh, const TriangleSurface& surface, const Options& options = {});
/// The same, with a surface that was judged before.
Report verify(const TetMesh& mesh, const JudgedSurface& surface, const Options& options = {});

}  // namespace tetproof::verify
