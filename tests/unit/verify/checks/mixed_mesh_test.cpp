// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of tetrahedra and other elements against their surface: space that unjudged elements may fill is not
// missing, their sides are no boundary, and what is wrong elsewhere is found all the same.
#include <gmock/gmock.h>

#include <functional>
#include <map>

#include "io/document.hpp"
#include "tests/support/meshes.hpp"
#include "verify/findings_text.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using testing::HasSubstr;
using verify::Check;
using verify::Options;
using verify::Region;
using verify::Report;
using verify::Verdict;

enum class Fill { nothing, tetrahedra, hexahedron, prisms, pyramids };
using Filling = std::function<Fill(Cell)>;

// Cells of a lattice, each cut into six tetrahedra, two prisms or three pyramids, or whole, or left out.
// Neighbours share faces: all are cut along the diagonals of `lattice_mesh`.
class MixedMesh {
 public:
  MixedMesh(Cell n, const Filling& filling) {
    const std::map<Fill, std::pair<int, int>> types{
        {Fill::hexahedron, {5, 8}}, {Fill::prisms, {6, 6}}, {Fill::pyramids, {7, 5}}};
    std::map<Fill, std::vector<Index>> nodes;
    for (int i = 0; i < n[0]; ++i)
      for (int j = 0; j < n[1]; ++j)
        for (int k = 0; k < n[2]; ++k) {
          const Fill fill = filling({i, j, k});
          const auto at = [&](int x, int y, int z) { return point({i + x, j + y, k + z}); };
          const std::array<Index, 8> c{at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0),
                                       at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)};
          std::vector<Index>& list = nodes[fill];
          const auto add = [&](std::initializer_list<int> corners) {
            for (const int corner : corners) list.push_back(c[static_cast<std::size_t>(corner)]);
          };
          if (fill == Fill::hexahedron) add({0, 1, 2, 3, 4, 5, 6, 7});
          if (fill == Fill::prisms) add({0, 1, 2, 4, 5, 6}), add({0, 2, 3, 4, 6, 7});
          if (fill == Fill::pyramids) add({1, 2, 6, 5, 0}), add({3, 7, 6, 2, 0}), add({4, 5, 6, 7, 0});
          if (fill == Fill::tetrahedra)
            for (const auto& tet : lattice_mesh({1, 1, 1}).tets) {
              std::array<Index, 4>& added = tets_.emplace_back();
              for (std::size_t v = 0; v < 4; ++v) {  // numbered lexicographically
                const Index number = tet[v];
                added[v] = at(number / 4, number / 2 % 2, number % 2);
              }
            }
        }
    document_ = document_of(TetMesh{points_, tets_});
    for (const auto& [fill, list] : nodes) {
      if (!types.contains(fill) || list.empty()) continue;
      const auto [type, each] = types.at(fill);
      document_.blocks.push_back({.type = type,
                                  .entity = 1,
                                  .nodes_each = each,
                                  .count = list.size() / static_cast<std::size_t>(each),
                                  .first = document_.elements(),
                                  .nodes = document_.connectivity.size()});
      document_.connectivity.insert(document_.connectivity.end(), list.begin(), list.end());
    }
  }
  Document& document() { return document_; }
  Eigen::Vector3d& at(Cell corner) { return document_.points[static_cast<std::size_t>(number_.at(corner))]; }

 private:
  Index point(Cell corner) {
    const auto [place, is_new] = number_.try_emplace(corner, static_cast<Index>(points_.size()));
    if (is_new) points_.emplace_back(corner[0], corner[1], corner[2]);
    return place->second;
  }

  std::map<Cell, Index> number_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<std::array<Index, 4>> tets_;
  Document document_;
};

Report judged(const Document& document, const TriangleSurface& surface,
              Options options = {.region = Region::inside, .fidelity = 0, .voxels = 48}) {
  options.unjudged = verify::unjudged(document);
  return verify::verify(tet_mesh(document), surface, options);
}

void expect_incomplete(const Report& report) {
  EXPECT_FALSE(sound(report));
  EXPECT_FALSE(defective(report)) << report_text(report);
  EXPECT_EQ(report.certificate, true);
}

std::vector<std::string> not_judged(const Report& report) {
  std::vector<std::string> names;
  for (const verify::NotJudged& entry : report.not_judged) names.push_back(entry.what);
  return names;
}

std::vector<std::string> failed(const Report& report) {
  std::vector<std::string> ids;
  for (const verify::CheckResult& result : report.checks)
    if (result.verdict == Verdict::fail) ids.emplace_back(info(result.check).id);
  return ids;
}

constexpr Cell size{4, 2, 2};
TriangleSurface surface_of_all(Cell n = size) {
  return boundary_surface(lattice_mesh(n));
}
Filling half(Fill other) {
  return [=](Cell c) { return c[0] < 2 ? Fill::tetrahedra : other; };
}

