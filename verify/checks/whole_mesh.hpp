// SPDX-License-Identifier: GPL-3.0-or-later
// Faults that concern the mesh as a whole: shifted vertex numbers, the other vertex order, a second copy.
// Internal.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "verify/checks/evidence.hpp"

namespace tetproof::verify {

/// Tetrahedra in the other vertex order: nine tenths or more of a mesh, or of a region, are negative.
struct OtherOrder {
  std::optional<std::int64_t> region;  ///< as in `Options::regions`; absent: of the whole mesh
  std::string of_region;               ///< " of region 3", " of physical 2 (steel)"; empty: of the whole mesh
  std::vector<Index> negative;         ///< ascending
  std::int64_t tets = 0;               ///< of the mesh or the region, without those that have no sign
};

struct WholeMeshEvidence {
  Index shift = 0;                ///< all vertex numbers are too high by this; 0: they are not
  std::int64_t faulty = 0;        ///< tetrahedra that name no point, are flat, or not of the usual sign
  std::int64_t faulty_after = 0;  ///< likewise, without the shift
  std::vector<OtherOrder> other_order;
  std::vector<std::vector<Index>> copies;  ///< as `find_copies` finds them
};
/// Costs a glance at the counts of a mesh that has no such fault.
WholeMeshEvidence examine_whole_mesh(const TetMesh& mesh, const PointEvidence& points,
                                     const TetrahedraEvidence& tetrahedra, const Options& options,
                                     const Record& record);
/// Puts these faults in the place of the single findings of index-range, inverted and duplicate-tet, and
/// names them as the cause of what other checks found. Comes after all other checks.
void check_whole_mesh(const TetMesh& mesh, const PointEvidence& points, const TetrahedraEvidence& tetrahedra,
                      const WholeMeshEvidence& whole, Record& record);

/// A mesh without these faults.
struct MendedMesh {
  TetMesh mesh;
  Options options;                    ///< for this mesh: its regions, and the points of elements not judged
  std::vector<Index> tets, vertices;  ///< for each tetrahedron and point, its position in the mesh as written
  std::string how;                    ///< what was changed
};
/// Nothing if there are no such faults.
std::optional<MendedMesh> mend(const TetMesh& mesh, const PointEvidence& points,
                               const WholeMeshEvidence& whole, const Options& options, const Record& record);

}  // namespace tetproof::verify
