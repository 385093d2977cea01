// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing is left out silently: a mesh is not sound if it has elements other than tetrahedra, if elements
// were not read, or if a check could not run.
#include <gmock/gmock.h>
#include <gtest/gtest-spi.h>

#include <nlohmann/json.hpp>

#include "io/document.hpp"
#include "tests/support/meshes.hpp"
#include "verify/findings_text.hpp"
#include "verify/gtest.hpp"
#include "verify/reports/report_json.hpp"

namespace tetproof::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using verify::Check;
using verify::Report;
using verify::Verdict;
using Json = nlohmann::json;

// Adds elements of one type. Their nodes are new points beyond the mesh, on a twisted cubic: any four in
// order make a positive tetrahedron.
void add_elements(Document& document, int type, int dim, int nodes_each, std::size_t count) {
  document.blocks.push_back({.type = type,
                             .dim = dim,
                             .entity = 2,
                             .nodes_each = nodes_each,
                             .count = count,
                             .first = document.elements(),
                             .nodes = document.connectivity.size()});
  for (std::size_t i = 0; i < count * static_cast<std::size_t>(nodes_each); ++i) {
    document.connectivity.push_back(static_cast<Index>(document.points.size()));
    const double x = static_cast<double>(i);
    document.points.push_back({100 + x, 1e6 * type + x * x, x * x * x});
  }
}

Report judged(const Document& document) {
  return verify::verify(tet_mesh(document), {.unjudged = verify::unjudged(document)});
}

Document block() {
  return document_of(lattice_mesh({2, 2, 2}));
}

TEST(Unjudged, ADocumentOfTetrahedraIsJudgedWhole) {
  Document document = block();
  EXPECT_TRUE(sound(judged(document)));
  // Faces and edges are not part of the volume, and attributes do not change the verdict.
  add_elements(document, 2, 2, 3, 4);
  add_elements(document, 1, 1, 2, 4);
  document.dropped.push_back({"values called \"stress\"", 27, "line 3"});
  const Report report = judged(document);
  EXPECT_TRUE(sound(report)) << report_text(report);
  EXPECT_EQ(report[Check::unused_point].count, 20);
}

TEST(Unjudged, CellsOfOtherShapes) {
  Document document = block();
  add_elements(document, 5, 3, 8, 2);    // hexahedra
  add_elements(document, 4, 3, 4, 1);    // a tetrahedron, which is judged
  add_elements(document, 17, 3, 20, 1);  // a hexahedron of second order
  add_elements(document, 6, 3, 6, 1);
  add_elements(document, 7, 3, 5, 3);
  add_elements(document, 35, 3, 9, 1);  // a polyhedron
  const Report report = judged(document);
  EXPECT_FALSE(sound(report));
  EXPECT_FALSE(defective(report));
  EXPECT_EQ(report.certificate, true);
  ASSERT_EQ(report.not_judged.size(), 4u);
  EXPECT_EQ(report.not_judged[0].what, "hexahedra");
  EXPECT_EQ(report.not_judged[0].count, 3);
  EXPECT_EQ(report.not_judged[0].why, "only tetrahedra are judged; the first is element 49");
  EXPECT_EQ(report.not_judged[1].what, "prisms");
  EXPECT_EQ(report.not_judged[2].what, "pyramids");
  EXPECT_EQ(report.not_judged[2].count, 3);
  EXPECT_EQ(report.not_judged[3].what, "polyhedra");
  // Their points count as used. The points in the middle of a hexahedron's edges do not belong to the mesh.
  EXPECT_EQ(report.mesh.points, 27 + 16 + 4 + 8 + 6 + 15 + 9);
  EXPECT_EQ(report[Check::unused_point].count, 0);
  EXPECT_EQ(report[Check::unused_point].verdict, Verdict::pass);
}

