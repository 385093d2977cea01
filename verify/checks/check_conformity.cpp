// SPDX-License-Identifier: GPL-3.0-or-later
// The checks of faces that lack their partner: hanging nodes, crossed diagonals, cracks, and what all but
// touches.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "verify/checks/judgement.hpp"

namespace tetproof::verify {
namespace {

// Faces of the boundary, with their tetrahedra, each once.
Finding finding_of(const Judgement& j, std::span<const Index> faces) {
  Finding finding;
  for (const Index f : faces) {
    const FaceId face = j.boundary.faces[static_cast<std::size_t>(f)];
    finding.faces.push_back(vertices_of(j.mesh, face));
    if (std::find(finding.tets.begin(), finding.tets.end(), tet_of(face)) == finding.tets.end())
      finding.tets.push_back(tet_of(face));
  }
  return finding;
}

Suspects hanging_nodes(const Judgement& j) {
  return {j.conformity.hanging.size(),
          [&j](std::size_t i) {
            const HangingNode& node = j.conformity.hanging[i];
            std::vector<Index> faces = node.carriers;
            faces.insert(faces.end(), node.opposite.begin(), node.opposite.end());
            Finding finding = finding_of(j, faces);
            finding.vertices = {node.vertex};
            return finding;
          },
          [&j](std::size_t i, Finding& finding) {
            const HangingNode& node = j.conformity.hanging[i];
            finding.point = j.mesh.points[static_cast<std::size_t>(node.vertex)];
            finding.what = fmt::format("the vertex lies on {} without belonging to {}; the other {} opposite",
                                       node.carriers.size() == 1
                                           ? "the first face"
                                           : fmt::format("the first {} faces", node.carriers.size()),
                                       node.carriers.size() == 1 ? "it" : "them",
                                       node.opposite.size() == 1 ? "face lies" : "faces lie");
          }};
}

Suspects crossed_diagonals(const Judgement& j) {
  return {j.conformity.crossed.size(),
          [&j](std::size_t i) {
            const CrossedDiagonals& quad = j.conformity.crossed[i];
            Finding finding = finding_of(j, quad.faces);
            finding.vertices.assign(quad.vertices.begin(), quad.vertices.end());
            return finding;
          },
          [](std::size_t, Finding& finding) {
            finding.what =
                "two pairs of faces on these four vertices, cut along one diagonal on the one side and along "
                "the other on the other";
          }};
}

Suspects near_contacts(Judgement& j, const FacesAtVertices& at, const Near& near) {
  std::vector<std::array<Index, 2>> pairs;
  for (const auto& [s, t] : j.meetings.near)
    if (!one_place(j.boundary, at, near, s, t)) pairs.push_back({s, t});
  CheckResult& result = j.report.checks[static_cast<std::size_t>(Check::near_contact)];
  for (const auto& [s, t] : pairs) {
    const double distance =
        near.diagonal() * near.between_triangles(j.boundary.triangles[s], j.boundary.triangles[t]);
    result.measured = std::min(distance, result.measured.value_or(distance));
    result.allowed = near.limit() * near.diagonal();
  }
  const std::size_t count = pairs.size(),
                    beyond = static_cast<std::size_t>(j.meetings.near_count) - j.meetings.near.size();
  return {count, [&j, pairs](std::size_t i) { return finding_of(j, pairs[i]); },
          [&j, pairs, near](std::size_t i, Finding& finding) {
            const auto [s, t] = pairs[i];
            finding.what = fmt::format(
                "these boundary faces do not touch, but are only {:.3g} apart",
                near.diagonal() * near.between_triangles(j.boundary.triangles[s], j.boundary.triangles[t]));
          },
          beyond,
          [&j, pairs](std::size_t i) {
            return j.conformity.cause_of_pair(j.boundary, pairs[i][0], pairs[i][1]);
          }};
}

}  // namespace

Cracks check_cracks(Judgement& j, const FaceMatching& faces) {
  if (!j.wants(Check::crack)) return {};
  Cracks cracks = find_cracks(j.mesh, j.excluded, faces.boundary, j.same_place);
  if (cracks.pairs.empty()) return cracks;
  j.report.notes.push_back(
      "components, cavities, genus and all checks of the boundary are of the mesh with its cracks closed");
  // The first crack at each point, to which the point's duplicates are put down.
  std::vector<std::uint32_t> first(j.mesh.points.size(), ~std::uint32_t{0});
  for (std::size_t i = 0; i < cracks.pairs.size(); ++i)
    for (const FaceId face : cracks.pairs[i])
      for (const Index v : vertices_of(j.mesh, face))
        first[static_cast<std::size_t>(v)] =
            std::min(first[static_cast<std::size_t>(v)], static_cast<std::uint32_t>(i));
  if (j.wants(Check::duplicate_point))
    j[Check::duplicate_point].cause = [&j, first = std::move(first)](std::size_t i) -> std::optional<Cause> {
      std::uint32_t crack = ~std::uint32_t{0};
      for (const Index v : j.same_place[i]) {
        if (first[static_cast<std::size_t>(v)] == ~std::uint32_t{0}) return std::nullopt;
        crack = std::min(crack, first[static_cast<std::size_t>(v)]);
      }
      return Cause{Check::crack, crack};
    };
  const std::size_t count = cracks.pairs.size();
  j[Check::crack] = {
      count,
      [&mesh = j.mesh, pairs = std::exchange(cracks.pairs, {})](std::size_t i) {
        Finding finding;
        for (const FaceId face : pairs[i]) {
          finding.tets.push_back(tet_of(face));
          finding.faces.push_back(vertices_of(mesh, face));
        }
        return finding;
      },
      [](std::size_t, Finding& finding) {
        for (const Index v : finding.faces[0])
          if (std::find(finding.faces[1].begin(), finding.faces[1].end(), v) == finding.faces[1].end())
            finding.vertices.push_back(v);
        for (const Index v : finding.faces[1])
          if (std::find(finding.faces[0].begin(), finding.faces[0].end(), v) == finding.faces[0].end())
            finding.vertices.push_back(v);
        finding.what = "these faces lie in the same place and are not shared: points with equal coordinates";
      }};
  return cracks;
}

void find_meetings(Judgement& j, const Near& near, const std::vector<std::uint8_t>& degenerate) {
  const bool nearness =
      j.wants(Check::hanging_node) || j.wants(Check::crossed_diagonal) || j.wants(Check::near_contact);
  if (!nearness && !j.wants(Check::boundary_self_intersection) && !j.wants(Check::overlap)) return;
  j.meetings = self_intersections(j.mesh.points, j.boundary.boundary_triangles(), degenerate, most_pairs,
                                  nearness ? &near : nullptr);
  const bool more = j.meetings.more;
  if (!more && !j.meetings.more_near) return;
  j.skip({Check::hanging_node, Check::crossed_diagonal, Check::near_contact});
  j.report.notes.push_back(
      fmt::format("more than {} pairs of boundary faces {}: {}hanging nodes, crossed diagonals and near "
                  "contacts were not "
                  "searched for{}",
                  most_counted_pairs, more ? "meet" : "are near each other",
                  more ? "some of them are named; " : "", more ? ", and overlaps only among those" : ""));
}

void check_conformity(Judgement& j, const Near& near, const std::vector<Index>& covered) {
  if (j.meetings.contacts.empty() && j.meetings.folds.empty() && j.meetings.near.empty() && covered.empty())
    return;
  const FacesAtVertices at(j.boundary, j.mesh.points.size());
  if (j.wants(Check::hanging_node) || j.wants(Check::crossed_diagonal))
    j.conformity = find_conformity(j.mesh, j.boundary, at, j.meetings, near, covered);
  if (j.wants(Check::hanging_node)) j[Check::hanging_node] = hanging_nodes(j);
  if (j.wants(Check::crossed_diagonal)) j[Check::crossed_diagonal] = crossed_diagonals(j);
  if (j.wants(Check::near_contact)) j[Check::near_contact] = near_contacts(j, at, near);
}

}  // namespace tetproof::verify