TEST(MixedMesh, IsIncompleteAgainstItsSurfaceAndNothingIsMissing) {
  for (const Fill other : {Fill::hexahedron, Fill::prisms, Fill::pyramids}) {
    const Report report = judged(MixedMesh(size, half(other)).document(), surface_of_all());
    expect_incomplete(report);
    EXPECT_EQ(report.mesh.tets, 48);
    EXPECT_EQ(report[Check::missing_region].verdict, Verdict::pass);
    EXPECT_EQ(report[Check::mesh_to_surface].verdict, Verdict::pass);
    EXPECT_EQ(report[Check::surface_to_mesh].verdict, Verdict::skipped);
    // The side between the halves has eight triangles.
    ASSERT_EQ(report.not_judged.size(), 3u);
    EXPECT_EQ(report.not_judged[1].what,
              "checks bounding-box, topology, volume-surface, volume-voxel, surface-to-mesh");
    EXPECT_EQ(report.not_judged[2].what, "boundary faces");
    EXPECT_EQ(report.not_judged[2].count, 8);
  }
}

TEST(MixedMesh, ARegionThatNothingFillsIsMissing) {
  // Of the half of the hexahedra the last cell lacks everything.
  const Report report =
      judged(MixedMesh(size,
                       [](Cell c) {
                         return c == Cell{3, 1, 1} ? Fill::nothing : half(Fill::hexahedron)(c);
                       })
                 .document(),
             surface_of_all());
  EXPECT_EQ(failed(report), std::vector<std::string>{"missing-region"});
  ASSERT_EQ(report[Check::missing_region].count, 1);
  const Eigen::Vector3d& p = *report[Check::missing_region].findings[0].point;
  for (int k = 0; k < 3; ++k) EXPECT_GT(p[k], k == 0 ? 3 : 1);
  EXPECT_THAT(not_judged(report), testing::Contains("hexahedra"));
  // A cell of the tetrahedra's half lacks everything: its inner faces are not on the surface.
  const Report other =
      judged(MixedMesh(size,
                       [](Cell c) {
                         return c == Cell{0, 0, 0} ? Fill::nothing : half(Fill::hexahedron)(c);
                       })
                 .document(),
             surface_of_all());
  EXPECT_EQ(failed(other),
            (std::vector<std::string>{"missing-region", "off-surface-vertex", "mesh-to-surface"}));
}

TEST(MixedMesh, WhatTheTetrahedraHaveInExcessIsFound) {
  const Report report = judged(
      MixedMesh({5, 2, 2}, [](Cell c) { return c[0] < 3 ? Fill::tetrahedra : Fill::hexahedron; }).document(),
      boundary_surface(lattice_mesh({4, 2, 2}, {}, {1, 0, 0})));
  EXPECT_THAT(failed(report), testing::Contains("excess-region"));
}

TEST(MixedMesh, AVertexOffTheSurfaceIsFoundAwayFromTheOthers) {
  MixedMesh mesh(size, half(Fill::hexahedron));
  mesh.at({0, 1, 1}).x() = -0.25;
  const Report report = judged(mesh.document(), surface_of_all());
  EXPECT_THAT(failed(report), testing::Contains("off-surface-vertex"));
}

TEST(MixedMesh, TetrahedraAloneMissWhatTheOthersFill) {
  MixedMesh mesh(size, half(Fill::hexahedron));
  const Report report = judged(mesh.document(), surface_of_all(),
                               {.region = Region::inside, .fidelity = 0, .voxels = 48, .only_tets = true});
  EXPECT_THAT(failed(report), testing::IsSupersetOf({"missing-region", "mesh-to-surface"}));
  EXPECT_TRUE(report.not_judged.empty());
  EXPECT_THAT(verdict_text(report), HasSubstr("; left out: 8 hexahedra"));
  const Report fills = judged(mesh.document(), surface_of_all({2, 2, 2}),
                              {.region = Region::inside, .fidelity = 0, .voxels = 48, .only_tets = true});
  EXPECT_TRUE(sound(fills)) << report_text(fills);
}

TEST(MixedMesh, ElementsAtUnknownPlacesMayFillAnything) {
  Document document = MixedMesh(size, half(Fill::nothing)).document();
  document.dropped.push_back({"cells of type 42", 8, "cell 3", true});
  for (const bool only_tets : {false, true}) {
    const Report report =
        judged(document, surface_of_all(),
               {.region = Region::inside, .fidelity = 0, .voxels = 48, .only_tets = only_tets});
    expect_incomplete(report);
    EXPECT_EQ(not_judged(report),
              (std::vector<std::string>{
                  "cells of type 42", "check unused-point",
                  "checks bounding-box, topology, volume-surface, volume-voxel, surface-to-mesh",
                  "check missing-region", "checks off-surface-vertex, mesh-to-surface, normals"}));
    EXPECT_EQ(report[Check::excess_region].verdict, Verdict::pass);
  }
}

