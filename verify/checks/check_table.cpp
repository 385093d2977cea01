// SPDX-License-Identifier: GPL-3.0-or-later
// The table of checks: the one place that knows ids, severities and what the certificate needs.
#include <fmt/core.h>

#include "io/error.hpp"
#include "verify/report.hpp"

namespace tetproof::verify {
namespace {

constexpr bool needed = true, not_needed = false, alone = false, with_surface = true;

// clang-format off
constexpr std::array<CheckInfo, check_count> table{{
  {Check::index_range, "index-range", "every tetrahedron names points that exist", "exact", Severity::fail, needed, alone},
  {Check::finite_coordinates, "finite-coordinates", "every point that a tetrahedron uses has finite coordinates", "exact", Severity::fail, needed, alone},
  {Check::repeated_vertex, "repeated-vertex", "no tetrahedron names a point twice", "exact", Severity::fail, needed, alone},
  {Check::duplicate_point, "duplicate-point", "no two points have equal coordinates", "exact", Severity::warning, not_needed, alone},
  {Check::unused_point, "unused-point", "every point belongs to a tetrahedron", "exact", Severity::warning, not_needed, alone},
  {Check::duplicate_tet, "duplicate-tet", "no two tetrahedra have the same four vertices", "exact", Severity::fail, needed, alone},
  {Check::inverted, "inverted", "no tetrahedron has negative orientation", "exact", Severity::fail, needed, alone},
  {Check::flat, "flat", "no tetrahedron has its four vertices in one plane", "exact", Severity::fail, needed, alone},
  {Check::face_shared_thrice, "face-shared-thrice", "every face belongs to one or two tetrahedra", "exact", Severity::fail, needed, alone},
  {Check::face_orientation, "face-orientation", "the two tetrahedra of a face lie on opposite sides of it, by the order of their vertices", "exact", Severity::fail, needed, alone},
  {Check::hanging_node, "hanging-node", "no face lacks its partner for a node on it: no boundary faces cover the same place from opposite sides once their edges are cut at the nodes within 1e-12 of the box diagonal of them (or four units in the last place of the largest coordinate), though rounding left a slit or an overlap", "which faces lie opposite: exact; what lies within 1e-12: in doubles, off by some 1e-15 of the diagonal", Severity::fail, not_needed, alone},
  {Check::crossed_diagonal, "crossed-diagonal", "no quadrilateral is cut along one diagonal on its one side and along the other on its other side: flat within 1e-12 of the box diagonal, or bent so that the tetrahedra overlap", "as hanging-node; the overlap: exact", Severity::fail, not_needed, alone},
  {Check::crack, "crack", "no two faces lie in the same place on opposite sides, their vertices equal in coordinates and not in number; what follows below is judged with cracks closed", "exact", Severity::fail, needed, alone},
  {Check::near_contact, "near-contact", "no two boundary faces without a common vertex are closer than 1e-12 of the box diagonal (or four units in the last place of the largest coordinate) without touching, but where they hang together by edges as short", "in doubles, off by some 1e-15 of the diagonal", Severity::warning, not_needed, alone},
  {Check::cavity, "cavity", "the boundary encloses no cavity, or as many as the surface does: a missing inner tetrahedron leaves one", "exact", Severity::topology, not_needed, alone},
  {Check::boundary_nonmanifold_edge, "boundary-nonmanifold-edge", "every edge of the boundary has two boundary faces", "exact", Severity::topology, not_needed, alone},
  {Check::boundary_nonmanifold_vertex, "boundary-nonmanifold-vertex", "the boundary faces at every vertex form one fan", "exact", Severity::topology, not_needed, alone},
  {Check::boundary_self_intersection, "boundary-self-intersection", "two boundary faces meet in their common vertices and edges only", "exact", Severity::fail, needed, alone},
  {Check::overlap, "overlap", "no part of the boundary has the mesh on its outer side: with the checks above, no two tetrahedra overlap; else two that do and a rational point strictly inside both", "exact", Severity::fail, needed, alone},
  {Check::missing_region, "missing-region", "no region of the solid, deeper than fidelity, lacks the mesh: voxels whose centres are inside the surface, in no tetrahedron, and farther from the mesh than allowed. A point of it, its volume, the nearest face", "inside and in no tetrahedron: exact; the volume: by voxels, off by at most what the finding says; what holds no voxel's centre is not seen", Severity::fail, not_needed, with_surface},
  {Check::excess_region, "excess-region", "no region of the mesh is farther from the solid than fidelity allows: likewise. A point of it, its volume, the tetrahedra at that point", "as missing-region", Severity::fail, not_needed, with_surface},
  {Check::off_surface_vertex, "off-surface-vertex", "every vertex of the boundary is as near to the surface as fidelity allows", "each distance to some 1e-15 of the diagonal; what is inside that is undecided", Severity::fail, not_needed, with_surface},
  {Check::topology, "topology", "each component of the boundary is one of the surface's, and the other way round: the one that most of its faces are nearest to, with the same genus, a cavity or not, in as many others", "which lies near which: by up to 64 faces of each; all else exact", Severity::topology, not_needed, with_surface},
  {Check::volume_surface, "volume-surface", "the mesh's volume is the surface's, within fidelity x diagonal x area", "both exact, rounded once", Severity::fail, not_needed, with_surface},
  {Check::volume_voxel, "volume-voxel", "the mesh's volume is that of the surface's voxels, an independent account", "the volume of the voxels that the surface meets; a difference inside it is undecided", Severity::fail, not_needed, with_surface},
  {Check::mesh_to_surface, "mesh-to-surface", "no point of the boundary is farther from the surface than fidelity allows: the directed Hausdorff distance", "in an interval that is narrowed until it decides; where it cannot, some 1e-14 of the diagonal, undecided. Measured is its lower end", Severity::fail, not_needed, with_surface},
  {Check::surface_to_mesh, "surface-to-mesh", "no point of the surface is farther from the boundary than fidelity allows", "as mesh-to-surface", Severity::fail, not_needed, with_surface},
  {Check::normals, "normals", "no face of the boundary looks away from every triangle of the surface within fidelity of its centroid. Measured is the largest angle between a face's normal and that of the nearest triangle [degrees]", "which triangles are near: some 1e-15 of the diagonal; angles: some 1e-15 radians, but for needles, by their length over their height more; right angles pass", Severity::warning, not_needed, with_surface},
}};
// clang-format on

constexpr bool in_order() {
  for (int i = 0; i < check_count; ++i)
    if (static_cast<int>(table[i].check) != i) return false;
  return true;
}
static_assert(in_order(), "one row for each check, in the order of the enumeration");

}  // namespace

const CheckInfo& info(Check check) {
  return table[static_cast<std::size_t>(check)];
}

Check check_of_id(const std::string& id) {
  for (const CheckInfo& row : table)
    if (row.id == id) return row.check;
  throw InputError(fmt::format("unknown check '{}', expected an id of --list-checks", id));
}

std::string list_checks() {
  std::string text;
  for (const CheckInfo& row : table) {
    const char* severity = row.severity == Severity::fail      ? "fail"
                           : row.severity == Severity::warning ? "warning"
                                                               : "warning, fail under --strict-topology";
    text += fmt::format("{}\n    proves    {}\n    accuracy  {}\n    severity  {}{}{}\n", row.id, row.proves,
                        row.exact, severity, row.certificate ? "; the certificate needs it" : "",
                        row.needs_surface ? "; needs a surface" : "");
  }
  return text;
}

bool sound(const Report& report) {
  for (const CheckResult& result : report.checks)
    if (result.verdict == Verdict::fail) return false;
  return true;
}

}  // namespace tetproof::verify
