// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh cut open: whole tetrahedra, and each face that one sees once. Also the outline of the part of the
// surface that is gone.
#include "reference/figure/cut_open.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "corpus/surfaces.hpp"
#include "reference/figure/near_part.hpp"
#include "tests/unit/reference/figure/sections.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;
using test::block;

double volume_of(const TetMesh& mesh, const std::vector<Index>& tets) {
  double sum = 0;
  for (const Index t : tets) {
    Eigen::Matrix3d edges;
    for (int i = 0; i < 3; ++i)
      edges.col(i) = mesh.points[mesh.tets[t][i + 1]] - mesh.points[mesh.tets[t][0]];
    sum += std::abs(edges.determinant()) / 6;
  }
  return sum;
}

// The volume that the faces enclose, by the divergence theorem. They must have the same orientation.
double enclosed(const TetMesh& mesh, const std::vector<OpenFace>& faces) {
  double sum = 0;
  for (const OpenFace& face : faces) {
    const auto& [a, b, c] = face.corners;
    sum += mesh.points[a].dot(mesh.points[b].cross(mesh.points[c])) / 6;
  }
  return std::abs(sum);
}

void expect_closed(const std::vector<OpenFace>& faces) {
  std::map<std::pair<Index, Index>, int> edges;
  for (const OpenFace& face : faces)
    for (int i = 0; i < 3; ++i) {
      const Index p = face.corners[i], q = face.corners[(i + 1) % 3];
      edges[std::minmax(p, q)] += p < q ? 1 : -1;
    }
  for (const auto& [edge, count] : edges) EXPECT_EQ(count, 0);
}

TEST(CutOpen, LeavesWholeCellsOfABlock) {
  const TetMesh mesh = block(4);
  for (int axis = 0; axis < 3; ++axis)
    for (const auto& [offset, cells] :
         {std::pair(0.6, 2), {0.5, 2}, {std::nextafter(0.5, 0), 1}, {0.25, 1}, {1.0, 4}, {9.0, 4}}) {
      const CutOpen open = cut_open(mesh, {Vector3d::Unit(axis), offset});
      // Each tetrahedron of a cell reaches from one side of it to the other, so that layers of cells are
      // left.
      EXPECT_EQ(open.tets.size(), cells * 16u * 6u);
      EXPECT_EQ(open.faces.size(), 2 * 2 * 16u + 4 * 2 * 4u * cells);
      std::size_t cuts = 0;
      for (const OpenFace& face : open.faces) {
        cuts += face.is_cut;
        for (const Index i : face.corners)
          EXPECT_TRUE(!face.is_cut || mesh.points[i][axis] == cells / 4.0) << "a cut face off the cut";
      }
      EXPECT_EQ(cuts, cells < 4 ? 32u : 0u);
      expect_closed(open.faces);
      EXPECT_NEAR(enclosed(mesh, open.faces), cells / 4.0, 1e-14);
      // The other way round, the plane leaves the other part.
      EXPECT_EQ(cut_open(mesh, {-Vector3d::Unit(axis), -0.25 * cells}).tets.size(), (4 - cells) * 16u * 6u);
    }
  EXPECT_TRUE(cut_open(mesh, {Vector3d::UnitX(), 0.2}).tets.empty());
  EXPECT_TRUE(cut_open(mesh, {Vector3d::UnitX(), 0.2}).faces.empty());
}

TEST(CutOpen, LeavesWhatIsWhollyBehindAnyPlane) {
  const TetMesh mesh = block(5);
  for (const Vector3d& normal : {Vector3d(1, 2, 3), Vector3d(-1, 0.3, 0.2), Vector3d(0, 1, -1)}) {
    const Plane plane{normal, 0.4 * normal.sum()};
    const CutOpen open = cut_open(mesh, plane);
    std::vector<Index> expected;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      bool behind = true;
      for (const Index i : mesh.tets[t]) behind = behind && normal.dot(mesh.points[i]) <= plane.offset;
      if (behind) expected.push_back(static_cast<Index>(t));
    }
    EXPECT_GT(expected.size(), 50u);
    EXPECT_EQ(open.tets, expected);
    expect_closed(open.faces);
    EXPECT_NEAR(enclosed(mesh, open.faces), volume_of(mesh, open.tets), 1e-14);
  }
}

