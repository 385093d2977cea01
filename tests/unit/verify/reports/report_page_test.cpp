// SPDX-License-Identifier: GPL-3.0-or-later
// What of a mesh a report's page holds. The page itself is tested in a browser (tests/browser).
#include "verify/report_page.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <set>

#include "corpus/block_mesh.hpp"
#include "verify/reports/report_scene.hpp"
#include "verify/verify.hpp"

namespace tetproof::verify {
namespace {

using ::testing::HasSubstr;

struct Judged {
  TetMesh mesh;
  Numbering numbering{.first = 1};
  std::vector<std::int64_t> regions;
  std::vector<RegionTag> tags;
  Report report;

  explicit Judged(TetMesh given) : mesh(std::move(given)), report(verify(mesh)) {}
  PageSubject subject() const {
    return {
        .mesh = mesh, .numbering = numbering, .mesh_name = "mesh", .regions = regions, .region_tags = tags};
  }
};

TetMesh with_an_inverted_tetrahedron(int n) {
  TetMesh mesh = corpus::block_mesh({n, n, n});
  std::swap(mesh.tets[7][2], mesh.tets[7][3]);
  return mesh;
}

const io::SceneLayer* layer(const io::Scene& scene, const std::string& id) {
  for (const io::SceneLayer& one : scene.layers)
    if (one.id == id) return &one;
  return nullptr;
}

TEST(ReportScene, a_small_mesh_is_there_as_a_whole) {
  const Judged judged(with_an_inverted_tetrahedron(3));
  const ReportScene made = report_scene(judged.report, judged.subject());
  EXPECT_EQ(made.scene.tets.size(), judged.mesh.tets.size());
  EXPECT_EQ(made.scene.cut_tets, judged.mesh.tets.size());
  EXPECT_TRUE(made.scene.cut_anywhere);
  EXPECT_TRUE(made.left_out.empty());
  ASSERT_TRUE(layer(made.scene, "boundary"));
  EXPECT_EQ(static_cast<std::int64_t>(layer(made.scene, "boundary")->faces.size()),
            judged.report.mesh.boundary_faces);
}

TEST(ReportScene, defects_fly_to_their_place_with_the_files_numbers) {
  const Judged judged(with_an_inverted_tetrahedron(3));
  const ReportScene made = report_scene(judged.report, judged.subject());
  ASSERT_TRUE(layer(made.scene, "defects"));
  const auto& faces = layer(made.scene, "defects")->faces;
  ASSERT_EQ(faces.size(), 4u);
  EXPECT_EQ(made.scene.tet_numbers[faces[0] >> 2], 8) << "position 7 is number 8";
  ASSERT_FALSE(made.targets.empty());
  const io::SceneTarget& target = made.scene.targets[static_cast<std::size_t>(made.targets[0])];
  EXPECT_THAT(target.text, HasSubstr("inverted: tetrahedron 8"));
  for (const Index v : judged.mesh.tets[7])
    EXPECT_LE((judged.mesh.points[static_cast<std::size_t>(v)] - target.middle).norm(),
              target.radius * (1 + 1e-12));
  // One ring around it: every edge belongs to a tetrahedron that touches the inverted one.
  ASSERT_EQ(made.scene.edges.size(), 1u);
  EXPECT_GT(made.scene.edges[0].edges.size(), 20u);
}

Finding& first_finding(Report& report) {
  const auto found = std::find_if(report.checks.begin(), report.checks.end(),
                                  [](const CheckResult& result) { return !result.findings.empty(); });
  EXPECT_NE(found, report.checks.end());
  return found->findings[0];
}

TEST(ReportScene, faces_of_a_finding_belong_to_its_place) {
  Judged judged(with_an_inverted_tetrahedron(3));
  const std::array<Index, 3> face{0, 1, 5};
  first_finding(judged.report).faces = {face, {0, 1, 1'000'000}};  // the second names no point
  const ReportScene made = report_scene(judged.report, judged.subject());
  const io::SceneTarget& target = made.scene.targets[static_cast<std::size_t>(made.targets[0])];
  ASSERT_EQ(target.faces.size(), 1u);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(made.scene.points[static_cast<std::size_t>(target.faces[0][k])],
              judged.mesh.points[static_cast<std::size_t>(face[k])]);
}

TEST(ReportScene, very_many_edges_are_hidden_at_first) {
  Judged judged(with_an_inverted_tetrahedron(12));
  EXPECT_TRUE(report_scene(judged.report, judged.subject()).scene.edges[0].shown);
  for (Index v = 0; v < static_cast<Index>(judged.mesh.points.size()); ++v)
    first_finding(judged.report).vertices.push_back(v);
  const ReportScene made = report_scene(judged.report, judged.subject());
  EXPECT_GT(made.scene.edges[0].edges.size(), 5000u);
  EXPECT_FALSE(made.scene.edges[0].shown);
}

TEST(ReportScene, of_a_large_mesh_the_middle_and_the_defects_are_there) {
  const Judged judged(with_an_inverted_tetrahedron(16));
  const ReportScene made = report_scene(judged.report, judged.subject(), 300'000);
  const io::Scene& scene = made.scene;
  EXPECT_FALSE(scene.cut_anywhere);
  EXPECT_FALSE(scene.cut_axes.empty());
  EXPECT_GT(scene.cut_tets, 0u);
  EXPECT_LT(scene.tets.size(), judged.mesh.tets.size());
  for (std::size_t t = 0; t < scene.cut_tets; ++t) {
    bool met = false;
    for (const char axis : scene.cut_axes) {
      double low = 1e300, high = -1e300;
      for (const Index v : scene.tets[t]) {
        low = std::min(low, scene.points[static_cast<std::size_t>(v)][axis - 'x']);
        high = std::max(high, scene.points[static_cast<std::size_t>(v)][axis - 'x']);
      }
      met = met || (low <= scene.cut_middle[axis - 'x'] && high >= scene.cut_middle[axis - 'x']);
    }
    EXPECT_TRUE(met) << t;
  }
  ASSERT_TRUE(layer(scene, "defects"));
  EXPECT_EQ(scene.tet_numbers[layer(scene, "defects")->faces[0] >> 2], 8);
  ASSERT_EQ(made.left_out.size(), 2u);
  EXPECT_THAT(made.left_out[0], HasSubstr("too large to be cut anywhere"));
  EXPECT_THAT(made.left_out[1], HasSubstr("The boundary of 3072 faces is drawn by"));
  EXPECT_LT(io::scene_json(scene).size(), 450'000u);
}

TEST(ReportScene, what_cannot_be_drawn_is_said) {
  TetMesh mesh = corpus::block_mesh({2, 2, 2});
  mesh.tets[3][0] = 1000;
  mesh.tets[5][1] = mesh.tets[5][2];
  const Judged judged(std::move(mesh));
  const ReportScene made = report_scene(judged.report, judged.subject());
  EXPECT_EQ(made.scene.tets.size(), judged.mesh.tets.size() - 2);
  ASSERT_EQ(made.left_out.size(), 1u);
  EXPECT_THAT(made.left_out[0], HasSubstr("2 tetrahedra cannot be drawn"));
}

TEST(ReportPage, the_same_input_gives_the_same_bytes) {
  const Judged judged(with_an_inverted_tetrahedron(2));
  EXPECT_EQ(report_page(judged.report, judged.subject()), report_page(judged.report, judged.subject()));
}

}  // namespace
}  // namespace tetproof::verify
