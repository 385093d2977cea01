// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/verify.hpp"

#include "verify/faces.hpp"
#include "verify/orientation.hpp"

namespace tetproof::verify {

Report verify(const TetMesh& mesh, const Options&) {
  Report report;
  for (int i = 0; i < check_count; ++i) report.checks.push_back({.check = static_cast<Check>(i)});
  const auto settle = [&](Check check, std::size_t count) {
    CheckResult& result = report.checks[static_cast<std::size_t>(check)];
    result.count = static_cast<std::int64_t>(count);
    result.verdict = count ? Verdict::fail : Verdict::pass;
  };
  const Orientations signs = orientations(mesh, {});
  settle(Check::inverted, signs.negative.size());
  settle(Check::flat, signs.flat.size());
  const FaceMatching faces = match_faces(mesh, {});
  settle(Check::face_shared_thrice, faces.thrice.size());
  settle(Check::face_orientation, faces.same_side.size());
  report.mesh = {.points = static_cast<std::int64_t>(mesh.points.size()),
                 .tets = static_cast<std::int64_t>(mesh.tets.size()),
                 .boundary_faces = static_cast<std::int64_t>(faces.boundary.size())};
  if (!sound(report)) report.certificate = false;
  return report;
}

Report verify(const TetMesh& mesh, const TriangleSurface&, const Options& options) {
  return verify(mesh, options);
}

}  // namespace tetproof::verify
