// SPDX-License-Identifier: GPL-3.0-or-later
// Checks for cracks, and finds the boundary of the mesh with its cracks closed.
#include <algorithm>
#include <limits>

#include "verify/checks/evidence.hpp"
#include "verify/checks/make_finding.hpp"

namespace tetproof::verify {
namespace {

// Faces that met only when the cracks were closed: of each place two whose tetrahedra lie on one side.
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

// Adds the vertices of one face that the other one does not have.
void add_vertices(const Triangle& face, const Triangle& other, std::vector<Index>& vertices) {
  for (const Index v : face)
    if (std::find(other.begin(), other.end(), v) == other.end()) vertices.push_back(v);
}

}  // namespace

Cracks examine_cracks(const TetMesh& mesh, const PointEvidence& points, const TetrahedraEvidence& tetrahedra,
                      const Record& record) {
  if (!record.wants(Check::crack)) return {};
  return find_cracks(mesh, points.excluded, tetrahedra.faces.boundary, points.same_place);
}

void check_cracks(const TetMesh& mesh, const PointEvidence& points, const Cracks& cracks, Record& record) {
  if (cracks.pairs.empty()) return;
  record.report.notes.push_back(
      "components, cavities, genus and all checks of the boundary are of the mesh with its cracks closed");
  // The first crack at each point is the cause of the point's duplicates.
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> first(mesh.points.size(), none);
  for (std::size_t i = 0; i < cracks.pairs.size(); ++i)
    for (const FaceId face : cracks.pairs[i])
      for (const Index v : vertices_of(mesh, face))
        first[static_cast<std::size_t>(v)] =
            std::min(first[static_cast<std::size_t>(v)], static_cast<std::uint32_t>(i));
  if (record.wants(Check::duplicate_point))
    record[Check::duplicate_point].cause = [&points,
                                            first = std::move(first)](std::size_t i) -> std::optional<Cause> {
      std::uint32_t crack = none;
      for (const Index v : points.same_place[i]) {
        if (first[static_cast<std::size_t>(v)] == none) return std::nullopt;
        crack = std::min(crack, first[static_cast<std::size_t>(v)]);
      }
      return Cause{Check::crack, crack};
    };
  record[Check::crack] = {
      .count = cracks.pairs.size(),
      .finding = [&mesh, &cracks](std::size_t i) { return finding_at(mesh, cracks.pairs[i]); },
      .describe =
          [](std::size_t, Finding& finding) {
            add_vertices(finding.faces[0], finding.faces[1], finding.vertices);
            add_vertices(finding.faces[1], finding.faces[0], finding.vertices);
            finding.what =
                "these faces lie in the same place and are not shared: points with equal coordinates";
          }};
}

BoundaryEvidence examine_boundary(const TetMesh& mesh, const PointEvidence& points,
                                  const TetrahedraEvidence& tetrahedra, const Cracks& cracks) {
  if (!cracks.closed)
    return {.boundary = find_boundary(mesh, points.excluded, tetrahedra.faces), .folded = {}};
  const FaceMatching closed = match_faces(*cracks.closed, points.excluded);
  return {.boundary = find_boundary(*cracks.closed, points.excluded, closed),
          .folded = newly_folded(*cracks.closed, tetrahedra.faces, closed)};
}

}  // namespace tetproof::verify
