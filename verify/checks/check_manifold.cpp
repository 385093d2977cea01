// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that the boundary is a manifold: two faces at every edge, one fan at every vertex.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "io/bytes/words.hpp"
#include "verify/checks/evidence.hpp"

namespace tetproof::verify {
namespace {

// The boundary faces at each of `vertices` (ascending), in order.
std::vector<std::vector<FaceId>> faces_at(const Boundary& boundary, const std::vector<Index>& vertices) {
  std::vector<std::vector<FaceId>> faces(vertices.size());
  for (std::size_t f = 0; f < boundary.faces.size() && !vertices.empty(); ++f)
    for (const Index v : boundary.triangles[f])
      if (const auto at = std::lower_bound(vertices.begin(), vertices.end(), v);
          at != vertices.end() && *at == v)
        faces[at - vertices.begin()].push_back(boundary.faces[f]);
  return faces;
}

// For each of `vertices` (ascending) the cause of the first face there that lacks its partner.
std::vector<std::optional<Cause>> first_causes(const Boundary& boundary, const Conformity& conformity,
                                               const std::vector<Index>& vertices) {
  std::vector<std::optional<Cause>> causes(vertices.size());
  for (std::size_t f = 0; f < conformity.gap_of_face.size() && !vertices.empty(); ++f) {
    if (conformity.gap_of_face[f] < 0) continue;
    for (const Index v : boundary.triangles[f])
      if (const auto at = std::lower_bound(vertices.begin(), vertices.end(), v);
          at != vertices.end() && *at == v && !causes[at - vertices.begin()])
        causes[at - vertices.begin()] = conformity.cause_of_face(static_cast<Index>(f));
  }
  return causes;
}

Finding edge_finding(const Boundary& boundary, const std::vector<Side>& sides) {
  const auto [a, b] = std::minmax({from(boundary.triangles, sides[0]), to(boundary.triangles, sides[0])});
  Finding finding{.vertices = {a, b}};
  for (const Side s : sides) {
    finding.faces.push_back(boundary.triangles[s / 3]);
    finding.tets.push_back(tet_of(boundary.faces[s / 3]));
  }
  return finding;
}

// The first cause of a face at the edge that lacks its partner, if at most two faces have theirs.
std::optional<Cause> cause_at_edge(const Conformity& conformity, const std::vector<Side>& sides) {
  std::optional<Cause> first;
  std::size_t others = 0;
  for (const Side s : sides) {
    const auto cause = conformity.cause_of_face(s / 3);
    if (!cause)
      ++others;
    else if (!first)
      first = cause;
  }
  return others <= 2 ? first : std::nullopt;
}

// Drops the places at unjudged elements, and counts them as not judged.
template <class Place, class At>
void leave_unjudged(std::vector<Place>& places, const char* what, const At& at, Record& record) {
  if (const auto count = std::erase_if(places, at))
    record.report.not_judged.push_back(
        {what, static_cast<std::int64_t>(count),
         "they are at elements that are not judged, and may be inside the mesh"});
}

}  // namespace

void check_manifold(const TetMesh& mesh, const Boundary& boundary, const Conformity& conformity,
                    const UnjudgedPlaces& unjudged, Record& record) {
  if (record.wants(Check::boundary_nonmanifold_edge)) {
    std::vector<std::vector<Side>> edges = boundary.edges.nonmanifold;
    leave_unjudged(
        edges, "non-manifold edges",
        [&](const std::vector<Side>& sides) {
          return unjudged.at(from(boundary.triangles, sides[0])) &&
                 unjudged.at(to(boundary.triangles, sides[0]));
        },
        record);
    record[Check::boundary_nonmanifold_edge] = {
        .count = edges.size(),
        .finding = [&boundary, edges](std::size_t i) { return edge_finding(boundary, edges[i]); },
        .describe =
            [](std::size_t, Finding& finding) {
              finding.what = fmt::format("this edge has {}, expected two",
                                         io::counted(finding.faces.size(), "boundary faces"));
            },
        .cause = [&conformity, edges](std::size_t i) { return cause_at_edge(conformity, edges[i]); }};
  }
  if (record.wants(Check::boundary_nonmanifold_vertex)) {
    std::vector<Index> pinched = boundary.pinched;
    leave_unjudged(
        pinched, "non-manifold vertices", [&](Index v) { return unjudged.at(v); }, record);
    record[Check::boundary_nonmanifold_vertex] = {
        .count = pinched.size(),
        .finding = [pinched](std::size_t i) { return Finding{.vertices = {pinched[i]}}; },
        .describe =
            [&mesh, &boundary, faces = faces_at(boundary, pinched)](std::size_t i, Finding& finding) {
              for (const FaceId face : faces[i]) finding.tets.push_back(tet_of(face));
              std::sort(finding.tets.begin(), finding.tets.end());
              finding.tets.erase(std::unique(finding.tets.begin(), finding.tets.end()), finding.tets.end());
              const auto [first, last] =
                  std::equal_range(boundary.groups.vertices_of_fans.begin(),
                                   boundary.groups.vertices_of_fans.end(), finding.vertices[0]);
              finding.point = mesh.points[finding.vertices[0]];
              finding.what =
                  fmt::format("the boundary faces at this vertex form {} fans, expected one", last - first);
            },
        .cause = [first = first_causes(boundary, conformity, pinched)](std::size_t i) { return first[i]; }};
  }
}

}  // namespace tetproof::verify
