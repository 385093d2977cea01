// SPDX-License-Identifier: GPL-3.0-or-later
// Hanging nodes: points on an edge or face of a tetrahedron that does not have them as vertices.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "tests/support/meshes.hpp"
#include "tests/support/root_checks.hpp"
#include "tests/unit/verify/checks/places.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Report;

bool has(const std::array<Index, 4>& tet, Index v) {
  return std::count(tet.begin(), tet.end(), v) > 0;
}

// Splits, at a new vertex, the tetrahedra around the edge a b that `split` selects.
Index split_edge(TetMesh& mesh, Index a, Index b, const Eigen::Vector3d& place,
                 const std::function<bool(Index)>& split) {
  const auto node = static_cast<Index>(mesh.points.size());
  mesh.points.push_back(place);
  const std::size_t count = mesh.tets.size();
  for (std::size_t t = 0; t < count; ++t) {
    if (!has(mesh.tets[t], a) || !has(mesh.tets[t], b) || !split(static_cast<Index>(t))) continue;
    std::array<Index, 4> other = mesh.tets[t];
    std::replace(mesh.tets[t].begin(), mesh.tets[t].end(), a, node);
    std::replace(other.begin(), other.end(), b, node);
    mesh.tets.push_back(other);
  }
  return node;
}

std::vector<Index> tets_around(const TetMesh& mesh, Index a, Index b) {
  std::vector<Index> found;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    if (has(mesh.tets[t], a) && has(mesh.tets[t], b)) found.push_back(static_cast<Index>(t));
  return found;
}

// Splits the tetrahedron into three at a new vertex on its face opposite to `corner`.
Index split_face(TetMesh& mesh, Index t, int corner, const Eigen::Vector3d& place) {
  const auto node = static_cast<Index>(mesh.points.size());
  mesh.points.push_back(place);
  const std::array<Index, 4> whole = mesh.tets[t];
  int part = 0;
  for (int i = 0; i < 4; ++i) {
    if (i == corner) continue;
    std::array<Index, 4> tet = whole;
    tet[i] = node;
    if (part++ == 0)
      mesh.tets[t] = tet;
    else
      mesh.tets.push_back(tet);
  }
  return node;
}

TEST(HangingNode, OnAnInnerEdge) {
  for (const auto& [shift, size] : places) {
    SCOPED_TRACE(testing::Message() << size << " at " << shift);
    TetMesh mesh = lattice_mesh({3, 3, 3}, {}, {shift, shift, shift}, size);
    const Index a = 21, b = 42;  // (1,1,1) and (2,2,2): the diagonal of the inner cell
    const auto around = tets_around(mesh, a, b);
    ASSERT_EQ(around.size(), 6u);
    const Index node = split_edge(mesh, a, b, (mesh.points[a] + mesh.points[b]) / 2,
                                  [&](Index t) { return t == around[0]; });
    const Report report = verify::verify(mesh);
    EXPECT_EQ(roots(report), Ids{"hanging-node"}) << report_text(report);
    EXPECT_FALSE(sound(report));
    ASSERT_EQ(report[Check::hanging_node].count, 1);
    const verify::Finding& finding = report[Check::hanging_node].findings[0];
    EXPECT_EQ(finding.vertices, (std::vector<Index>{node}));
    EXPECT_EQ(finding.point, mesh.points[node]);
    EXPECT_EQ(finding.faces.size(), 2u + 4u) << "on two whole faces, and two halves of each opposite";
    for (std::size_t i = 0; i < finding.faces.size(); ++i)
      EXPECT_EQ(std::count(finding.faces[i].begin(), finding.faces[i].end(), node), i < 2 ? 0 : 1);
    const std::set<Index> tets(finding.tets.begin(), finding.tets.end());
    EXPECT_TRUE(tets.contains(around[0]));
    EXPECT_EQ(tets.size(), 4u);
  }
}

TEST(HangingNode, OnAnEdgeOfTheBoundaryAndOnItsFlatSide) {
  for (const auto& [b_place, kept] :
       {std::pair{Eigen::Vector3d(1, 0, 0), 0}, {Eigen::Vector3d(0, 1, 1), 0}}) {
    TetMesh mesh = lattice_mesh({2, 2, 2});
    const Index a = point_at(mesh, {0, 0, 0}), b = point_at(mesh, b_place);
    const auto around = tets_around(mesh, a, b);
    ASSERT_GE(around.size(), 2u);
    split_edge(mesh, a, b, (mesh.points[a] + mesh.points[b]) / 2,
               [&, i = kept](Index t) { return t == around[i]; });
    const Report report = verify::verify(mesh);
    EXPECT_EQ(roots(report), Ids{"hanging-node"}) << report_text(report);
    EXPECT_GT(report[Check::boundary_self_intersection].consequences, 0);
    EXPECT_EQ(report.certificate, false);
  }
}

TEST(HangingNode, InsideAFace) {
  TetMesh mesh = lattice_mesh({3, 3, 3});
  const Index t = 13 * 6;
  for (int corner = 0; corner < 4; ++corner) {
    TetMesh bad = mesh;
    Eigen::Vector3d sum{0, 0, 0};
    for (int i = 0; i < 4; ++i)
      if (i != corner) sum += (i == (corner + 1) % 4 ? 2 : 1) * mesh.points[mesh.tets[t][i]];
    const Index node = split_face(bad, t, corner, sum / 4);
    const Report report = verify::verify(bad);
    EXPECT_EQ(roots(report), Ids{"hanging-node"}) << report_text(report);
    ASSERT_EQ(report[Check::hanging_node].count, 1);
    EXPECT_EQ(report[Check::hanging_node].findings[0].vertices, (std::vector<Index>{node}));
    EXPECT_EQ(report[Check::hanging_node].findings[0].faces.size(), 4u);
  }
}