TEST(Unjudged, ElementsThatWereNotRead) {
  Document document = block();
  document.points.push_back({9, 9, 9});
  document.dropped.push_back({"cells of type 42", 8, "cell 3", true});
  const Report report = judged(document);
  EXPECT_FALSE(sound(report));
  EXPECT_FALSE(defective(report));
  EXPECT_THAT(
      report_text(report),
      StartsWith("incomplete: certified: 48 tetrahedra; not judged: 8 cells of type 42, check unused-point\n"
                 "unjudged  8 cells of type 42: not read: cell 3\n"
                 "unjudged  check unused-point: elements that were not read may use any point\n"));
  // They may use the last point.
  EXPECT_EQ(report[Check::unused_point].verdict, Verdict::skipped);

  const Json json = Json::parse(report_json(report));
  EXPECT_EQ(json["verdict"], "incomplete");
  EXPECT_EQ(json["not_judged"],
            Json::array({{{"what", "cells of type 42"}, {"count", 8}, {"why", "not read: cell 3"}},
                         {{"what", "check unused-point"},
                          {"count", 1},
                          {"why", "elements that were not read may use any point"}}}));
  EXPECT_EQ(Json(verify::report_json_object(report)), json);
  EXPECT_EQ(Json::parse(report_json(judged(block())))["not_judged"], Json::array());

  const std::string junit = report_junit(report, "part.vtu");
  EXPECT_THAT(junit, HasSubstr("<testcase classname=\"part.vtu\" name=\"not judged: cells of type 42\">\n"
                               "      <skipped message=\"8 cells of type 42: not read: cell 3\"/>"));
  EXPECT_THAT(junit,
              HasSubstr("name=\"unused-point\">\n      <skipped message=\"elements that were not read may "
                        "use any point\"/>"));
  EXPECT_THAT(junit, HasSubstr("<property name=\"verdict\" value=\"incomplete\"/>"));
}

TEST(Unjudged, ADefectIsADefectAllTheSame) {
  TetMesh mesh = lattice_mesh({2, 2, 2});
  std::swap(mesh.tets[3][0], mesh.tets[3][1]);
  Document document = document_of(mesh);
  add_elements(document, 5, 3, 8, 1);
  const Report report = judged(document);
  EXPECT_TRUE(defective(report));
  EXPECT_FALSE(sound(report));
  EXPECT_THAT(report_text(report),
              StartsWith("DEFECTIVE: no certificate, no valid triangulation of a solid (inverted); not "
                         "judged: 1 hexahedron\n"));
  EXPECT_EQ(Json::parse(report_json(report))["verdict"], "defective");
}

TEST(Unjudged, MatchersFailWithTheReason) {
  Document document = block();
  add_elements(document, 5, 3, 8, 1);
  const std::string file = testing::TempDir() + "tetproof-unjudged.msh";
  write_document(file, document);
  const std::filesystem::path path = file;
  EXPECT_NONFATAL_FAILURE(EXPECT_THAT(path, verify::IsSound()),
                          "which is incomplete: certified: 48 tetrahedra; not judged: 1 hexahedron");
  EXPECT_NONFATAL_FAILURE(EXPECT_THAT(path, verify::Fills(boundary_surface(lattice_mesh({2, 2, 2})), 1e-3)),
                          "unjudged  1 hexahedron: only tetrahedra are judged; the first is element 49\n");
  EXPECT_THAT(path, testing::Not(verify::IsCertified()));
  std::filesystem::remove(path);
}

TEST(Unjudged, ChecksThatCouldNotRun) {
  // The surface and the mesh are too far from the origin for voxels.
  TetMesh mesh = lattice_mesh({2, 2, 2});
  for (Eigen::Vector3d& p : mesh.points) p.x() += 1e12;
  const TriangleSurface surface = boundary_surface(mesh);
  verify::Options options{.region = verify::Region::inside};
  const Report far = verify::verify(mesh, surface, options);
  EXPECT_FALSE(sound(far));
  EXPECT_FALSE(defective(far)) << report_text(far);
  ASSERT_EQ(far.not_judged.size(), 2u);
  EXPECT_EQ(far.not_judged[0].what, "checks missing-region, excess-region");
  EXPECT_EQ(far.not_judged[0].count, 2);
  EXPECT_THAT(far.not_judged[0].why, StartsWith("the surface is too far from the origin"));
  EXPECT_EQ(far.not_judged[1].what, "check volume-voxel");
  // Nobody asked for them.
  options.voxels = 0;
  EXPECT_TRUE(sound(verify::verify(mesh, surface, options)));
  options = {.region = verify::Region::inside, .skip = {"missing-region", "excess-region", "volume-voxel"}};
  EXPECT_TRUE(sound(verify::verify(mesh, surface, options)));
}

}  // namespace
}  // namespace tetproof::test
