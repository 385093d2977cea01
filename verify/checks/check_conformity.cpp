// SPDX-License-Identifier: GPL-3.0-or-later
// Checks for boundary faces that lack their partner: hanging nodes, crossed diagonals, near contacts.
#include <fmt/core.h>

#include <algorithm>

#include "verify/checks/evidence.hpp"

namespace tetproof::verify {
namespace {

// Faces of the boundary, by their positions, with their tetrahedra. Each tetrahedron is named once.
Finding finding_of(const TetMesh& mesh, const Boundary& boundary, std::span<const Index> faces) {
  Finding finding;
  for (const Index f : faces) {
    const FaceId face = boundary.faces[static_cast<std::size_t>(f)];
    finding.faces.push_back(vertices_of(mesh, face));
    if (std::find(finding.tets.begin(), finding.tets.end(), tet_of(face)) == finding.tets.end())
      finding.tets.push_back(tet_of(face));
  }
  return finding;
}

Suspects hanging_nodes(const TetMesh& mesh, const Boundary& boundary,
                       const std::vector<HangingNode>& hanging) {
  return {.count = hanging.size(),
          .finding =
              [&mesh, &boundary, &hanging](std::size_t i) {
                std::vector<Index> faces = hanging[i].carriers;
                faces.insert(faces.end(), hanging[i].opposite.begin(), hanging[i].opposite.end());
                Finding finding = finding_of(mesh, boundary, faces);
                finding.vertices = {hanging[i].vertex};
                return finding;
              },
          .describe =
              [&mesh, &hanging](std::size_t i, Finding& finding) {
                const HangingNode& node = hanging[i];
                finding.point = mesh.points[static_cast<std::size_t>(node.vertex)];
                finding.what = fmt::format(
                    "the vertex lies on {} without belonging to {}; the other {} opposite",
                    node.carriers.size() == 1 ? "the first face"
                                              : fmt::format("the first {} faces", node.carriers.size()),
                    node.carriers.size() == 1 ? "it" : "them",
                    node.opposite.size() == 1 ? "face lies" : "faces lie");
              }};
}

Suspects crossed_diagonals(const TetMesh& mesh, const Boundary& boundary,
                           const std::vector<CrossedDiagonals>& crossed) {
  return {.count = crossed.size(),
          .finding =
              [&mesh, &boundary, &crossed](std::size_t i) {
                Finding finding = finding_of(mesh, boundary, crossed[i].faces);
                finding.vertices.assign(crossed[i].vertices.begin(), crossed[i].vertices.end());
                return finding;
              },
          .describe =
              [](std::size_t, Finding& finding) {
                finding.what =
                    "two pairs of faces on these four vertices, cut along one diagonal on the one side and "
                    "along the other on the other";
              }};
}

}  // namespace

void check_conformity(const TetMesh& mesh, const Boundary& boundary, const ContactEvidence& contacts,
                      Record& record) {
  if (record.wants(Check::hanging_node))
    record[Check::hanging_node] = hanging_nodes(mesh, boundary, contacts.conformity.hanging);
  if (record.wants(Check::crossed_diagonal))
    record[Check::crossed_diagonal] = crossed_diagonals(mesh, boundary, contacts.conformity.crossed);
  if (!record.wants(Check::near_contact)) return;
  const auto& pairs = contacts.near_pairs;
  const auto distance = [&near = contacts.near](const std::array<Index, 2>& pair) {
    return near.between_triangles(pair[0], pair[1]);
  };
  CheckResult& result = record.result(Check::near_contact);
  for (const auto& pair : pairs) {
    const double apart = distance(pair);
    if (result.measured && *result.measured <= apart) continue;
    result.measured = apart;
    result.allowed = contacts.near.room(pair[0], pair[1]);
  }
  record[Check::near_contact] = {
      .count = pairs.size(),
      .finding = [&mesh, &boundary, &pairs](std::size_t i) { return finding_of(mesh, boundary, pairs[i]); },
      .describe =
          [&pairs, distance](std::size_t i, Finding& finding) {
            finding.what = fmt::format("these boundary faces do not touch, but are only {:.3g} apart",
                                       distance(pairs[i]));
          },
      .cause =
          [&boundary, &pairs, &contacts](std::size_t i) {
            return contacts.conformity.cause_of_pair(boundary, pairs[i][0], pairs[i][1]);
          }};
}

}  // namespace tetproof::verify
