// SPDX-License-Identifier: GPL-3.0-or-later
// Reports for users and for scripts: the keys, the numbers as the file has them, and the same bytes for any
// number of threads.
#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <nlohmann/json.hpp>

#include "io/document.hpp"
#include "tests/support/meshes.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using Json = nlohmann::json;

TEST(Report, Keys) {
  const TetMesh mesh = lattice_mesh({2, 2, 2});
  const Json report = Json::parse(report_json(verify::verify(mesh)));
  EXPECT_EQ(report["verdict"], "sound");
  EXPECT_EQ(report["certificate"], true);
  for (const char* key : {"points", "tets", "boundary_faces", "components", "cavities", "genus", "volume"})
    EXPECT_TRUE(report["mesh"].contains(key)) << key;
  EXPECT_TRUE(report["surface"].is_null());
  for (const char* key : {"mesh", "surface", "relative_difference", "voxel_inside", "voxel_error_bound",
                          "voxel_error_estimate"})
    EXPECT_TRUE(report["volume"].contains(key)) << key;
  EXPECT_FALSE(report.contains("seconds"));
  ASSERT_EQ(report["checks"].size(), static_cast<std::size_t>(verify::check_count));
  for (const Json& check : report["checks"])
    for (const char* key : {"id", "verdict", "exact", "count", "measured", "allowed", "findings"})
      EXPECT_TRUE(check.contains(key)) << check["id"] << key;
  EXPECT_TRUE(Json::parse(report_json(verify::verify(mesh, {.timings = true}))).contains("seconds"));
}

TEST(Report, SpeaksTheFilesNumbers) {
  TetMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1, 3}, {0, 1, 2, -1}}};
  const Numbering numbering{
      .points = {100, 7, 55, 9000000000}, .tets = {31, 17}, .unknown = {4242}, .first = 0};
  const verify::Report report = verify::verify(mesh);
  const Json json = Json::parse(report_json(report, numbering));
  EXPECT_EQ(json["verdict"], "defective");
  EXPECT_EQ(json["certificate"], false);
  const auto finding = [&](const char* id) {
    for (const Json& check : json["checks"])
      if (check["id"] == id) return check["findings"][0];
    return Json();
  };
  EXPECT_EQ(finding("index-range")["tets"], Json({17}));
  EXPECT_EQ(finding("index-range")["vertices"], Json({4242}));
  EXPECT_EQ(finding("inverted")["tets"], Json({31}));
  const std::string text = report_text(report, numbering);
  EXPECT_THAT(text, testing::StartsWith("DEFECTIVE"));
  EXPECT_THAT(text, testing::HasSubstr("tetrahedron 31: negative: volume -0.166667"));
  EXPECT_THAT(text, testing::HasSubstr("4242"));
}

// Three tetrahedra and two points of a file share their numbers.
TEST(Report, TellsElementsWithTheSameNumberApart) {
  Document document = document_of(lattice_mesh({1, 1, 1}));
  document.element_tags = {7, 5, 7, 1, 2, 7};
  document.node_tags = {1, 2, 3, 4, 5, 6, 7, 8};
  document.points.emplace_back(9, 9, 9);
  document.node_tags.push_back(3);
  TetMesh mesh = tet_mesh(document);
  for (const std::size_t t : {1, 2, 5}) std::swap(mesh.tets[t][0], mesh.tets[t][1]);
  const verify::Report report = verify::verify(mesh);
  const std::string text = report_text(report, numbering(document));
  EXPECT_THAT(text, testing::HasSubstr("  tetrahedron 5: negative: "));
  EXPECT_THAT(text, testing::HasSubstr("  tetrahedron 7 (the 2nd with this number): negative: "));
  EXPECT_THAT(text, testing::HasSubstr("  tetrahedron 7 (the 3rd with this number): negative: "));
  EXPECT_THAT(text, testing::HasSubstr("  vertex 3 (the 2nd with this number): belongs to no tetrahedron"));
  const Json json = Json::parse(report_json(report, numbering(document)));
  for (const Json& check : json["checks"]) {
    if (check["id"] == "inverted") {
      EXPECT_FALSE(check["findings"][0].contains("tets_nth"));
      EXPECT_EQ(check["findings"][1]["tets_nth"], Json({2}));
      EXPECT_EQ(check["findings"][2]["tets_nth"], Json({3}));
    }
    if (check["id"] == "unused-point") {
      EXPECT_EQ(check["findings"][0]["vertices_nth"], Json({2}));
    }
  }
}

TEST(Report, QualityOfTheRegularTetrahedron) {
  const TetMesh regular{{{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}, {{0, 1, 2, 3}}};
  const verify::Report report = verify::verify(regular);
  ASSERT_EQ(report[verify::Check::inverted].count, 0);
  const verify::Quality& q = *report.quality;
  EXPECT_EQ(q.tets, 1);
  EXPECT_NEAR(q.dihedral_angles.min, 70.528779365509308, 1e-12);  // acos(1/3)
  EXPECT_NEAR(q.dihedral_angles.max, 70.528779365509308, 1e-12);
  EXPECT_NEAR(q.solid_angles.min, 0.04386991402, 1e-10);  // (3 acos(1/3) - pi) / 4 pi
  EXPECT_NEAR(q.aspect_ratios.max, 1, 1e-14);
  EXPECT_EQ(q.dihedral_angles.counts[7], 6);
  std::int64_t counted = 0;
  for (const std::int64_t n : q.solid_angles.counts) counted += n;
  EXPECT_EQ(counted, 4);
}

TEST(Report, QualityOfAKuhnTetrahedron) {
  const verify::Quality q = *verify::verify(lattice_mesh({2, 1, 1})).quality;
  EXPECT_NEAR(q.dihedral_angles.min, 45, 1e-12);
  EXPECT_NEAR(q.dihedral_angles.max, 90, 1e-12);
  EXPECT_NEAR(q.solid_angles.min, 1.0 / 48, 1e-15);  // (90 + 60 + 45 degrees - pi) / 4 pi
  EXPECT_EQ(q.tets, 12);
}

TEST(Report, SameBytesForAnyNumberOfThreads) {
  TetMesh mesh = lattice_mesh({12, 12, 12});
  for (std::size_t t = 0; t < mesh.tets.size(); t += 97) std::swap(mesh.tets[t][0], mesh.tets[t][1]);
  for (std::size_t t = 50; t < mesh.tets.size(); t += 1013) mesh.tets.push_back(mesh.tets[t]);
  mesh = together(mesh, lattice_mesh({3, 3, 3}, {}, {11.5, 3.3, 3.7}));
  mesh.points[333].x() = std::nan("");
  const TriangleSurface surface = box_surface({0, 0, 0}, 12);
  std::vector<std::string> reports;
  for (const int threads : {1, 2, 5, 1}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    reports.push_back(
        report_json(verify::verify(mesh, surface, {.region = verify::Region::inside, .voxels = 16})));
  }
  for (const std::string& report : reports) EXPECT_EQ(report, reports[0]);
}

TEST(Report, EveryCheckIsListedOnce) {
  const std::string list = verify::list_checks();
  for (int i = 0; i < verify::check_count; ++i) {
    const verify::CheckInfo& row = info(static_cast<verify::Check>(i));
    EXPECT_THAT(list, testing::HasSubstr(std::string(row.id) + "\n    proves    " + row.proves));
    EXPECT_EQ(verify::check_of_id(row.id), row.check);
  }
}

}  // namespace
}  // namespace tetproof::test
