// SPDX-License-Identifier: GPL-3.0-or-later
// Checks whether tetrahedra overlap: whether the mesh lies on the outer side of a part of its boundary.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "verify/checks/evidence.hpp"
#include "verify/checks/make_finding.hpp"
#include "verify/checks/root_causes.hpp"
#include "verify/triangles/winding.hpp"

namespace tetproof::verify {
namespace {

// Too many faces meet to ask how the parts of the boundary are nested. Compares the tetrahedra of some pairs
// of faces that meet.
void check_overlap_of_some(const TetMesh& mesh, const Boundary& boundary, const Intersections& meetings,
                           Record& record) {
  constexpr std::size_t most_tried = 1000;
  std::vector<Finding> overlaps;
  for (std::size_t i = 0; i < meetings.pairs.size() && i < most_tried && overlaps.size() < most_findings;
       ++i) {
    const auto& [s, t] = meetings.pairs[i];
    Finding finding = finding_at(mesh, std::array{boundary.faces[s], boundary.faces[t]});
    if (!add_common_point(mesh, finding)) continue;
    finding.what = "these tetrahedra overlap; the point is inside both";
    overlaps.push_back(std::move(finding));
  }
  if (overlaps.empty())
    record.could_not_run({Check::overlap},
                         fmt::format("more than {} pairs of boundary faces meet", most_counted_pairs));
  record[Check::overlap] = Suspects::complete(std::move(overlaps));
}

// For each group of faces a vertex of its first face that meets another face; -1: none does.
std::vector<Index> crossed_groups(const Boundary& boundary, const Intersections& meetings) {
  std::vector<Index> crossed(boundary.groups.sheets.size(), -1);
  for (const auto& pair : meetings.pairs)
    for (const Index f : pair)
      if (Index& vertex = crossed[boundary.groups.of_triangle[f]]; vertex < 0)
        vertex = boundary.triangles[f][0];
  return crossed;
}

}  // namespace

void check_overlap(const TetMesh& mesh, const PointEvidence& points, const BoundaryEvidence& evidence,
                   const ContactEvidence& contacts, Record& record) {
  if (!record.wants(Check::overlap)) return;
  const Boundary& boundary = evidence.boundary;
  if (contacts.meetings.more) return check_overlap_of_some(mesh, boundary, contacts.meetings, record);
  std::vector<Index> crossed(boundary.groups.sheets.size(), -1);
  if (record.wants(Check::boundary_self_intersection)) crossed = crossed_groups(boundary, contacts.meetings);
  const auto& folded = evidence.folded;
  const auto& covered = contacts.covered;
  const bool inverted = record[Check::inverted].count > 0, turned = record[Check::face_orientation].count > 0;
  // The folded pairs, and after them the covered faces.
  record[Check::overlap] = {
      .count = folded.size() + covered.size(),
      .finding =
          [&mesh, &boundary, &folded, &covered, crossed = std::move(crossed)](std::size_t i) {
            if (i < folded.size()) return finding_at(mesh, folded[i]);
            const Index face = covered[i - folded.size()].face;
            Finding finding = finding_at(mesh, std::array{boundary.faces[face]});
            // With this vertex it becomes a consequence of the intersection there.
            if (const Index vertex = crossed[boundary.groups.of_triangle[face]]; vertex >= 0)
              finding.vertices.push_back(vertex);
            return finding;
          },
      .describe =
          [&mesh, &points, &folded, &covered](std::size_t i, Finding& finding) {
            finding.vertices.clear();
            const Triangle face = finding.faces[0];
            if (i >= folded.size()) {
              // Right behind the face lies its own tetrahedron. The outer side of the face is covered, too:
              // so another tetrahedron lies there.
              if (const Index other = tet_inside(mesh, points.excluded, face, finding.tets[0]); other >= 0)
                finding.tets.push_back(other);
              finding.what =
                  fmt::format("the mesh lies on the outer side of this boundary face (winding number {})",
                              covered[i - folded.size()].winding);
            } else {
              finding.what = "these faces lie in the same place, and the tetrahedra on one side of it";
            }
            if (finding.tets.size() < 2) return;
            if (add_common_point(mesh, finding)) finding.what += "; the point is inside both tetrahedra";
          },
      .cause = [&folded, &covered, &contacts, inverted, turned](std::size_t i) -> std::optional<Cause> {
        if (i < folded.size()) return std::nullopt;
        const auto [face, winding] = covered[i - folded.size()];
        if (const auto cause = contacts.conformity.cause_of_face(face)) return cause;
        // Only faces that are wound the wrong way give a negative winding number.
        if (winding < 0 && inverted) return Cause{Check::inverted, 0};
        if (winding < 0 && turned) return Cause{Check::face_orientation, 0};
        return std::nullopt;
      }};
}

}  // namespace tetproof::verify
