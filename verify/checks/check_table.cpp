// SPDX-License-Identifier: GPL-3.0-or-later
// The table of checks: ids, accuracy, severities, and whether the certificate needs them.
#include <fmt/core.h>

#include <iterator>

#include "io/error.hpp"
#include "verify/report.hpp"

namespace tetproof::verify {
namespace {

constexpr bool all_exact = true, measures = false;  // whether it rests on exact decisions alone
constexpr bool needed = true, not_needed = false;   // by the certificate
constexpr bool alone = false, with_surface = true;  // whether it needs a surface

// clang-format off
constexpr CheckInfo table[] = {
  {Check::index_range, "index-range", "every tetrahedron names points that exist, and the vertex numbers are not all shifted by one number", "exact", Severity::fail, all_exact, needed, alone},
  {Check::finite_coordinates, "finite-coordinates", "every point that a tetrahedron uses has finite coordinates", "exact", Severity::fail, all_exact, needed, alone},
  {Check::repeated_vertex, "repeated-vertex", "no tetrahedron names a point twice", "exact", Severity::fail, all_exact, needed, alone},
  {Check::duplicate_point, "duplicate-point", "no two points have equal coordinates", "exact", Severity::warning, all_exact, not_needed, alone},
  {Check::unused_point, "unused-point", "every point belongs to a tetrahedron", "exact", Severity::warning, all_exact, not_needed, alone},
  {Check::duplicate_tet, "duplicate-tet", "no two tetrahedra have the same four vertices, or four vertices with the same coordinates", "exact", Severity::fail, all_exact, needed, alone},
  {Check::inverted, "inverted", "no tetrahedron has negative orientation", "exact", Severity::fail, all_exact, needed, alone},
  {Check::flat, "flat", "no tetrahedron has its four vertices in one plane", "exact", Severity::fail, all_exact, needed, alone},
  {Check::face_shared_thrice, "face-shared-thrice", "every face belongs to one or two tetrahedra", "exact", Severity::fail, all_exact, needed, alone},
  {Check::face_orientation, "face-orientation", "by the order of their vertices, the two tetrahedra of a face lie on opposite sides of it", "exact", Severity::fail, all_exact, needed, alone},
  {Check::hanging_node, "hanging-node", "no face lacks its partner because a node lies on it: no boundary faces cover the same place from opposite sides once their edges are cut at the nodes near them, even if rounding left a slit or an overlap. Near: within 1e-12 of the face's longest edge (or four units in the last place of its largest coordinate), but no more than a thousandth of its tetrahedron's smallest height", "which faces lie opposite: exact; which nodes are near: in doubles, off by 1e-14 of the face's size; where that is too coarse, only nodes exactly on the face are near", Severity::fail, measures, not_needed, alone},
  {Check::crossed_diagonal, "crossed-diagonal", "no quadrilateral is cut along one diagonal on one side and along the other diagonal on the other side: a quadrilateral that is flat (its diagonals are near each other, as for hanging-node), or bent so that the tetrahedra overlap", "as hanging-node; the overlap: exact", Severity::fail, measures, not_needed, alone},
  {Check::crack, "crack", "no two faces lie in the same place, with tetrahedra on opposite sides and with vertices of equal coordinates but different numbers; the checks below are made with cracks closed", "exact", Severity::fail, all_exact, needed, alone},
  {Check::non_conforming_interface, "non-conforming-interface", "no two parts of the mesh, connected through faces, touch along faces that do not match: faces in one plane, with tetrahedra on opposite sides, that have an area in common, where no tetrahedra of the two parts overlap", "exact", Severity::fail, all_exact, needed, alone},
  {Check::near_contact, "near-contact", "no two boundary faces without a common vertex are near each other without touching, unless edges as short connect them. Near: as for hanging-node, by the larger measure of the two", "in doubles, off by 1e-14 of the faces' size", Severity::warning, measures, not_needed, alone},
  {Check::cavity, "cavity", "the boundary encloses no cavity, or as many as the surface does; a missing inner tetrahedron leaves a cavity", "exact", Severity::topology, all_exact, not_needed, alone},
  {Check::boundary_nonmanifold_edge, "boundary-nonmanifold-edge", "every edge of the boundary has two boundary faces", "exact", Severity::topology, all_exact, not_needed, alone},
  {Check::boundary_nonmanifold_vertex, "boundary-nonmanifold-vertex", "the boundary faces at every vertex form one fan", "exact", Severity::topology, all_exact, not_needed, alone},
  {Check::boundary_self_intersection, "boundary-self-intersection", "two boundary faces meet only in their common vertices and edges", "exact", Severity::fail, all_exact, needed, alone},
  {Check::overlap, "overlap", "no part of the boundary has the mesh on its outer side: with the checks above, no two tetrahedra overlap. Otherwise names two that do, and a rational point strictly inside both", "exact", Severity::fail, all_exact, needed, alone},
  {Check::bounding_box, "bounding-box", "the mesh is in the units and in the place of the surface: the boxes of its boundary and of the surface meet, their sizes do not differ by the factor between two units of length, and one is not the other one moved", "the boxes: exact; factors: within 2 % and the allowed distance on each axis", Severity::fail, measures, not_needed, with_surface},
  {Check::missing_region, "missing-region", "no region of the solid that is deeper than fidelity lacks the mesh. Such a region consists of voxels whose centres are inside the surface, in no tetrahedron, and farther from the mesh than allowed. Names a point of it, its volume and the nearest face", "inside and in no tetrahedron: exact; the volume: by voxels, off by at most the bound in the finding; a region that holds no voxel's centre is not seen", Severity::fail, measures, not_needed, with_surface},
  {Check::excess_region, "excess-region", "no region of the mesh is farther from the solid than fidelity allows: as missing-region. Names a point of it, its volume and the tetrahedra at that point", "as missing-region", Severity::fail, measures, not_needed, with_surface},
  {Check::off_surface_vertex, "off-surface-vertex", "every vertex of the boundary is as near to the surface as fidelity allows", "each distance is off by some 1e-15 of the diagonal; a difference inside that is undecided", Severity::fail, measures, not_needed, with_surface},
  {Check::topology, "topology", "each component of the boundary is one of the surface's, and the other way round: the one that most of its faces are nearest to, with the same genus, a cavity or not, and inside as many others", "which components are near each other: by up to 64 faces of each; all else exact", Severity::topology, all_exact, not_needed, with_surface},
  {Check::volume_surface, "volume-surface", "the mesh's volume is the surface's volume, within fidelity x diagonal x area, and within a quarter of the surface's volume", "both exact, rounded once", Severity::fail, all_exact, not_needed, with_surface},
  {Check::volume_voxel, "volume-voxel", "the mesh's volume is that of the surface's voxels, an independent account", "the volume of the voxels that the surface meets; it is added to what volume-surface allows", Severity::fail, measures, not_needed, with_surface},
  {Check::mesh_to_surface, "mesh-to-surface", "no point of the boundary is farther from the surface than fidelity allows: the directed Hausdorff distance", "enclosed in an interval that is narrowed until it decides; where it cannot, at some 1e-14 of the diagonal, undecided. The measured value is its lower end", Severity::fail, measures, not_needed, with_surface},
  {Check::surface_to_mesh, "surface-to-mesh", "no point of the surface is farther from the boundary than fidelity allows", "as mesh-to-surface", Severity::fail, measures, not_needed, with_surface},
  {Check::normals, "normals", "no face of the boundary looks away from every triangle of the surface within fidelity of its centroid. The measured value is the largest angle between a face's normal and that of the nearest triangle [degrees]", "which triangles are near: some 1e-15 of the diagonal; angles: some 1e-15 radians, for needles larger by the factor length / height; right angles pass", Severity::warning, measures, not_needed, with_surface},
};
// clang-format on

constexpr bool in_order() {
  for (int i = 0; i < check_count; ++i)
    if (static_cast<int>(table[i].check) != i) return false;
  return true;
}
static_assert(std::size(table) == check_count, "a row for each check; check_count names the last one");
static_assert(in_order(), "the rows are in the order of the enumeration");

}  // namespace

const CheckInfo& info(Check check) {
  return table[static_cast<std::size_t>(check)];
}

std::vector<std::string> check_ids() {
  std::vector<std::string> ids;
  for (const CheckInfo& row : table) ids.emplace_back(row.id);
  return ids;
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
                        row.accuracy, severity, row.certificate ? "; the certificate needs it" : "",
                        row.needs_surface ? "; needs a surface" : "");
  }
  return text;
}

}  // namespace tetproof::verify
