// SPDX-License-Identifier: GPL-3.0-or-later
// The checks of single tetrahedra and of how they meet: orientation, duplicates, faces.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "verify/checks/judgement.hpp"
#include "verify/mesh/orientation.hpp"
#include "verify/mesh/volumes.hpp"
#include "verify/mesh/witness.hpp"

namespace tetproof::verify {
namespace {

// The exact volume of one tetrahedron, rounded once: where doubles cancel, it still has the right sign.
double volume_of(const TetMesh& mesh, Index t) {
  std::array<Triangle, 4> faces;
  for (FaceId f = 0; f < 4; ++f) faces[f] = vertices_of(mesh, 4 * static_cast<FaceId>(t) + f);
  return ExactVolumes(mesh.points, faces, {}, 1).volume(0);
}

// Sets of tetrahedra with the same four vertices, among tetrahedra with the vertices of a `suspicious` one. A
// pair of duplicates shares four faces: either three tetrahedra meet there, or both on one side, or one of
// the two is not positive.
std::vector<std::vector<Index>> duplicates(const Judgement& j, const Orientations& signs,
                                           const FaceMatching& faces) {
  std::vector<std::uint8_t> suspicious;
  const auto suspect = [&](Index t) {
    if (suspicious.empty()) suspicious.assign(j.mesh.points.size(), 0);
    for (const Index v : j.mesh.tets[t]) suspicious[v] = 1;
  };
  for (const std::vector<Index>* list : {&signs.negative, &signs.flat})
    for (const Index t : *list) suspect(t);
  for (const FaceGroups* groups : {&faces.thrice, &faces.same_side})
    for (const FaceId face : groups->faces) suspect(tet_of(face));
  std::vector<std::vector<Index>> result;
  if (suspicious.empty()) return result;

  std::vector<std::pair<std::array<Index, 4>, Index>> sorted;
  for (std::size_t t = 0; t < j.mesh.tets.size(); ++t) {
    if (!j.excluded.empty() && j.excluded[t]) continue;
    std::array<Index, 4> tet = j.mesh.tets[t];
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

// Of the faces that met only as cracks were closed: at each place two that have their tetrahedra on one side.
std::vector<std::array<FaceId, 2>> newly_folded(const TetMesh& closed_mesh, const FaceMatching& before,
                                                const FaceMatching& closed) {
  std::vector<std::array<FaceId, 2>> result;
  const auto alone = [&](FaceId face) {
    return std::binary_search(before.boundary.begin(), before.boundary.end(), face);
  };
  const auto even = [&](FaceId face) {
    const auto [a, b, c] = vertices_of(closed_mesh, face);
    return ((a > b) + (b > c) + (a > c)) % 2 == 0;
  };
  for (const FaceGroups* groups : {&closed.thrice, &closed.same_side})
    for (std::size_t i = 0; i < groups->size(); ++i) {
      const auto faces = (*groups)[i];
      if (std::none_of(faces.begin(), faces.end(), alone)) continue;
      for (std::size_t k = 1; k < faces.size(); ++k)
        if (even(faces[k]) == even(faces[0]) || k == 2) {
          const std::size_t other = even(faces[k]) == even(faces[0]) ? 0 : 1;
          result.push_back({faces[other], faces[k]});
          break;
        }
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

void check_tetrahedra(Judgement& j) {
  const TetMesh& mesh = j.mesh;
  Orientations signs = orientations(mesh, j.excluded);
  FaceMatching faces = match_faces(mesh, j.excluded);
  if (j.wants(Check::duplicate_tet)) {
    auto groups = duplicates(j, signs, faces);
    const std::size_t count = groups.size();
    j[Check::duplicate_tet] = {
        count, [groups = std::move(groups)](std::size_t i) { return Finding{.tets = groups[i]}; },
        [&mesh](std::size_t, Finding& finding) {
          const auto& tet = mesh.tets[finding.tets[0]];
          finding.vertices.assign(tet.begin(), tet.end());
          finding.what = fmt::format("{} tetrahedra with the same four vertices", finding.tets.size());
        }};
  }
  j.boundary_faces = static_cast<std::int64_t>(faces.boundary.size());
  if (const Cracks cracks = check_cracks(j, faces); cracks.closed) {
    const FaceMatching closed = match_faces(*cracks.closed, j.excluded);
    j.boundary = find_boundary(*cracks.closed, j.excluded, closed);
    j.folded = newly_folded(*cracks.closed, faces, closed);
  } else {
    j.boundary = find_boundary(mesh, j.excluded, faces);
  }
  const auto one_tet = [](std::vector<Index>&& tets) {
    return [tets = std::move(tets)](std::size_t i) { return Finding{.tets = {tets[i]}}; };
  };
  if (j.wants(Check::inverted)) {
    const std::size_t count = signs.negative.size();
    j[Check::inverted] = {count, one_tet(std::move(signs.negative)), [&mesh](std::size_t, Finding& finding) {
                            finding.what =
                                fmt::format("negative: volume {:.6g}", volume_of(mesh, finding.tets[0]));
                          }};
  }
  if (j.wants(Check::flat)) {
    const std::size_t count = signs.flat.size();
    j[Check::flat] = {count, one_tet(std::move(signs.flat)), [](std::size_t, Finding& finding) {
                        finding.what = "its four vertices lie in one plane: volume 0, exactly";
                      }};
  }
  if (j.wants(Check::face_shared_thrice)) {
    const std::size_t count = faces.thrice.size();
    j[Check::face_shared_thrice] = {
        count,
        [&mesh, groups = std::move(faces.thrice)](std::size_t i) { return faces_finding(mesh, groups[i]); },
        [](std::size_t, Finding& finding) {
          finding.what = fmt::format("this face belongs to {} tetrahedra", finding.tets.size());
        }};
  }
  if (j.wants(Check::face_orientation)) {
    const std::size_t count = faces.same_side.size();
    j[Check::face_orientation] = {
        count,
        [&mesh, groups = std::move(faces.same_side)](std::size_t i) {
          return faces_finding(mesh, groups[i]);
        },
        [&mesh](std::size_t, Finding& finding) {
          finding.what = "by the order of their vertices both tetrahedra lie on the same side of this face";
          if (const auto both =
                  common_point(mesh.points, mesh.tets[finding.tets[0]], mesh.tets[finding.tets[1]]))
            finding.point = both->point, finding.point_exact = both->exact;
        }};
  }
}

}  // namespace tetproof::verify
