// SPDX-License-Identifier: GPL-3.0-or-later
// The checks of the boundary: what it encloses, how it hangs together, whether it meets itself, and whether
// its parts are nested rightly.
#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "verify/checks/judgement.hpp"
#include "verify/mesh/mesh_volumes.hpp"
#include "verify/mesh/witness.hpp"
#include "verify/triangles/winding.hpp"

namespace tetproof::verify {
namespace {

constexpr std::size_t most_faces_shown = 24;

// 1 for the sheets along whose edges not as many faces run in the one direction as in the other: where faces
// do not match, one may be wound the wrong way, and its volume then depends on the origin.
std::vector<std::uint8_t> unbalanced_sheets(const Boundary& boundary) {
  std::vector<std::uint8_t> unbalanced(boundary.sheets.sheets.size(), 0);
  if (boundary.triangles.size() == boundary.faces.size()) return unbalanced;
  std::vector<std::array<Index, 4>> sides;  // sheet, lower and higher vertex, direction
  for (std::size_t f = 0; f < boundary.faces.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const Index a = boundary.triangles[f][k], b = boundary.triangles[f][(k + 1) % 3];
      sides.push_back({boundary.sheets.of_triangle[f], std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0, k; i < sides.size(); i = k) {
    Index sum = 0;
    for (k = i; k < sides.size() && std::equal(sides[i].begin(), sides[i].begin() + 3, sides[k].begin()); ++k)
      sum += sides[k][3];
    if (sum != 0 && sides[i][0] >= 0) unbalanced[static_cast<std::size_t>(sides[i][0])] = 1;
  }
  return unbalanced;
}

// Closed sheets of negative volume, the smallest first.
std::vector<Index> cavities(const Judgement& j, const MeshVolumes& volumes) {
  const std::vector<std::uint8_t> unbalanced = unbalanced_sheets(j.boundary);
  std::vector<Index> found;
  for (std::size_t s = 0; s < j.boundary.sheets.sheets.size(); ++s)
    if (j.boundary.sheets.sheets[s].open_sides == 0 && !unbalanced[s] && volumes.sets.sign(s) < 0)
      found.push_back(static_cast<Index>(s));
  std::stable_sort(found.begin(), found.end(),
                   [&](Index a, Index b) { return volumes.sets.compare_size(a, b) < 0; });
  return found;
}

Suspects cavity_suspects(const Judgement& j, const MeshVolumes& volumes, std::vector<Index> found) {
  struct Hole {
    Sheet sheet;
    double volume;
    std::vector<FaceId> faces;
  };
  std::vector<Hole> holes;
  std::vector<Index> hole_of(j.boundary.sheets.sheets.size(), -1);
  for (const Index s : found) {
    hole_of[s] = static_cast<Index>(holes.size());
    holes.push_back({j.boundary.sheets.sheets[s], volumes.sets.volume(s), {}});
  }
  std::vector<std::vector<Index>> positions(holes.size());
  for (std::size_t f = 0; f < j.boundary.faces.size() && !holes.empty(); ++f)
    if (const Index hole = hole_of[j.boundary.sheets.of_triangle[f]]; hole >= 0) {
      holes[hole].faces.push_back(j.boundary.faces[f]);
      positions[hole].push_back(static_cast<Index>(f));
    }
  const std::size_t count = holes.size();
  return {count,
          [&mesh = j.mesh, holes](std::size_t i) {
            Finding finding;
            for (const FaceId face : holes[i].faces) {
              finding.faces.push_back(vertices_of(mesh, face));
              finding.tets.push_back(tet_of(face));
            }
            return finding;
          },
          [&mesh = j.mesh, holes](std::size_t i, Finding& finding) {
            const Hole& hole = holes[i];
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            for (const auto& face : finding.faces)
              for (const Index v : face) sum += mesh.points[v];
            finding.point = sum / (3.0 * static_cast<double>(finding.faces.size()));
            const bool one_tet = hole.sheet.triangles == 4 && hole.sheet.vertices == 4;
            finding.what = fmt::format("a cavity of {} faces and volume {:.6g}{}", hole.sheet.triangles,
                                       -hole.volume, one_tet ? ", as a missing tetrahedron leaves it" : "");
            if (finding.faces.size() > most_faces_shown)
              finding.faces.resize(most_faces_shown), finding.tets.resize(most_faces_shown);
          },
          0,
          [&j, positions](std::size_t i) -> std::optional<Cause> {
            // The slit that a hanging node or crossed diagonals left, all of whose faces lack their partner.
            std::optional<Cause> first;
            for (const Index f : positions[i]) {
              const auto cause = j.conformity.cause_of_face(f);
              if (!cause) return std::nullopt;
              if (!first || cause->suspect < first->suspect) first = cause;
            }
            return first;
          }};
}

// Boundary faces at every vertex of `vertices` (ascending), in order.
std::vector<std::vector<FaceId>> faces_at(const Boundary& boundary, const std::vector<Index>& vertices) {
  std::vector<std::vector<FaceId>> faces(vertices.size());
  for (std::size_t f = 0; f < boundary.faces.size() && !vertices.empty(); ++f)
    for (const Index v : boundary.triangles[f])
      if (const auto at = std::lower_bound(vertices.begin(), vertices.end(), v);
          at != vertices.end() && *at == v)
        faces[at - vertices.begin()].push_back(boundary.faces[f]);
  return faces;
}

// The first cause of a face without its partner at each of `vertices` (ascending).
std::vector<std::optional<Cause>> first_causes(const Judgement& j, const std::vector<Index>& vertices) {
  std::vector<std::optional<Cause>> causes(vertices.size());
  for (std::size_t f = 0; f < j.conformity.gap_of_face.size() && !vertices.empty(); ++f) {
    if (j.conformity.gap_of_face[f] < 0) continue;
    for (const Index v : j.boundary.triangles[f])
      if (const auto at = std::lower_bound(vertices.begin(), vertices.end(), v);
          at != vertices.end() && *at == v && !causes[at - vertices.begin()])
        causes[at - vertices.begin()] = j.conformity.cause_of_face(static_cast<Index>(f));
  }
  return causes;
}

void check_manifold(Judgement& j) {
  const Boundary& boundary = j.boundary;
  if (j.wants(Check::boundary_nonmanifold_edge))
    j[Check::boundary_nonmanifold_edge] = {
        boundary.edges.nonmanifold.size(),
        [&boundary](std::size_t i) {
          const std::vector<Side>& sides = boundary.edges.nonmanifold[i];
          const auto [a, b] =
              std::minmax({from(boundary.triangles, sides[0]), to(boundary.triangles, sides[0])});
          Finding finding{.vertices = {a, b}};
          for (const Side s : sides) {
            finding.faces.push_back(boundary.triangles[s / 3]);
            finding.tets.push_back(tet_of(boundary.faces[s / 3]));
          }
          return finding;
        },
        [](std::size_t, Finding& finding) {
          finding.what = fmt::format("this edge has {} boundary faces, expected two", finding.faces.size());
        },
        0,
        [&j](std::size_t i) -> std::optional<Cause> {
          std::optional<Cause> first;
          std::size_t others = 0;
          for (const Side s : j.boundary.edges.nonmanifold[i]) {
            const auto cause = j.conformity.cause_of_face(s / 3);
            if (!cause)
              ++others;
            else if (!first)
              first = cause;
          }
          return others <= 2 ? first : std::nullopt;
        }};
  if (j.wants(Check::boundary_nonmanifold_vertex)) {
    std::vector<std::vector<FaceId>> faces = faces_at(boundary, boundary.pinched);
    j[Check::boundary_nonmanifold_vertex] = {
        boundary.pinched.size(),
        [&boundary](std::size_t i) { return Finding{.vertices = {boundary.pinched[i]}}; },
        [&j, faces = std::move(faces)](std::size_t i, Finding& finding) {
          for (const FaceId face : faces[i]) finding.tets.push_back(tet_of(face));
          std::sort(finding.tets.begin(), finding.tets.end());
          finding.tets.erase(std::unique(finding.tets.begin(), finding.tets.end()), finding.tets.end());
          const auto [first, last] =
              std::equal_range(j.boundary.groups.vertices_of_fans.begin(),
                               j.boundary.groups.vertices_of_fans.end(), finding.vertices[0]);
          finding.point = j.mesh.points[finding.vertices[0]];
          finding.what =
              fmt::format("the boundary faces at this vertex form {} fans, expected one", last - first);
        },
        0, [&j, first = first_causes(j, boundary.pinched)](std::size_t i) { return first[i]; }};
  }
}

void check_self_intersection(Judgement& j) {
  if (!j.wants(Check::boundary_self_intersection)) return;
  const std::size_t kept = j.meetings.pairs.size();
  j[Check::boundary_self_intersection] = {
      kept,
      [&j](std::size_t i) {
        Finding finding;
        for (const Index f : j.meetings.pairs[i]) {
          finding.tets.push_back(tet_of(j.boundary.faces[f]));
          finding.faces.push_back(vertices_of(j.mesh, j.boundary.faces[f]));
        }
        return finding;
      },
      [&j](std::size_t, Finding& finding) {
        int common = 0;
        for (const Index v : finding.faces[0])
          common += std::count(finding.faces[1].begin(), finding.faces[1].end(), v);
        finding.what = common == 0   ? "these boundary faces meet and have no common vertex"
                       : common == 1 ? "these boundary faces meet in more than their common vertex"
                       : common == 2 ? "these boundary faces lie folded on each other at their common edge"
                                     : "these boundary faces have the same three vertices";
        if (const auto both =
                common_point(j.mesh.points, j.mesh.tets[finding.tets[0]], j.mesh.tets[finding.tets[1]])) {
          finding.what += "; the point is inside both tetrahedra";
          finding.point = both->point, finding.point_exact = both->exact;
        }
      },
      static_cast<std::size_t>(j.meetings.count) - kept,
      [&j](std::size_t i) {
        return j.conformity.cause_of_pair(j.boundary, j.meetings.pairs[i][0], j.meetings.pairs[i][1]);
      }};
}

// A face with the mesh on its outer side, and how often.
struct Covered {
  Index face;
  int winding;
};

// One face of each group that has an outer side and that is covered there.
std::vector<Covered> covered_faces(const Judgement& j, const std::vector<std::uint8_t>& degenerate) {
  if (!j.wants(Check::overlap) || j.meetings.more) return {};
  const Boundary& boundary = j.boundary;
  std::vector<Index> start(boundary.groups.sheets.size(), -1), starts;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    Index& first = start[boundary.groups.of_triangle[f]];
    if (first < 0 && !degenerate[f]) first = static_cast<Index>(f);
  }
  std::copy_if(start.begin(), start.end(), std::back_inserter(starts), [](Index f) { return f >= 0; });
  const auto crossings = cast_rays(j.mesh.points, boundary.triangles, starts);
  std::vector<Covered> covered;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    int winding = 0;
    for (const Crossing& c : crossings[i]) winding += c.sign;
    if (winding != 0) covered.push_back({starts[i], winding});
  }
  return covered;
}

// Where too much meets for each part's nesting to be asked: the tetrahedra of some pairs that meet.
void check_overlap_of_some(Judgement& j) {
  constexpr std::size_t most_tried = 1000;
  std::vector<Finding> shared;
  for (std::size_t i = 0; i < j.meetings.pairs.size() && i < most_tried && shared.size() < most_findings;
       ++i) {
    Finding finding;
    for (const Index f : j.meetings.pairs[i]) {
      finding.tets.push_back(tet_of(j.boundary.faces[f]));
      finding.faces.push_back(vertices_of(j.mesh, j.boundary.faces[f]));
    }
    const auto both = common_point(j.mesh.points, j.mesh.tets[finding.tets[0]], j.mesh.tets[finding.tets[1]]);
    if (!both) continue;
    finding.what = "these tetrahedra overlap; the point is inside both";
    finding.point = both->point, finding.point_exact = both->exact;
    shared.push_back(std::move(finding));
  }
  if (shared.empty()) j.skip({Check::overlap});
  const std::size_t count = shared.size();
  j[Check::overlap] = {count, [shared = std::move(shared)](std::size_t i) { return shared[i]; },
                       [](std::size_t, Finding&) {}};
}

void check_overlap(Judgement& j, const std::vector<Covered>& covered) {
  if (!j.wants(Check::overlap)) return;
  if (j.meetings.more) return check_overlap_of_some(j);
  const Boundary& boundary = j.boundary;
  // Of each group a vertex of its first face that meets another: its overlap follows from that.
  std::vector<Index> crossed(boundary.groups.sheets.size(), -1);
  if (j.wants(Check::boundary_self_intersection))
    for (const auto& pair : j.meetings.pairs)
      for (const Index f : pair)
        if (Index& vertex = crossed[boundary.groups.of_triangle[f]]; vertex < 0)
          vertex = boundary.triangles[f][0];
  const std::size_t folded = j.folded.size();
  j[Check::overlap] = {
      folded + covered.size(),
      [&j, covered, crossed, folded](std::size_t i) {
        if (i < folded)
          return Finding{.tets = {tet_of(j.folded[i][0]), tet_of(j.folded[i][1])},
                         .faces = {vertices_of(j.mesh, j.folded[i][0]), vertices_of(j.mesh, j.folded[i][1])}};
        const Index face = covered[i - folded].face;
        Finding finding{.tets = {tet_of(j.boundary.faces[face])},
                        .faces = {vertices_of(j.mesh, j.boundary.faces[face])}};
        if (const Index vertex = crossed[j.boundary.groups.of_triangle[face]]; vertex >= 0)
          finding.vertices.push_back(vertex);  // so that it follows from that intersection
        return finding;
      },
      [&j, covered, folded](std::size_t i, Finding& finding) {
        finding.vertices.clear();
        const Triangle face = finding.faces[0];
        if (i >= folded) {
          // Right behind the face is its own tetrahedron and, as its outer side is covered too, another one.
          if (const Index other = tet_inside(j.mesh, j.excluded, face, finding.tets[0]); other >= 0)
            finding.tets.push_back(other);
          finding.what =
              fmt::format("the mesh lies on the outer side of this boundary face (winding number {})",
                          covered[i - folded].winding);
        } else {
          finding.what = "these faces lie in the same place, and the tetrahedra on one side of it";
        }
        if (finding.tets.size() < 2) return;
        const auto both =
            common_point(j.mesh.points, j.mesh.tets[finding.tets[0]], j.mesh.tets[finding.tets[1]]);
        if (!both) return;
        finding.what += "; the point is inside both tetrahedra";
        finding.point = both->point, finding.point_exact = both->exact;
      },
      0,
      [&j, covered, folded](std::size_t i) -> std::optional<Cause> {
        if (i < folded) return std::nullopt;
        const auto [face, winding] = covered[i - folded];
        if (const auto cause = j.conformity.cause_of_face(face)) return cause;
        // Only what is wound the wrong way covers a place less than not at all.
        for (const Check check : {Check::inverted, Check::face_orientation})
          if (winding < 0 && j[check].count > 0) return Cause{check, 0};
        return std::nullopt;
      }};
}

}  // namespace

void check_boundary(Judgement& j, const MeshVolumes& volumes, std::size_t right_cavities) {
  const Boundary& boundary = j.boundary;
  const std::vector<Index> holes = cavities(j, volumes);
  const Degenerate degenerate = degenerate_triangles(j.mesh.points, boundary.boundary_triangles());
  const Near near(j.mesh.points, boundary.boundary_triangles());
  find_meetings(j, near, degenerate.triangles);
  const std::vector<Covered> covered = covered_faces(j, degenerate.triangles);
  std::vector<Index> covered_positions;
  for (const Covered& c : covered) covered_positions.push_back(c.face);
  check_conformity(j, near, covered_positions);
  if (j.wants(Check::cavity)) {
    std::vector<Index> wrong = holes;
    wrong.resize(holes.size() - std::min(holes.size(), right_cavities));
    j[Check::cavity] = cavity_suspects(j, volumes, std::move(wrong));
  }
  check_manifold(j);
  check_self_intersection(j);
  check_overlap(j, covered);
}

}  // namespace tetproof::verify