TEST(CutOpen, FacesAreWoundOutwardAndKnowTheirTetrahedron) {
  // Two tetrahedra with a common face; one is behind the plane.
  // The order of its vertices does not matter.
  for (const std::array<Index, 4>& tet : {std::array{0, 2, 1, 3}, std::array{0, 1, 2, 3}}) {
    const TetMesh mesh{.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}},
                       .tets = {{0, 1, 2, 4}, tet}};
    const CutOpen open = cut_open(mesh, {Vector3d::UnitZ(), 0});
    EXPECT_EQ(open.tets, std::vector<Index>{1});
    ASSERT_EQ(open.faces.size(), 4u);
    int cuts = 0;
    for (const OpenFace& face : open.faces) {
      EXPECT_EQ(face.tet, 1);
      const Vector3d a = mesh.points[face.corners[0]], b = mesh.points[face.corners[1]],
                     c = mesh.points[face.corners[2]];
      EXPECT_GT((b - a).cross(c - a).dot((a + b + c) / 3 - Vector3d(0.25, 0.25, -0.25)), 0);
      EXPECT_EQ(face.is_cut, a.z() + b.z() + c.z() == 0);
      cuts += face.is_cut;
    }
    EXPECT_EQ(cuts, 1);
  }
}

TEST(CutOpen, ATetrahedronWithoutAPlaceIsGone) {
  TetMesh mesh = block(1);
  mesh.points[0].x() = std::numeric_limits<double>::quiet_NaN();  // all six have the diagonal from here
  EXPECT_TRUE(cut_open(mesh, {Vector3d::UnitX(), 2}).tets.empty());
  EXPECT_TRUE(cut_open({}, {Vector3d::UnitX(), 2}).faces.empty());
}

double area(const std::vector<std::vector<Vector3d>>& lines, const Vector3d& view) {
  double twice = 0;
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i)
      twice += line[i].cross(line[(i + 1) % line.size()]).dot(view.normalized());
  return twice / 2;
}

TEST(NearPart, HasTheAreaOfWhatOneSees) {
  const TriangleSurface sphere = corpus::open_surface("sphere:r=1,n=20000");
  const Vector3d x = Vector3d::UnitX();
  const auto near = [&](double at, const Vector3d& view) { return near_part_outline(sphere, {x, at}, view); };
  EXPECT_EQ(near(0, x).size(), 1u);
  EXPECT_NEAR(area(near(0, x), x), 3.1416, 2e-3);                   // the half sphere from the front
  EXPECT_NEAR(area(near(0.6, x), x), 0.64 * 3.1416, 2e-3);          // the cap
  EXPECT_NEAR(area(near(-0.6, x), x), 3.1416, 2e-3);                // more than a half: the whole disc
  EXPECT_NEAR(area(near(0, {0, 0, 2}), {0, 0, 2}), 1.5708, 2e-3);   // from the side: half a disc
  EXPECT_NEAR(area(near(-2, {1, 2, 3}), {1, 2, 3}), 3.1416, 2e-3);  // nothing is cut
  EXPECT_TRUE(near(1.1, x).empty());
  // From (1, 1, 0), the near half shows half of its rim's ellipse and half of a disc.
  EXPECT_NEAR(area(near(0, {1, 1, 0}), {1, 1, 0}), 1.5708 * (1 + std::sqrt(0.5)), 2e-3);
  // Around a hole: the ring, seen along its axis, and its half.
  const TriangleSurface torus = corpus::open_surface("torus:R=1,r=0.4,n=20000");
  const Vector3d z = Vector3d::UnitZ();
  EXPECT_EQ(near_part_outline(torus, {z, 0}, z).size(), 2u);
  EXPECT_NEAR(area(near_part_outline(torus, {z, -1}, z), z), 3.1416 * (1.96 - 0.36), 5e-3);
  EXPECT_NEAR(area(near_part_outline(torus, {x, 0}, z), z), 1.5708 * (1.96 - 0.36), 5e-3);
  // A plane through vertices and along faces.
  const TriangleSurface box = corpus::open_surface("box:n=2");
  for (const double at : {0.0, 0.5, 0.3})
    EXPECT_NEAR(area(near_part_outline(box, {x, at}, {1, 0, 1}), {1, 0, 1}) * std::sqrt(2), 1 + (1 - at),
                1e-14);
  EXPECT_TRUE(near_part_outline(box, {x, 1}, x).empty());
  EXPECT_TRUE(near_part_outline({}, {x, 0}, x).empty());
}

}  // namespace
}  // namespace tetproof::reference
