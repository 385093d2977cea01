// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of a tetrahedral mesh: is it a valid triangulation of a solid, and does it fill the surface?
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/progress.hpp"
#include "io/tet_mesh.hpp"
#include "io/triangle_surface.hpp"
#include "verify/deadline.hpp"
#include "verify/report.hpp"
#include "verify/surface.hpp"

namespace tetproof::verify {

/// The part of space that the mesh should fill: the solid inside the surface, or the space between the solid
/// and an outer boundary of the mesh's own.
enum class Region { none, inside, outside };

/// The parts of a file that are not judged: elements that are no tetrahedra, curved shapes, and elements that
/// were not read.
struct Unjudged {
  std::vector<NotJudged> elements{};  ///< elements of dimension 3 that are no tetrahedra
  std::vector<NotJudged> unread{};    ///< elements that the readers of mesh and surface dropped
  std::int64_t curved = 0;            ///< tetrahedra of which only the corners are judged
  std::vector<Index> points{};        ///< points of the mesh that `elements` use: they are not unused
  bool points_known = true;           ///< false: elements of the mesh were not read, and may use any point
  /// The boxes that hold `elements`, by their least and largest corners [length]: the box of the nodes of
  /// each
  std::vector<std::array<Eigen::Vector3d, 2>> boxes{};
  /// False: some elements are at places that `boxes` does not tell, because they were not read, are of higher
  /// order, or have nodes without coordinates.
  bool places_known = true;
};

/// Finds what `tet_mesh(document)` lacks of the mesh in a document: elements that the reader dropped,
/// elements of dimension 3 of other shapes, and the curved shapes of tetrahedra of higher order. A
/// tetrahedron of ten nodes is not curved if each of the six others is exactly in the middle of its edge.
Unjudged unjudged(const Document& document);
/// Adds the elements that the reader of the surface's file dropped: the mesh is then compared with a part of
/// the surface only.
void add_unread_surface(Unjudged& unjudged, const std::vector<Loss>& dropped);

struct Options {
  Region region = Region::none;  ///< none with a surface given: the report describes the surface, no more
  /// Allowed distance [the surface's box diagonal]; 0: the mesh reproduces the surface exactly.
  double fidelity = 1e-3;
  /// Topology, cavities and non-manifold edges and vertices fail instead of warn. So they do at fidelity 0.
  bool strict_topology = false;
  int voxels = 128;  ///< along the longest side, for the independent account of volume; 0: without
  /// For a mesh that cannot be closer to the surface than the allowed distance, because it was made from a
  /// lattice with cells of that size. Parts thinner than a cell are lost, so surface-to-mesh and
  /// missing-region only warn. To save time, the distances are compared with the allowed one and not measured
  /// more closely, and normals are skipped: they would take a tenth of the time that making such a mesh
  /// takes, and tell its maker nothing new.
  bool coarse = false;
  /// The distances are compared with the allowed one, and not measured: the search ends as soon as it is
  /// decided, and the intervals in the report may be wide. For whoever asks for the verdict alone.
  bool decide_only = false;
  std::vector<std::string> check, skip;  ///< ids; `check` empty: all
  /// Ids of checks whose findings are meant, so that they and what follows from them do not fail: "crack" and
  /// "non-conforming-interface", for models of fracture and contact. They remain in the report as warnings.
  std::vector<std::string> allow{};
  /// The region of each tetrahedron, from the tags of its element; empty: one region. Regions may share
  /// faces. The mesh is judged as a whole, and each region gets its own account.
  std::vector<std::int64_t> regions{};
  /// If not empty, `regions` are positions in it, as `tet_regions` gives both; else they are tags.
  std::vector<RegionTag> region_tags{};
  Unjudged unjudged{};  ///< if there are any such parts, a mesh without defect is not sound but incomplete
  /// The tetrahedra alone are judged: `unjudged.elements` count as left out, and the mesh is compared with
  /// the surface as if they were not there. Curved shapes and elements that were not read are still not
  /// judged.
  bool only_tets = false;
  bool timings = false;  ///< quality is measured beside the other phases; its own is the rest
  bool quality = true;   ///< measure angles and aspect ratios
  /// `verify` throws OutOfTime soon after: it looks between its stages and while it measures distances.
  Deadline deadline{};
  ProgressListener progress{};  ///< gets the stages of the judgement as they begin
};

/// Judges the mesh as it is written: nothing is re-wound, merged or repaired. All decisions are exact, and
/// every measured value states its error.
///
/// A mesh is a valid triangulation of a solid if four things hold. Every tetrahedron is exactly positive.
/// Every face belongs to one or two tetrahedra, and two induce opposite orientations. The boundary does not
/// intersect itself. No part of the boundary lies inside the solid of another part. Then every point off the
/// boundary is covered as often as the boundary winds around it: once inside, never outside.
///
/// The report is the same for any number of threads. Throws InputError for an unknown id in the options, and
/// for one in `allow` that cannot be allowed.
Report verify(const TetMesh& mesh, const Options& options = {});

/// Judges the mesh, and compares it with a surface. Throws InputError when the surface is not usable
/// (`judge_surface`).
Report verify(const TetMesh& mesh, const TriangleSurface& surface, const Options& options = {});
/// Does the same with a surface that was judged before.
Report verify(const TetMesh& mesh, const JudgedSurface& surface, const Options& options = {});

}  // namespace tetproof::verify
