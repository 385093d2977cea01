// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/checks/make_finding.hpp"

#include "verify/mesh/witness.hpp"

namespace tetproof::verify {

bool add_common_point(const TetMesh& mesh, Finding& finding) {
  const auto both = common_point(mesh.points, mesh.tets[finding.tets[0]], mesh.tets[finding.tets[1]]);
  if (!both) return false;
  finding.point = both->point;
  finding.point_exact = both->exact;
  return true;
}

}  // namespace tetproof::verify
