// SPDX-License-Identifier: GPL-3.0-or-later
// The account of each region of a mesh whose regions share faces.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "io/document.hpp"
#include "io/error.hpp"
#include "tests/support/meshes.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Report;

// The region of each tetrahedron, given the region of each cell. lattice_mesh makes six tetrahedra per cell,
// cell by cell.
std::vector<std::int64_t> by_cell(std::initializer_list<std::int64_t> of_cell) {
  std::vector<std::int64_t> regions;
  for (const std::int64_t region : of_cell) regions.insert(regions.end(), 6, region);
  return regions;
}

TEST(Regions, TwoCubesWithACommonFace) {
  const TetMesh mesh = lattice_mesh({2, 1, 1}, {}, {-1, 0, 0});
  const Report report = verify::verify(mesh, {.regions = by_cell({12, -3})});
  EXPECT_EQ(report.certificate, true);
  EXPECT_EQ(report.mesh.boundary_faces, 20);
  ASSERT_EQ(report.regions.size(), 2u);
  EXPECT_EQ(report.regions[0].tag.tag, -3);
  EXPECT_EQ(report.regions[1].tag.tag, 12);
  for (const auto& [name, shape] : report.regions) {
    EXPECT_EQ(shape.points, 8);
    EXPECT_EQ(shape.tets, 6);
    EXPECT_EQ(shape.boundary_faces, 12);
    EXPECT_EQ(shape.components, 1);
    EXPECT_EQ(shape.genus, 0);
    EXPECT_EQ(shape.volume, 1.0);
  }
}

TEST(Regions, AShellAroundACoreHasACavityThatTheMeshHasNot) {
  std::vector<std::int64_t> regions;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) regions.insert(regions.end(), 6, i == 1 && j == 1 && k == 1 ? 2 : 1);
  const Report report = verify::verify(lattice_mesh({3, 3, 3}), {.regions = regions});
  EXPECT_EQ(report.certificate, true);
  EXPECT_EQ(report.mesh.cavities, 0);
  ASSERT_EQ(report.regions.size(), 2u);
  EXPECT_EQ(report.regions[0].shape.cavities, 1);
  EXPECT_EQ(report.regions[0].shape.components, 2);
  EXPECT_EQ(report.regions[0].shape.volume, 26.0);
  EXPECT_EQ(report.regions[1].shape.volume, 1.0);
  EXPECT_EQ(report.regions[1].shape.boundary_faces, 12);
}

// A region of two parts, and tetrahedra that belong to no region.
TEST(Regions, PartsAndBrokenTetrahedra) {
  TetMesh mesh = lattice_mesh({3, 1, 1});
  mesh.tets.push_back({0, 1, 2, 999});
  auto regions = by_cell({1, 2, 1});
  regions.push_back(5);
  const Report report = verify::verify(mesh, {.regions = regions});
  ASSERT_EQ(report.regions.size(), 2u);
  EXPECT_EQ(report.regions[0].shape.components, 2);
  EXPECT_EQ(report.regions[0].shape.volume, 2.0);
  EXPECT_EQ(report.regions[1].shape.volume, 1.0);
}

// If the regions do not share their points, the mesh is cracked.
TEST(Regions, NotSharingPointsIsACrack) {
  const TetMesh mesh = together(lattice_mesh({1, 1, 1}), lattice_mesh({1, 1, 1}, {}, {1, 0, 0}));
  const Report report = verify::verify(mesh, {.regions = by_cell({1, 2})});
  EXPECT_EQ(report.certificate, false);
  EXPECT_EQ(report[verify::Check::crack].count, 2);
  ASSERT_EQ(report.regions.size(), 2u);
  EXPECT_EQ(report.regions[1].shape.volume, 1.0);
}

TEST(Regions, OneRegionNeedsNoAccount) {
  EXPECT_TRUE(verify::verify(lattice_mesh({2, 1, 1}), {.regions = by_cell({4, 4})}).regions.empty());
  EXPECT_TRUE(verify::verify(lattice_mesh({2, 1, 1})).regions.empty());
}

TEST(Regions, OneForEachTetrahedronOrNone) {
  EXPECT_THROW(verify::verify(lattice_mesh({2, 1, 1}), {.regions = {1, 2}}), InputError);
}

// Two cubes beside each other, of six tetrahedra each. `first` and `second` are the blocks' groups; both
// cubes have an entity of their own.
Document two_cubes(const std::vector<std::int64_t>& first, const std::vector<std::int64_t>& second) {
  Document document = document_of(lattice_mesh({2, 1, 1}));
  document.tag_sets.push_back(first);
  document.tag_sets.push_back(second);
  ElementBlock block = document.blocks[0];
  block.count = 6, block.entity = 1, block.groups = first.empty() ? 0 : 1;
  ElementBlock other = block;
  other.first = 6, other.nodes = 24, other.entity = 2, other.groups = second.empty() ? 0 : 2;
  document.blocks = {block, other};
  return document;
}

Report judged(const Document& document) {
  TetRegions regions = tet_regions(document);
  return verify::verify(tet_mesh(document),
                        {.regions = std::move(regions.of_tet), .region_tags = std::move(regions.tags)});
}

// Six tetrahedra in group 2, six in entity 2 without a group.
TEST(Regions, AGroupAndAnEntityOfTheSameNumberAreTwo) {
  Document document = two_cubes({2}, {});
  document.group_names = {{2, 2, "a surface"}, {3, 2, "steel"}};
  const Report report = judged(document);
  ASSERT_EQ(report.regions.size(), 2u);
  EXPECT_EQ(report.regions[0].tag.kind, "physical");
  EXPECT_EQ(report.regions[0].tag.tag, 2);
  EXPECT_EQ(report.regions[0].tag.name, "steel");
  EXPECT_EQ(report.regions[0].shape.tets, 6);
  EXPECT_EQ(report.regions[1].tag.kind, "entity");
  EXPECT_EQ(report.regions[1].tag.tag, 2);
  EXPECT_EQ(report.regions[1].tag.name, "");
  EXPECT_EQ(report.regions[1].shape.volume, 1.0);
  EXPECT_THAT(report_text(report),
              testing::HasSubstr("region    physical 2 (steel): 6 tetrahedra, volume 1; "));
  EXPECT_THAT(report_text(report), testing::HasSubstr("region    entity 2: 6 tetrahedra, volume 1; "));
  const nlohmann::json json = nlohmann::json::parse(report_json(report));
  EXPECT_EQ(json["regions"][0]["kind"], "physical");
  EXPECT_EQ(json["regions"][0]["name"], "steel");
  EXPECT_EQ(json["regions"][1]["tag"], 2);
  EXPECT_EQ(json["regions"][1]["kind"], "entity");
}

TEST(Regions, EntitiesOfOneGroupAreOne) {
  EXPECT_TRUE(judged(two_cubes({7}, {7})).regions.empty());
  EXPECT_EQ(judged(two_cubes({}, {})).regions.size(), 2u);
  // Sorted by their numbers, whatever the order in the file is.
  const Report report = judged(two_cubes({7}, {-7}));
  ASSERT_EQ(report.regions.size(), 2u);
  EXPECT_EQ(report.regions[0].tag.tag, -7);
  EXPECT_EQ(report.regions[1].tag.tag, 7);
}

TEST(Regions, ATagThatIsNotThereIsRefused) {
  const std::vector<std::int64_t> regions(12, 1);
  EXPECT_THROW(
      verify::verify(lattice_mesh({2, 1, 1}), {.regions = regions, .region_tags = {{"entity", 1, ""}}}),
      InputError);
}

}  // namespace
}  // namespace tetproof::test
