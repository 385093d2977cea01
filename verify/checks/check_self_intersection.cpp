// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the places where the boundary meets itself, or nearly does, and checks for self-intersections.
#include <fmt/core.h>

#include <algorithm>
#include <numeric>

#include "verify/checks/evidence.hpp"
#include "verify/checks/make_finding.hpp"
#include "verify/triangles/chunks.hpp"
#include "verify/triangles/winding.hpp"

namespace tetproof::verify {
namespace {

bool wants_nearness(const Record& record) {
  return record.wants(Check::hanging_node) || record.wants(Check::crossed_diagonal) ||
         record.wants(Check::near_contact);
}

Intersections find_meetings(const TetMesh& mesh, const Boundary& boundary, const Near& near,
                            const std::vector<std::uint8_t>& degenerate, Record& record) {
  const bool nearness = wants_nearness(record);
  if (!nearness && !record.wants(Check::boundary_self_intersection) && !record.wants(Check::overlap) &&
      !record.wants(Check::non_conforming_interface))
    return {};
  Intersections meetings = self_intersections(mesh.points, boundary.boundary_triangles(), degenerate,
                                              most_pairs, nearness ? &near : nullptr);
  const bool more = meetings.more;
  if (!more && !meetings.more_near) return meetings;
  const char* which = more ? "meet" : "are near each other";
  const std::string why = fmt::format("more than {} pairs of boundary faces {}", most_counted_pairs, which);
  record.could_not_run({Check::hanging_node, Check::crossed_diagonal, Check::near_contact}, why);
  if (more) record.could_not_run({Check::non_conforming_interface}, why);
  record.report.notes.push_back(
      fmt::format("{}: {}hanging nodes, crossed diagonals and near contacts were not searched for{}", why,
                  more ? "some of them are named; " : "",
                  more ? ", nor interfaces that do not match, and overlaps only among those" : ""));
  return meetings;
}

// Of each group of faces one face that is not degenerate, if the mesh lies on its outer side.
std::vector<CoveredFace> covered_faces(const TetMesh& mesh, const Boundary& boundary,
                                       const std::vector<std::uint8_t>& degenerate) {
  std::vector<Index> start(boundary.groups.sheets.size(), -1), starts;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    Index& first = start[boundary.groups.of_triangle[f]];
    if (first < 0 && !degenerate[f]) first = static_cast<Index>(f);
  }
  std::copy_if(start.begin(), start.end(), std::back_inserter(starts), [](Index f) { return f >= 0; });
  const auto crossings = cast_rays(mesh.points, boundary.triangles, starts);
  std::vector<CoveredFace> covered;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    int winding = 0;
    for (const Crossing& c : crossings[i]) winding += c.sign;
    if (winding != 0) covered.push_back({starts[i], winding});
  }
  return covered;
}

}  // namespace

ContactEvidence examine_contacts(const TetMesh& mesh, const Boundary& boundary, Record& record) {
  const Degenerate degenerate = degenerate_triangles(mesh.points, boundary.boundary_triangles());
  std::vector<Index> opposite;  // of each face, the vertex of its tetrahedron
  for (const FaceId face : boundary.faces) opposite.push_back(mesh.tets[tet_of(face)][face & 3]);
  ContactEvidence evidence{.near = Near(mesh.points, boundary.boundary_triangles(), opposite),
                           .meetings = {},
                           .covered = {},
                           .conformity = {},
                           .near_pairs = {},
                           .interfaces = {}};
  evidence.meetings = find_meetings(mesh, boundary, evidence.near, degenerate.triangles, record);
  const Intersections& meetings = evidence.meetings;
  if (record.wants(Check::overlap) && !meetings.more)
    evidence.covered = covered_faces(mesh, boundary, degenerate.triangles);
  if (meetings.contacts.empty() && meetings.folds.empty() && meetings.near.empty() &&
      evidence.covered.empty())
    return evidence;
  const FacesAtVertices at(boundary, mesh.points.size());
  if (record.wants(Check::hanging_node) || record.wants(Check::crossed_diagonal)) {
    std::vector<Index> covered;
    for (const CoveredFace& face : evidence.covered) covered.push_back(face.face);
    evidence.conformity = find_conformity(mesh, boundary, at, meetings, evidence.near, covered);
  }
  if (record.wants(Check::near_contact))
    evidence.near_pairs = collect_in_order<std::array<Index, 2>>(
        meetings.near.size(), 1024,
        [&](std::size_t begin, std::size_t end, std::vector<std::array<Index, 2>>& found) {
          for (std::size_t i = begin; i < end; ++i)
            if (const auto& [s, t] = meetings.near[i]; !one_place(boundary, at, evidence.near, s, t))
              found.push_back(meetings.near[i]);
        });
  return evidence;
}

void check_self_intersection(const TetMesh& mesh, const Boundary& boundary, const ContactEvidence& contacts,
                             Record& record) {
  if (!record.wants(Check::boundary_self_intersection)) return;
  const auto& pairs = contacts.meetings.pairs;
  record[Check::boundary_self_intersection] = {
      .count = pairs.size(),
      .finding =
          [&mesh, &boundary, &pairs](std::size_t i) {
            return finding_at(mesh, std::array{boundary.faces[pairs[i][0]], boundary.faces[pairs[i][1]]});
          },
      .describe =
          [&mesh](std::size_t, Finding& finding) {
            int common = 0;
            for (const Index v : finding.faces[0])
              common += std::count(finding.faces[1].begin(), finding.faces[1].end(), v);
            finding.what = common == 0   ? "these boundary faces meet and have no common vertex"
                           : common == 1 ? "these boundary faces meet in more than their common vertex"
                           : common == 2
                               ? "these boundary faces lie folded on each other at their common edge"
                               : "these boundary faces have the same three vertices";
            if (add_common_point(mesh, finding)) finding.what += "; the point is inside both tetrahedra";
          },
      .beyond = static_cast<std::size_t>(contacts.meetings.count) - pairs.size(),
      .cause =
          [&boundary, &pairs, &contacts](std::size_t i) {
            return contacts.conformity.cause_of_pair(boundary, pairs[i][0], pairs[i][1]);
          }};
}

}  // namespace tetproof::verify
