// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of findings that several checks need. Internal.
#pragma once

#include <span>

#include "verify/mesh/faces.hpp"
#include "verify/report.hpp"

namespace tetproof::verify {

/// A finding with these faces, and for each face its tetrahedron.
inline Finding finding_at(const TetMesh& mesh, std::span<const FaceId> faces) {
  Finding finding;
  for (const FaceId face : faces) {
    finding.tets.push_back(tet_of(face));
    finding.faces.push_back(vertices_of(mesh, face));
  }
  return finding;
}

/// Adds a point strictly inside the finding's first two tetrahedra. False if there is none.
bool add_common_point(const TetMesh& mesh, Finding& finding);

}  // namespace tetproof::verify