TEST(HangingNode, OffTheEdgeByRounding) {
  // The node is off the edge by units in the last place, in every direction. That makes a slit, an overlap,
  // or both. The certificate may hold, but the finding must be there.
  bool held = false, failed = false;
  for (int i = 0; i < 81; ++i) {
    const int direction = i % 27;
    const auto& [shift, size] = places[i / 27];
    SCOPED_TRACE(testing::Message() << direction << ", " << size << " at " << shift);
    TetMesh mesh = lattice_mesh({3, 3, 3}, {},
                                Eigen::Vector3d(shift, shift, shift) + size * Eigen::Vector3d(0.1, 0.2, 0.3),
                                0.7 * size);
    const Index a = 21, b = 42;
    const auto around = tets_around(mesh, a, b);
    Eigen::Vector3d place = (mesh.points[a] + mesh.points[b]) / 2;
    for (int k = 0, rest = direction; k < 3; ++k, rest /= 3)
      for (int ulp = 0; ulp < 2 && rest % 3 != 1; ++ulp)
        place[k] = std::nextafter(place[k], rest % 3 ? INFINITY : -INFINITY);
    split_edge(mesh, a, b, place, [&](Index t) { return t == around[0]; });
    const Report report = verify::verify(mesh);
    EXPECT_EQ(roots(report), Ids{"hanging-node"}) << report_text(report);
    EXPECT_FALSE(sound(report));
    (report.certificate == true ? held : failed) = true;
  }
  EXPECT_TRUE(held);
  EXPECT_TRUE(failed);
}

TEST(HangingNode, FartherOffIsAnotherMatter) {
  // Off by much more than rounding. This is a real slit: the triangulation is valid and has a cavity.
  TetMesh mesh = lattice_mesh({3, 3, 3});
  const Index t = 13 * 6;
  const std::array<Index, 4> tet = mesh.tets[t];
  const Eigen::Vector3d face = (mesh.points[tet[1]] + mesh.points[tet[2]] + mesh.points[tet[3]]) / 3;
  split_face(mesh, t, 0, face + 1e-9 * (mesh.points[tet[0]] - face));
  const Report report = verify::verify(mesh);
  EXPECT_EQ(report[Check::hanging_node].count, 0) << report_text(report);
  EXPECT_EQ(report.certificate, true);
  EXPECT_EQ(roots(report), Ids{"cavity"});
}

TEST(HangingNode, AFineBlockOnACoarseOne) {
  // Beyond the plane x = 2 the cells have half the size, and the nodes between the coarse ones hang. Both
  // blocks share the points that coincide.
  TetMesh mesh = lattice_mesh({2, 2, 2});
  const TetMesh fine = lattice_mesh({2, 4, 4}, {}, {2, 0, 0}, 0.5);
  std::vector<Index> number;
  for (const Eigen::Vector3d& p : fine.points) {
    Index same = point_at(mesh, p);
    if (same == static_cast<Index>(mesh.points.size())) mesh.points.push_back(p);
    number.push_back(same);
  }
  for (auto tet : fine.tets) {
    for (Index& v : tet) v = number[v];
    mesh.tets.push_back(tet);
  }
  const Report report = verify::verify(mesh);
  EXPECT_EQ(roots(report), Ids{"hanging-node"}) << report_text(report);
  EXPECT_EQ(report[Check::hanging_node].count, 25 - 9);
}

TEST(HangingNode, NodesOnBothSides) {
  // A common face is cut at one edge on one side and at another edge on the other side. Neither side has the
  // whole face.
  TetMesh mesh{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 3}, {1, 1, -3}}, {{0, 1, 2, 3}, {0, 2, 1, 4}}};
  split_edge(mesh, 0, 1, {2, 0, 0}, [](Index t) { return t == 0; });
  split_edge(mesh, 1, 2, {2, 2, 0}, [](Index t) { return t == 1; });
  const Report report = verify::verify(mesh);
  EXPECT_EQ(roots(report), Ids{"hanging-node"}) << report_text(report);
  ASSERT_EQ(report[Check::hanging_node].count, 2);
  EXPECT_EQ(report[Check::hanging_node].findings[0].vertices, (std::vector<Index>{5}));
  EXPECT_EQ(report[Check::hanging_node].findings[1].vertices, (std::vector<Index>{6}));
}

TEST(HangingNode, AnotherDefectBesideItIsARootOfItsOwn) {
  TetMesh mesh = lattice_mesh({3, 3, 3});
  const Index a = 21, b = 42;
  const auto around = tets_around(mesh, a, b);
  split_edge(mesh, a, b, (mesh.points[a] + mesh.points[b]) / 2, [&](Index t) { return t == around[0]; });
  // A separate tetrahedron that passes through a face on which the node hangs.
  const auto first = static_cast<Index>(mesh.points.size());
  const Eigen::Vector3d c = (mesh.points[a] + mesh.points[b]) / 2;
  for (const Eigen::Vector3d& d :
       {Eigen::Vector3d(0.2, 0, 0), {0, 0.2, 0.01}, {0.01, 0, 0.2}, {-0.2, -0.21, -0.19}})
    mesh.points.push_back(c + d);
  mesh.tets.push_back({first, first + 1, first + 2, first + 3});
  if ((mesh.points[first + 1] - mesh.points[first])
          .cross(mesh.points[first + 2] - mesh.points[first])
          .dot(mesh.points[first + 3] - mesh.points[first]) < 0)
    std::swap(mesh.tets.back()[0], mesh.tets.back()[1]);
  const Report report = verify::verify(mesh);
  EXPECT_EQ(roots(report), (Ids{"hanging-node", "boundary-self-intersection"})) << report_text(report);
}

}  // namespace
}  // namespace tetproof::test
