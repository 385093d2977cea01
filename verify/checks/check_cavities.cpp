// SPDX-License-Identifier: GPL-3.0-or-later
// Checks for cavities: closed parts of the boundary that enclose a hole in the mesh.
#include <fmt/core.h>

#include <algorithm>

#include "verify/checks/evidence.hpp"
#include "verify/checks/make_finding.hpp"

namespace tetproof::verify {
namespace {

constexpr std::size_t most_faces_shown = 24;

// Marks the sheets that have an edge along which more faces run in one direction than in the other. Where
// faces do not match, one of them may be wound the wrong way; then the sheet's volume depends on the origin.
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
std::vector<Index> cavities(const Boundary& boundary, const MeshVolumes& volumes) {
  const std::vector<std::uint8_t> unbalanced = unbalanced_sheets(boundary);
  std::vector<Index> found;
  for (std::size_t s = 0; s < boundary.sheets.sheets.size(); ++s)
    if (boundary.sheets.sheets[s].open_sides == 0 && !unbalanced[s] && volumes.sets.sign(s) < 0)
      found.push_back(static_cast<Index>(s));
  std::stable_sort(found.begin(), found.end(),
                   [&](Index a, Index b) { return volumes.sets.compare_size(a, b) < 0; });
  return found;
}

// Drops the cavities with a vertex at an unjudged element, and counts them as not judged.
void leave_unjudged(const Boundary& boundary, const UnjudgedPlaces& unjudged, std::vector<Index>& sheets,
                    Record& record) {
  if (!unjudged.any() || sheets.empty()) return;
  std::vector<std::uint8_t> touched(boundary.sheets.sheets.size(), 0);
  for (std::size_t f = 0; f < boundary.faces.size(); ++f)
    for (const Index v : boundary.triangles[f])
      if (const Index sheet = boundary.sheets.of_triangle[f]; sheet >= 0 && unjudged.at(v))
        touched[sheet] = 1;
  if (const auto count = std::erase_if(sheets, [&](Index sheet) { return touched[sheet] != 0; }))
    record.report.not_judged.push_back(
        {"cavities", static_cast<std::int64_t>(count), "elements that are not judged may fill them"});
}

struct Hole {
  Sheet sheet;
  double volume;             // negative
  std::vector<Index> faces;  // positions in `Boundary::faces`
};

std::vector<Hole> holes_of(const Boundary& boundary, const MeshVolumes& volumes,
                           const std::vector<Index>& sheets) {
  std::vector<Hole> holes;
  std::vector<Index> hole_of(boundary.sheets.sheets.size(), -1);
  for (const Index s : sheets) {
    hole_of[s] = static_cast<Index>(holes.size());
    holes.push_back({boundary.sheets.sheets[s], volumes.sets.volume(s), {}});
  }
  for (std::size_t f = 0; f < boundary.faces.size() && !holes.empty(); ++f)
    if (const Index hole = hole_of[boundary.sheets.of_triangle[f]]; hole >= 0)
      holes[hole].faces.push_back(static_cast<Index>(f));
  return holes;
}

void describe(const TetMesh& mesh, const Hole& hole, Finding& finding) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& face : finding.faces)
    for (const Index v : face) sum += mesh.points[v];
  finding.point = sum / (3.0 * static_cast<double>(finding.faces.size()));
  const bool one_tet = hole.sheet.triangles == 4 && hole.sheet.vertices == 4;
  finding.what = fmt::format("a cavity of {} faces and volume {:.6g}{}", hole.sheet.triangles, -hole.volume,
                             one_tet ? ", as a missing tetrahedron leaves it" : "");
  if (finding.faces.size() > most_faces_shown)
    finding.faces.resize(most_faces_shown), finding.tets.resize(most_faces_shown);
}

// The slit that a hanging node or crossed diagonals left: then every face of the hole lacks its partner.
std::optional<Cause> cause_of(const Hole& hole, const Conformity& conformity) {
  std::optional<Cause> first;
  for (const Index f : hole.faces) {
    const auto cause = conformity.cause_of_face(f);
    if (!cause) return std::nullopt;
    if (!first || cause->suspect < first->suspect) first = cause;
  }
  return first;
}

}  // namespace

void check_cavities(const TetMesh& mesh, const Boundary& boundary, const Conformity& conformity,
                    const MeshVolumes& volumes, std::size_t right_cavities, const UnjudgedPlaces& unjudged,
                    Record& record) {
  if (!record.wants(Check::cavity)) return;
  std::vector<Index> wrong = cavities(boundary, volumes);
  leave_unjudged(boundary, unjudged, wrong, record);
  wrong.resize(wrong.size() - std::min(wrong.size(), right_cavities));
  const std::vector<Hole> holes = holes_of(boundary, volumes, wrong);
  record[Check::cavity] = {
      .count = holes.size(),
      .finding =
          [&mesh, &boundary, holes](std::size_t i) {
            std::vector<FaceId> faces;
            for (const Index f : holes[i].faces) faces.push_back(boundary.faces[f]);
            return finding_at(mesh, faces);
          },
      .describe = [&mesh, holes](std::size_t i, Finding& finding) { describe(mesh, holes[i], finding); },
      .cause = [&conformity, holes](std::size_t i) { return cause_of(holes[i], conformity); }};
}

}  // namespace tetproof::verify
