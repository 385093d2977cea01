// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/report/statements.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "corpus/report/statement_maker.hpp"
#include "io/bytes/words.hpp"
#include "verify/surface.hpp"

namespace tetproof::corpus {
namespace {

using nlohmann::json;
using verify::Check;

struct Row {
  Check check;
  const char* headline;
  void (StatementMaker::*make)();
};

constexpr Row rows[] = {
    {Check::index_range, "a tetrahedron names a vertex that does not exist", &StatementMaker::no_such_point},
    {Check::finite_coordinates, "a vertex with coordinates that are not finite", &StatementMaker::not_finite},
    {Check::repeated_vertex, "a tetrahedron names a vertex twice", &StatementMaker::repeated_vertex},
    {Check::duplicate_point, "two vertices in one place", &StatementMaker::same_place},
    {Check::unused_point, "a vertex of no tetrahedron", &StatementMaker::unused_point},
    {Check::duplicate_tet, "the same tetrahedron twice", &StatementMaker::duplicates},
    {Check::inverted, "a tetrahedron of negative volume", &StatementMaker::tet_volume},
    {Check::flat, "a tetrahedron of volume zero", &StatementMaker::tet_volume},
    {Check::face_shared_thrice, "a face of more than two tetrahedra", &StatementMaker::face_shared},
    {Check::face_orientation, "two tetrahedra on the same side of their face",
     &StatementMaker::face_orientation},
    {Check::hanging_node, "a vertex on a face that does not have it as a corner",
     &StatementMaker::hanging_node},
    {Check::crossed_diagonal, "faces that do not match: crossed diagonals",
     &StatementMaker::crossed_diagonals},
    {Check::crack, "a crack: two faces in one place with different vertices", &StatementMaker::crack},
    {Check::non_conforming_interface, "parts that touch along faces that do not match",
     &StatementMaker::interface},
    {Check::near_contact, "faces a hair apart", &StatementMaker::near_contact},
    {Check::cavity, "a hole inside the mesh", &StatementMaker::topology},
    {Check::boundary_nonmanifold_edge, "an edge with more than two boundary faces",
     &StatementMaker::nonmanifold_edge},
    {Check::boundary_nonmanifold_vertex, "a vertex at which the boundary touches itself",
     &StatementMaker::nonmanifold_vertex},
    {Check::boundary_self_intersection, "tetrahedra that overlap: the boundary intersects itself",
     &StatementMaker::self_intersection},
    {Check::overlap, "tetrahedra that overlap", &StatementMaker::overlap},
    {Check::bounding_box, "a mesh of another size or place than the surface", &StatementMaker::volumes},
    {Check::missing_region, "a part of the solid without tetrahedra", &StatementMaker::missing_region},
    {Check::excess_region, "tetrahedra outside of the solid", &StatementMaker::excess_region},
    {Check::off_surface_vertex, "a boundary vertex off the surface", &StatementMaker::off_surface_vertex},
    {Check::topology, "a boundary of another topology than the surface's", &StatementMaker::topology},
    {Check::volume_surface, "a volume that is not the surface's", &StatementMaker::volumes},
    {Check::volume_voxel, "a volume that is not the surface's", &StatementMaker::volumes},
    {Check::mesh_to_surface, "a boundary that leaves the surface", &StatementMaker::mesh_to_surface},
    {Check::surface_to_mesh, "a part of the surface that the mesh does not reach",
     &StatementMaker::surface_to_mesh},
    {Check::normals, "a boundary face that looks away from the surface", &StatementMaker::quote},
};
static_assert(std::size(rows) == verify::check_count);

}  // namespace

Statements statements_of(const StatedMesh& judged, Check root) {
  const Row& row =
      *std::find_if(std::begin(rows), std::end(rows), [&](const Row& r) { return r.check == root; });
  Statements result{.headline = row.headline};
  const auto& findings = judged.report[root].findings;
  if (findings.empty()) return result;
  StatementMaker maker(judged, findings.front());
  (maker.*row.make)();
  if (maker.list_of_statements.empty()) maker.quote();
  result.list = std::move(maker.list_of_statements);
  result.marks = std::move(maker.marks);
  return result;
}

json surface_statement(const TriangleSurface& surface) {
  const verify::SurfaceReport report = verify::judge_surface(surface);
  if (!report.fault.empty())
    return {{"kind", "report"},
            {"text", "surface.off, the surface as the mesher got it, is not valid: " + report.fault},
            {"why", "only valid surfaces are confirmed"}};
  const FaceCounts found = face_counts(surface.triangles);
  const Rational volume = exact_volume(surface);
  return {{"kind", "valid_surface"},
          {"text",
           fmt::format("surface.off is closed, manifold, oriented and free of self-intersections: {}, {}, "
                       "Euler characteristic {}, volume {}",
                       io::counted(surface.triangles.size(), "triangles"),
                       io::counted(found.components, "components"), found.euler, value_text(volume))},
          {"triangles", surface.triangles.size()},
          {"components", found.components},
          {"euler", found.euler},
          {"volume", text_of(volume)}};
}

}  // namespace tetproof::corpus