TEST(MixedMesh, AHoleThatOthersFillIsNoCavity) {
  const auto around = [](Fill inside) {
    return [=](Cell c) { return c == Cell{1, 1, 1} ? inside : Fill::tetrahedra; };
  };
  const auto alone = [](const Document& document, Options options) {
    options.strict_topology = true;
    options.unjudged = verify::unjudged(document);
    return verify::verify(tet_mesh(document), options);
  };
  const Report empty = alone(MixedMesh({3, 3, 3}, around(Fill::nothing)).document(), {});
  EXPECT_EQ(failed(empty), std::vector<std::string>{"cavity"});
  Document filled = MixedMesh({3, 3, 3}, around(Fill::pyramids)).document();
  const Report full = alone(filled, {});
  expect_incomplete(full);
  EXPECT_EQ(not_judged(full), (std::vector<std::string>{"pyramids", "cavities"}));
  EXPECT_EQ(failed(alone(filled, {.only_tets = true})), std::vector<std::string>{"cavity"});
}

TEST(MixedMesh, EdgesAndVerticesBetweenOthersAreNotNonManifold) {
  // Tetrahedra in two cells that share an edge, or a vertex; all else is hexahedra, or nothing.
  for (const Cell second : {Cell{1, 1, 0}, Cell{1, 1, 1}}) {
    const auto two = [=](Fill other) {
      return [=](Cell c) { return c == Cell{0, 0, 0} || c == second ? Fill::tetrahedra : other; };
    };
    for (const Fill other : {Fill::nothing, Fill::hexahedron}) {
      const Document document = MixedMesh({2, 2, 2}, two(other)).document();
      const Report report = verify::verify(tet_mesh(document),
                                           {.strict_topology = true, .unjudged = verify::unjudged(document)});
      const bool edge = second[2] == 0;
      if (other == Fill::nothing) {
        EXPECT_EQ(failed(report), std::vector<std::string>{edge ? "boundary-nonmanifold-edge"
                                                                : "boundary-nonmanifold-vertex"});
        continue;
      }
      expect_incomplete(report);
      EXPECT_EQ(not_judged(report), (std::vector<std::string>{
                                        "hexahedra", edge ? "non-manifold edges" : "non-manifold vertices"}));
    }
  }
}

TEST(MixedMesh, AroundASolidWithALayerOfOthers) {
  // The solid is the cell in the middle. The layer around it is hexahedra, and tetrahedra are outside.
  const auto filling = [](Cell c) {
    int away = 0;
    for (const int i : c) away = std::max(away, std::abs(i - 2));
    return away == 0 ? Fill::nothing : away == 1 ? Fill::hexahedron : Fill::tetrahedra;
  };
  const TriangleSurface solid = box_surface({2, 2, 2}, 1);
  const Options options{.region = Region::outside, .fidelity = 0, .voxels = 40};
  const Report report = judged(MixedMesh({5, 5, 5}, filling).document(), solid, options);
  expect_incomplete(report);
  EXPECT_THAT(not_judged(report), testing::Contains("checks off-surface-vertex, mesh-to-surface, normals"));
  // One cell of the layer is empty: three cells of tetrahedra are beside the hole.
  const Report less = judged(MixedMesh({5, 5, 5},
                                       [&](Cell c) {
                                         return c == Cell{1, 1, 1} ? Fill::nothing : filling(c);
                                       })
                                 .document(),
                             solid, options);
  EXPECT_EQ(failed(less),
            (std::vector<std::string>{"missing-region", "off-surface-vertex", "mesh-to-surface"}));
}

TEST(MixedMesh, CurvedTetrahedraAreComparedByTheirCornersOnly) {
  const Document document = MixedMesh(size, half(Fill::tetrahedra)).document();
  Options options{.region = Region::inside, .fidelity = 0, .voxels = 48};
  options.unjudged.curved = 96;
  const Report right = verify::verify(tet_mesh(document), surface_of_all(), options);
  expect_incomplete(right);
  EXPECT_EQ(right[Check::off_surface_vertex].verdict, Verdict::pass);
  EXPECT_EQ(right[Check::topology].verdict, Verdict::pass);
  EXPECT_EQ(right[Check::volume_surface].verdict, Verdict::skipped);
  EXPECT_THAT(verdict_text(right),
              HasSubstr("incomplete: certified by corners: 96 tetrahedra; not judged: 96 "
                        "curved shapes, 8 checks"));
  const Report wrong = verify::verify(tet_mesh(document), surface_of_all({4, 2, 1}), options);
  EXPECT_EQ(failed(wrong), std::vector<std::string>{"off-surface-vertex"});
}

}  // namespace
}  // namespace tetproof::test
