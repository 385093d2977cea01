// SPDX-License-Identifier: GPL-3.0-or-later
// Checks single tetrahedra and how they meet: orientation, duplicates, faces.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "verify/checks/evidence.hpp"
#include "verify/checks/make_finding.hpp"
#include "verify/mesh/volumes.hpp"

namespace tetproof::verify {
namespace {

// The exact volume of one tetrahedron, rounded once: where doubles cancel, it still has the right sign.
double volume_of(const TetMesh& mesh, Index t) {
  std::array<Triangle, 4> faces;
  for (FaceId f = 0; f < 4; ++f) faces[f] = vertices_of(mesh, 4 * static_cast<FaceId>(t) + f);
  return ExactVolumes(mesh.points, faces, {}, 1).volume(0);
}

// Sets of tetrahedra with the same four vertices. A pair of duplicates shares four faces: either three
// tetrahedra meet in one of them, or both lie on one side of it, or one of the two is not positive. So only
// tetrahedra are compared whose vertices all belong to such tetrahedra, and are `suspicious`.
std::vector<std::vector<Index>> duplicates(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                                           const Orientations& signs, const FaceMatching& faces) {
  std::vector<std::uint8_t> suspicious;
  const auto suspect = [&](Index t) {
    if (suspicious.empty()) suspicious.assign(mesh.points.size(), 0);
    for (const Index v : mesh.tets[t]) suspicious[v] = 1;
  };
  for (const std::vector<Index>* list : {&signs.negative, &signs.flat})
    for (const Index t : *list) suspect(t);
  for (const FaceGroups* groups : {&faces.thrice, &faces.same_side})
    for (const FaceId face : groups->faces) suspect(tet_of(face));
  std::vector<std::vector<Index>> result;
  if (suspicious.empty()) return result;

  std::vector<std::pair<std::array<Index, 4>, Index>> sorted;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (!excluded.empty() && excluded[t]) continue;
    std::array<Index, 4> tet = mesh.tets[t];
    if (!(suspicious[tet[0]] && suspicious[tet[1]] && suspicious[tet[2]] && suspicious[tet[3]])) continue;
    std::sort(tet.begin(), tet.end());
    sorted.emplace_back(tet, static_cast<Index>(t));
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0, k; i < sorted.size(); i = k) {
    std::vector<Index> same;
    for (k = i; k < sorted.size() && sorted[k].first == sorted[i].first; ++k)
      same.push_back(sorted[k].second);
    if (same.size() > 1) result.push_back(std::move(same));
  }
  std::sort(result.begin(), result.end());
  return result;
}

Finding faces_finding(const TetMesh& mesh, std::span<const FaceId> faces) {
  Finding finding{.faces = {vertices_of(mesh, faces[0])}};
  for (const FaceId face : faces) finding.tets.push_back(tet_of(face));
  return finding;
}

}  // namespace

TetrahedraEvidence examine_tetrahedra(const TetMesh& mesh, const PointEvidence& points,
                                      const Record& record) {
  TetrahedraEvidence evidence{.signs = orientations(mesh, points.excluded),
                              .faces = match_faces(mesh, points.excluded),
                              .duplicates = {}};
  if (record.wants(Check::duplicate_tet))
    evidence.duplicates = duplicates(mesh, points.excluded, evidence.signs, evidence.faces);
  return evidence;
}

void check_tetrahedra(const TetMesh& mesh, const TetrahedraEvidence& evidence, Record& record) {
  const auto one_tet = [](const std::vector<Index>& tets) {
    return [&tets](std::size_t i) { return Finding{.tets = {tets[i]}}; };
  };
  const auto one_face = [&mesh](const FaceGroups& groups) {
    return [&mesh, &groups](std::size_t i) { return faces_finding(mesh, groups[i]); };
  };
  if (record.wants(Check::duplicate_tet))
    record[Check::duplicate_tet] = {
        .count = evidence.duplicates.size(),
        .finding = [&evidence](std::size_t i) { return Finding{.tets = evidence.duplicates[i]}; },
        .describe =
            [&mesh](std::size_t, Finding& finding) {
              const auto& tet = mesh.tets[finding.tets[0]];
              finding.vertices.assign(tet.begin(), tet.end());
              finding.what = fmt::format("{} tetrahedra with the same four vertices", finding.tets.size());
            }};
  if (record.wants(Check::inverted))
    record[Check::inverted] = {.count = evidence.signs.negative.size(),
                               .finding = one_tet(evidence.signs.negative),
                               .describe = [&mesh](std::size_t, Finding& finding) {
                                 finding.what =
                                     fmt::format("negative: volume {:.6g}", volume_of(mesh, finding.tets[0]));
                               }};
  if (record.wants(Check::flat))
    record[Check::flat] = {.count = evidence.signs.flat.size(),
                           .finding = one_tet(evidence.signs.flat),
                           .describe = [](std::size_t, Finding& finding) {
                             finding.what = "its four vertices lie in one plane: volume 0, exactly";
                           }};
  if (record.wants(Check::face_shared_thrice))
    record[Check::face_shared_thrice] = {.count = evidence.faces.thrice.size(),
                                         .finding = one_face(evidence.faces.thrice),
                                         .describe = [](std::size_t, Finding& finding) {
                                           finding.what = fmt::format("this face belongs to {} tetrahedra",
                                                                      finding.tets.size());
                                         }};
  if (record.wants(Check::face_orientation))
    record[Check::face_orientation] = {
        .count = evidence.faces.same_side.size(),
        .finding = one_face(evidence.faces.same_side),
        .describe = [&mesh](std::size_t, Finding& finding) {
          finding.what = "by the order of their vertices both tetrahedra lie on the same side of this face";
          add_common_point(mesh, finding);
        }};
}

}  // namespace tetproof::verify
