// SPDX-License-Identifier: GPL-3.0-or-later
// A user's test suite that fuzzes his mesher, a C++ function with a bug: as a campaign in slices, and as a
// property of RapidCheck. Both fail; fails_as_promised.cmake checks what they print and write.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>

#include <stdexcept>
#include <utility>

#include <tetproof/corpus/check_mesher.hpp>
#include <tetproof/corpus/rapidcheck.hpp>

namespace {

using tetproof::TetMesh;
using tetproof::TriangleSurface;

// The user's mesher: joins all triangles to the centroid of the vertices, and says so where that does not see
// them all. Its bug: from 16 triangles on it takes the vertices of one tetrahedron in the wrong order.
TetMesh my_mesher(const TriangleSurface& surface) {
  TetMesh mesh;
  mesh.points = surface.vertices;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : surface.vertices)
    centre += v / static_cast<double>(surface.vertices.size());
  const auto apex = static_cast<tetproof::Index>(mesh.points.size());
  mesh.points.push_back(centre);
  for (const auto& t : surface.triangles) {
    const auto edge = [&](int k) -> Eigen::Vector3d { return surface.vertices[t[k]] - centre; };
    if (edge(0).dot(edge(1).cross(edge(2))) <= 0) throw std::runtime_error("the solid is not star-shaped");
    mesh.tets.push_back({t[0], t[2], t[1], apex});
  }
  if (mesh.tets.size() >= 16) std::swap(mesh.tets[5][0], mesh.tets[5][1]);
  return mesh;
}

const tetproof::corpus::FuzzOptions convex{.kinds = {"cylinder", "bipyramid"}, .modifiers = {"none"}};

// --- these lines, with his own function, are all that a user needs
class MyMesher : public testing::TestWithParam<int> {};
TEST_P(MyMesher, MeshesHardSurfaces) {
  const auto checked = tetproof::corpus::check_mesher(
      my_mesher,
      {.cases = 40, .slice = GetParam(), .slices = 4, .surfaces = convex, .shrink_s = 20, .folder = "found"});
  EXPECT_TRUE(checked.good) << checked.message;
}
INSTANTIATE_TEST_SUITE_P(Slices, MyMesher, testing::Range(0, 4));

// --- or as a property
RC_GTEST_PROP(MyMesherProperty, MeshesHardSurfaces, ()) {
  const auto random = *tetproof::corpus::fuzz_surfaces(convex);
  const auto checked = tetproof::corpus::check_mesher_on(random.surface, my_mesher, "smallest.off");
  if (!checked.good) RC_FAIL(checked.message);
}

}  // namespace
