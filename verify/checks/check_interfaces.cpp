// SPDX-License-Identifier: GPL-3.0-or-later
// Checks for parts that touch along faces that do not match.
#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "io/bytes/words.hpp"
#include "verify/checks/evidence.hpp"
#include "verify/triangles/winding.hpp"

namespace tetproof::verify {
namespace {

// Of the faces with the mesh on their outer side those that are covered by parts that do not touch their own
// part: parts that touch are known not to overlap.
void leave_out_touching(const TetMesh& mesh, const Boundary& boundary, ContactEvidence& contacts) {
  std::vector<Index> starts;
  for (const CoveredFace& covered : contacts.covered) starts.push_back(covered.face);
  const auto crossings = cast_rays(mesh.points, boundary.triangles, starts);
  std::vector<CoveredFace> left;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const Index own = tet_of(boundary.faces[starts[i]]);
    int winding = 0;
    for (const Crossing& c : crossings[i])
      if (static_cast<std::size_t>(c.triangle) >= boundary.faces.size() ||
          !contacts.interfaces.between(own, tet_of(boundary.faces[c.triangle])))
        winding += c.sign;
    if (winding != 0) left.push_back({starts[i], winding});
  }
  contacts.covered = std::move(left);
}

// The faces of both parts, a pair with a common area first.
Finding finding_of(const TetMesh& mesh, const Boundary& boundary, const TouchingParts& touching) {
  Finding finding;
  std::vector<Index> seen;
  for (const auto& pair : touching.faces) seen.insert(seen.end(), pair.begin(), pair.end());
  std::sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  const auto add = [&](Index f) {
    const auto at = std::lower_bound(seen.begin(), seen.end(), f);
    if (at == seen.end() || *at != f) return;
    seen.erase(at);
    const FaceId face = boundary.faces[static_cast<std::size_t>(f)];
    finding.faces.push_back(vertices_of(mesh, face));
    finding.tets.push_back(tet_of(face));
  };
  for (const Index f : touching.faces[0]) add(f);
  for (const Index f : std::vector<Index>(seen)) {
    if (finding.faces.size() >= most_faces_of_an_interface) break;
    add(f);
  }
  return finding;
}

}  // namespace

void examine_interfaces(const TetMesh& mesh, const PointEvidence& points,
                        const TetrahedraEvidence& tetrahedra, const Cracks& cracks, const Boundary& boundary,
                        ContactEvidence& contacts, Record& record) {
  if (!record.wants(Check::non_conforming_interface) || contacts.meetings.pairs.empty()) return;
  std::vector<Index> not_positive = tetrahedra.signs.negative;
  not_positive.insert(not_positive.end(), tetrahedra.signs.flat.begin(), tetrahedra.signs.flat.end());
  contacts.interfaces = find_touching_parts(
      mesh, points.excluded, boundary, contacts.meetings.pairs,
      [&](Index s, Index t) { return contacts.conformity.cause_of_pair(boundary, s, t).has_value(); },
      cracks.pairs, not_positive);
  if (contacts.interfaces.given_up)
    record.could_not_run({Check::non_conforming_interface},
                         fmt::format("more than {} pairs of tetrahedra of parts that may touch were to be "
                                     "compared",
                                     most_compared_tets));
  if (!contacts.interfaces.touching.empty()) leave_out_touching(mesh, boundary, contacts);
}

void check_interfaces(const TetMesh& mesh, const PointEvidence& points, const Boundary& boundary,
                      const ContactEvidence& contacts, Record& record) {
  const Interfaces& interfaces = contacts.interfaces;
  if (interfaces.touching.empty()) return;
  record[Check::non_conforming_interface] = {
      .count = interfaces.touching.size(),
      .finding = [&mesh, &boundary,
                  &interfaces](std::size_t i) { return finding_of(mesh, boundary, interfaces.touching[i]); },
      .describe =
          [&boundary, &interfaces](std::size_t i, Finding& finding) {
            const auto& [parts, pairs] = interfaces.touching[i];
            std::array<std::vector<Index>, 2> sides;
            for (const auto& pair : pairs)
              for (const Index f : pair)
                sides[interfaces.part_of_tet[tet_of(boundary.faces[f])] == parts[1]].push_back(f);
            for (std::vector<Index>& side : sides) {
              std::sort(side.begin(), side.end());
              side.erase(std::unique(side.begin(), side.end()), side.end());
            }
            finding.what = fmt::format(
                "two parts of the mesh touch here and do not overlap: {} of one part lie on {} of the "
                "other, and they do not match",
                io::counted(sides[0].size(), "faces"), sides[1].size());
          }};

  const auto cause_between = [&boundary, &interfaces](Index s, Index t) -> std::optional<Cause> {
    const auto found = interfaces.between(tet_of(boundary.faces[s]), tet_of(boundary.faces[t]));
    return found ? std::optional(Cause{Check::non_conforming_interface, *found}) : std::nullopt;
  };
  record[Check::boundary_self_intersection].add_cause(
      [cause_between, &pairs = contacts.meetings.pairs](std::size_t i) {
        return cause_between(pairs[i][0], pairs[i][1]);
      });
  record[Check::near_contact].add_cause([cause_between, &pairs = contacts.near_pairs](std::size_t i) {
    return cause_between(pairs[i][0], pairs[i][1]);
  });

  // Points in one place, of two parts that touch.
  constexpr Index none = -1;
  std::vector<Index> tet_at(mesh.points.size(), none);
  for (const FaceId face : boundary.faces)
    for (const Index v : vertices_of(mesh, face)) tet_at[static_cast<std::size_t>(v)] = tet_of(face);
  record[Check::duplicate_point].add_cause(
      [&points, &interfaces, tet_at = std::move(tet_at)](std::size_t i) -> std::optional<Cause> {
        const std::vector<Index>& same = points.same_place[i];
        std::optional<std::size_t> found;
        for (const Index v : same) {
          if (tet_at[v] == none) return std::nullopt;
          if (v == same[0]) continue;
          found = interfaces.between(tet_at[same[0]], tet_at[v]);
          if (!found) return std::nullopt;
        }
        return found ? std::optional(Cause{Check::non_conforming_interface, *found}) : std::nullopt;
      });
}

}  // namespace tetproof::verify
