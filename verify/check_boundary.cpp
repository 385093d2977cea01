// SPDX-License-Identifier: GPL-3.0-or-later
// The checks of the boundary: what it encloses, how it hangs together, whether it meets itself, and whether
// its parts are nested rightly.
#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "verify/intersections.hpp"
#include "verify/judgement.hpp"
#include "verify/mesh_volumes.hpp"
#include "verify/winding.hpp"

namespace tetproof::verify {
namespace {

constexpr std::size_t most_faces_shown = 24;

// Closed sheets of negative volume, the smallest first, but for the largest `right` of them.
std::vector<Index> cavities(const Judgement& j, const MeshVolumes& volumes) {
  std::vector<Index> found;
  for (std::size_t s = 0; s < j.boundary.sheets.sheets.size(); ++s)
    if (j.boundary.sheets.sheets[s].open_sides == 0 && volumes.sets.sign(s) < 0)
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
  for (std::size_t f = 0; f < j.boundary.faces.size() && !holes.empty(); ++f)
    if (const Index hole = hole_of[j.boundary.sheets.of_triangle[f]]; hole >= 0)
      holes[hole].faces.push_back(j.boundary.faces[f]);
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
        }};
  }
}

// Returns, for each group, a vertex of its first face that meets another, or -1.
std::vector<Index> check_self_intersection(Judgement& j, const std::vector<std::uint8_t>& degenerate) {
  const Boundary& boundary = j.boundary;
  std::vector<Index> crossed(boundary.groups.sheets.size(), -1);
  if (!j.wants(Check::boundary_self_intersection)) return crossed;
  Intersections meetings = self_intersections(j.mesh.points, boundary.boundary_triangles(), degenerate);
  for (const auto& pair : meetings.pairs)
    for (const Index f : pair)
      if (Index& vertex = crossed[boundary.groups.of_triangle[f]]; vertex < 0)
        vertex = boundary.triangles[f][0];
  const std::size_t kept = meetings.pairs.size();
  j[Check::boundary_self_intersection] = {
      kept,
      [&boundary, pairs = std::move(meetings.pairs)](std::size_t i) {
        Finding finding;
        for (const Index f : pairs[i]) {
          finding.tets.push_back(tet_of(boundary.faces[f]));
          finding.faces.push_back(boundary.triangles[f]);
        }
        return finding;
      },
      [](std::size_t, Finding& finding) {
        int common = 0;
        for (const Index v : finding.faces[0])
          common += std::count(finding.faces[1].begin(), finding.faces[1].end(), v);
        finding.what = common == 0   ? "these boundary faces meet and have no common vertex"
                       : common == 1 ? "these boundary faces meet in more than their common vertex"
                                     : "these boundary faces lie folded on each other at their common edge";
      },
      static_cast<std::size_t>(meetings.count) - kept};
  return crossed;
}

void check_overlap(Judgement& j, const std::vector<std::uint8_t>& degenerate,
                   const std::vector<Index>& crossed) {
  if (!j.wants(Check::overlap)) return;
  const Boundary& boundary = j.boundary;
  // One face of each group that has an outer side.
  std::vector<Index> start(boundary.groups.sheets.size(), -1), starts;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    Index& first = start[boundary.groups.of_triangle[f]];
    if (first < 0 && !degenerate[f]) first = static_cast<Index>(f);
  }
  std::copy_if(start.begin(), start.end(), std::back_inserter(starts), [](Index f) { return f >= 0; });
  const auto crossings = cast_rays(j.mesh.points, boundary.triangles, starts);
  struct Covered {
    Index face, crossed;
    int winding;
  };
  std::vector<Covered> covered;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    int winding = 0;
    for (const Crossing& c : crossings[i]) winding += c.sign;
    if (winding != 0)
      covered.push_back({starts[i], crossed[boundary.groups.of_triangle[starts[i]]], winding});
  }
  const std::size_t count = covered.size();
  j[Check::overlap] = {
      count,
      [&boundary, covered](std::size_t i) {
        const Covered& c = covered[i];
        Finding finding{.tets = {tet_of(boundary.faces[c.face])}, .faces = {boundary.triangles[c.face]}};
        if (c.crossed >= 0)
          finding.vertices.push_back(c.crossed);  // so that it follows from that intersection
        return finding;
      },
      [&j, covered](std::size_t i, Finding& finding) {
        const Triangle& face = finding.faces[0];
        finding.vertices.clear();
        finding.point = (j.mesh.points[face[0]] + j.mesh.points[face[1]] + j.mesh.points[face[2]]) / 3;
        finding.point_exact = exact_centroid(j.mesh.points, face);
        const Index other = tet_outside(j.mesh, j.excluded, face);
        if (other >= 0) finding.tets.push_back(other);
        finding.what = fmt::format("{} on the outer side of this boundary face{} (winding number {})",
                                   other >= 0 ? "the second tetrahedron lies" : "the mesh lies",
                                   other >= 0 ? " of the first" : "", covered[i].winding);
      }};
}

}  // namespace

void check_boundary(Judgement& j, const MeshVolumes& volumes, std::size_t right_cavities) {
  const Boundary& boundary = j.boundary;
  const std::vector<Index> holes = cavities(j, volumes);
  if (boundary.closed && boundary.triangles.size() == boundary.faces.size()) {
    Shape& shape = j.report.mesh;
    shape.components = static_cast<std::int64_t>(boundary.sheets.sheets.size());
    shape.cavities = static_cast<std::int64_t>(holes.size());
    shape.genus = 0;
    for (const Sheet& sheet : boundary.sheets.sheets) {
      shape.genus_per_component.push_back(sheet.genus());
      *shape.genus += sheet.genus();
    }
  }
  if (j.wants(Check::cavity)) {
    std::vector<Index> wrong = holes;
    wrong.resize(holes.size() - std::min(holes.size(), right_cavities));
    j[Check::cavity] = cavity_suspects(j, volumes, std::move(wrong));
  }
  check_manifold(j);
  const Degenerate degenerate = degenerate_triangles(j.mesh.points, boundary.boundary_triangles());
  check_overlap(j, degenerate.triangles, check_self_intersection(j, degenerate.triangles));
}

}  // namespace tetproof::verify
