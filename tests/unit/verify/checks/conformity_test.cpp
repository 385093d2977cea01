// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that lack their partner: hanging nodes, crossed diagonals, cracks, and what all but touches. Each is
// planted in a sound mesh and is the one root; what it brings along stands under it.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <set>

#include "tests/support/meshes.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::UnorderedElementsAre;
using verify::Check;
using verify::Report;
using verify::Verdict;
using Ids = std::vector<std::string>;

Ids roots(const Report& report) {
  Ids ids;
  for (const auto& result : report.checks)
    if (result.count > 0) ids.push_back(info(result.check).id);
  return ids;
}

bool has(const std::array<Index, 4>& tet, Index v) {
  return std::count(tet.begin(), tet.end(), v) > 0;
}

// Splits tetrahedra with the edge a b at a new vertex, those that `split` picks.
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

// A mesh of the given lattice around another place, in another size.
struct Place {
  double shift, size;
};
constexpr std::array places{Place{0, 1}, Place{1e6, 1}, Place{0, 1e-9}};

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
  // Off the edge by units in the last place to every side: a slit, an overlap, or both. The certificate may
  // hold; the finding stays.
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
  // Off by far more than rounding: a real slit, which leaves a valid triangulation with a cavity.
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
  // Cells of half the size on one side of the plane x = 2: the nodes between the coarse ones hang. The first
  // block's points that lie there are the second block's.
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
  // A face of both sides is cut on one side at one edge and on the other at another: neither has the whole
  // face.
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
  // A tetrahedron of its own through one of the faces on which the node hangs.
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

// The cells of a lattice of which two are cut along the other diagonal of their common side.
TetMesh with_crossed_diagonals(double bend) {
  // Two pyramids' worth of tetrahedra on a square, cut differently.
  TetMesh mesh{{{0, 0, 0}, {1, 0, bend}, {1, 1, 0}, {0, 1, bend}, {0.5, 0.5, 1}, {0.5, 0.5, -1}},
               {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 3, 1, 5}, {1, 3, 2, 5}}};
  return mesh;
}

TEST(CrossedDiagonal, OnAFlatOrRoundedQuadrilateral) {
  const double ulp = std::numeric_limits<double>::denorm_min();
  for (const double bend : {0.0, ulp, -ulp, 1e-16, -1e-16, 1e-13, -1e-13}) {
    SCOPED_TRACE(bend);
    const Report report = verify::verify(with_crossed_diagonals(bend));
    EXPECT_EQ(roots(report), Ids{"crossed-diagonal"}) << report_text(report);
    ASSERT_EQ(report[Check::crossed_diagonal].count, 1);
    const verify::Finding& finding = report[Check::crossed_diagonal].findings[0];
    EXPECT_THAT(finding.vertices, UnorderedElementsAre(0, 1, 2, 3));
    EXPECT_THAT(finding.tets, UnorderedElementsAre(0, 1, 2, 3));
    EXPECT_EQ(finding.faces.size(), 4u);
    EXPECT_FALSE(sound(report));
  }
}

TEST(CrossedDiagonal, OnABentQuadrilateral) {
  // Bent one way the tetrahedra overlap, bent the other a tetrahedron is missing.
  const Report one = verify::verify(with_crossed_diagonals(0.1)),
               other = verify::verify(with_crossed_diagonals(-0.1));
  const bool first_overlaps = one[Check::crossed_diagonal].count == 1;
  EXPECT_EQ(roots(first_overlaps ? one : other), Ids{"crossed-diagonal"})
      << report_text(one) << report_text(other);
  EXPECT_EQ((first_overlaps ? one : other)[Check::overlap].consequences, 2);
  EXPECT_EQ((first_overlaps ? one : other).certificate, false);
  EXPECT_EQ(roots(first_overlaps ? other : one), Ids{"boundary-nonmanifold-edge"})
      << report_text(one) << report_text(other);
}

TEST(CrossedDiagonal, ATetrahedronCutIntoFourIsSound) {
  TetMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 0.2}},
               {{4, 1, 2, 3}, {0, 4, 2, 3}, {0, 1, 4, 3}, {0, 1, 2, 4}}};
  EXPECT_EQ(roots(verify::verify(mesh)), Ids{});
  for (Eigen::Vector3d& p : mesh.points) p *= 1e-14;  // beside a large block it is all but a point
  const Report report = verify::verify(together(lattice_mesh({2, 2, 2}), [&] {
    for (Eigen::Vector3d& p : mesh.points) p += Eigen::Vector3d(3, 0, 0);
    return mesh;
  }()));
  EXPECT_EQ(report[Check::crossed_diagonal].count + report[Check::hanging_node].count, 0)
      << report_text(report);
}

// A block of which the tetrahedra that `apart` picks have points of their own.
TetMesh cracked(const TetMesh& mesh, const std::function<bool(Index)>& apart) {
  TetMesh bad = mesh;
  std::map<Index, Index> own;
  std::vector<std::uint8_t> kept(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const Index v : mesh.tets[t])
      if (!apart(static_cast<Index>(t))) kept[v] = 1;
  for (std::size_t t = 0; t < bad.tets.size(); ++t) {
    if (!apart(static_cast<Index>(t))) continue;
    for (Index& v : bad.tets[t]) {
      if (!kept[v]) continue;
      const auto [at, added] = own.try_emplace(v, static_cast<Index>(bad.points.size()));
      if (added) bad.points.push_back(mesh.points[v]);
      v = at->second;
    }
  }
  return bad;
}

TEST(Crack, BetweenTwoHalves) {
  const TetMesh mesh = lattice_mesh({4, 2, 2});
  const Report report = verify::verify(cracked(mesh, [](Index t) { return t >= 2 * 2 * 2 * 6; }));
  EXPECT_EQ(roots(report), Ids{"crack"}) << report_text(report);
  EXPECT_EQ(report[Check::crack].count, 8);
  EXPECT_EQ(report[Check::duplicate_point].consequences, 9);
  EXPECT_EQ(report[Check::duplicate_point].count, 0);
  EXPECT_EQ(report.certificate, false);
  const verify::Finding& finding = report[Check::crack].findings[0];
  EXPECT_EQ(finding.tets.size(), 2u);
  EXPECT_EQ(finding.faces.size(), 2u);
  EXPECT_EQ(finding.vertices.size(), 6u);
  EXPECT_EQ(report.mesh.components, 1) << "with its cracks closed";
  EXPECT_DOUBLE_EQ(*report.mesh.volume, 16);
}

TEST(Crack, AroundOneTetrahedron) {
  for (const Index t : {0, 13 * 6}) {
    const Report report = verify::verify(cracked(lattice_mesh({3, 3, 3}), [=](Index i) { return i == t; }));
    EXPECT_EQ(roots(report), Ids{"crack"}) << report_text(report);
  }
}

TEST(Crack, EveryTetrahedronForItself) {
  const TetMesh mesh = lattice_mesh({12, 12, 12});
  TetMesh exploded;
  for (const auto& tet : mesh.tets) {
    const auto first = static_cast<Index>(exploded.points.size());
    for (const Index v : tet) exploded.points.push_back(mesh.points[v]);
    exploded.tets.push_back({first, first + 1, first + 2, first + 3});
  }
  const Report report = verify::verify(exploded);
  EXPECT_EQ(roots(report), Ids{"crack"}) << report_text(report);
  const std::int64_t inner = (4 * 6 * 1728 - 2 * 6 * 144) / 2;
  EXPECT_EQ(report[Check::crack].count, inner);
  EXPECT_EQ(report[Check::duplicate_point].consequences, 13 * 13 * 13) << "every corner has several";
  EXPECT_EQ(report.mesh.boundary_faces, 4 * 6 * 1728) << "as written";
}

TEST(Crack, WhatElseIsWrongIsFoundBehindIt) {
  // One half moved onto the other: points equal along the crack, and beside it two blocks overlap.
  TetMesh bad = cracked(lattice_mesh({4, 2, 2}), [](Index t) { return t >= 2 * 2 * 2 * 6; });
  bad = together(bad, lattice_mesh({1, 1, 1}, {}, {3.25, 0.25, 0.25}, 0.5));
  const Report report = verify::verify(bad);
  EXPECT_EQ(roots(report), (Ids{"crack", "overlap"})) << report_text(report);
  // A tetrahedron twice, each time with points of its own: closed, its faces belong to three.
  const TetMesh mesh = lattice_mesh({2, 2, 2});
  TetMesh twice = cracked(mesh, [](Index t) { return t % 2 == 0; });
  const auto first = static_cast<Index>(twice.points.size());
  for (const Index v : mesh.tets[5]) twice.points.push_back(mesh.points[v]);
  twice.tets.push_back({first, first + 1, first + 2, first + 3});
  const Report again = verify::verify(twice);
  EXPECT_THAT(roots(again), Contains("crack"));
  EXPECT_EQ(again.certificate, false);
  EXPECT_GT(again[Check::overlap].count + again[Check::boundary_self_intersection].count, 0)
      << report_text(again);
}

TEST(Crack, TwoBlocksInOnePlaceAreNone) {
  const TetMesh mesh = lattice_mesh({1, 1, 1});
  const Report report = verify::verify(together(mesh, mesh));
  EXPECT_EQ(report[Check::crack].count, 0);
  EXPECT_GT(report[Check::boundary_self_intersection].count, 0);
  EXPECT_EQ(report.certificate, false);
}

TEST(NearContact, BlocksThatAllButTouch) {
  const TetMesh block = lattice_mesh({1, 1, 1});
  struct Gap {
    double width;
    bool near;
  };
  for (const Gap& gap : {Gap{1e-15, true}, {1e-13, true}, {1e-10, false}, {0.1, false}}) {
    SCOPED_TRACE(gap.width);
    const TetMesh mesh = together(block, lattice_mesh({1, 1, 1}, {}, {1 + gap.width, 0.25, 0.3}, 0.5));
    const Report report = verify::verify(mesh);
    EXPECT_EQ(roots(report), gap.near ? Ids{"near-contact"} : Ids{}) << report_text(report);
    EXPECT_TRUE(sound(report));
    EXPECT_EQ(report.certificate, true);
    if (!gap.near) continue;
    EXPECT_EQ(report[Check::near_contact].verdict, Verdict::warning);
    EXPECT_NEAR(*report[Check::near_contact].measured, gap.width, 4e-16);
    EXPECT_EQ(report[Check::near_contact].findings[0].faces.size(), 2u);
    EXPECT_EQ(report[Check::near_contact].findings[0].tets.size(), 2u);
  }
}

TEST(NearContact, EdgesThatAllButTouch) {
  // Two tetrahedra, edge over edge crosswise.
  for (const auto& [gap, near] : {std::pair{1e-13, true}, {1e-10, false}}) {
    const TetMesh mesh{{{-1, 0, 0},
                        {1, 0, 0},
                        {0.1, 1, -1},
                        {0, -1, -1},
                        {0, -1, gap},
                        {0, 1, gap},
                        {1, 0.1, 1},
                        {-1, 0, 1}},
                       {{0, 2, 1, 3}, {4, 5, 6, 7}}};
    TetMesh positive = mesh;
    for (auto& tet : positive.tets)
      if ((mesh.points[tet[1]] - mesh.points[tet[0]])
              .cross(mesh.points[tet[2]] - mesh.points[tet[0]])
              .dot(mesh.points[tet[3]] - mesh.points[tet[0]]) < 0)
        std::swap(tet[0], tet[1]);
    EXPECT_EQ(roots(verify::verify(positive)), near ? Ids{"near-contact"} : Ids{});
  }
}

// A block so small beside another that all its faces are near each other, quadratically many pairs: what is
// near is then not told, and all the rest is.
TEST(NearContact, ACrowdOfTinyFacesEndsTheSearch) {
  const Report report = verify::verify(
      together(lattice_mesh({2, 2, 2}, {}, {1, 0, 0}), lattice_mesh({12, 12, 12}, {}, {0, 0, 0}, 1e-14)));
  EXPECT_EQ(report.certificate, true) << report_text(report);
  EXPECT_EQ(report[Check::near_contact].verdict, Verdict::skipped);
  EXPECT_EQ(report[Check::hanging_node].verdict, Verdict::skipped);
  EXPECT_EQ(report[Check::boundary_self_intersection].verdict, Verdict::pass);
  ASSERT_EQ(report.notes.size(), 1u);
  EXPECT_THAT(report.notes[0], testing::StartsWith("more than 1000000 pairs of boundary faces are near"));
}

TEST(NearContact, ShortEdgesAreNone) {
  // A lattice with a plane of cells as thin as 1e-14 of it: everything there is near everything, and hangs
  // together.
  for (const double thin : {1e-14, 1e-13, 3e-13, 1e-12}) {
    TetMesh mesh = lattice_mesh({4, 3, 3});
    for (Eigen::Vector3d& p : mesh.points)
      for (int k = 0; k < 3; ++k) p[k] = p[k] == 0 ? 0 : p[k] == 1 ? thin : p[k] - 1;
    const Report report = verify::verify(mesh);
    EXPECT_EQ(roots(report), Ids{}) << thin << report_text(report);
  }
}

TEST(Conformity, SoundMeshesHaveNone) {
  const auto hollow = [](Cell c) { return !(c[0] == 1 && c[1] == 1); };
  for (const auto& [shift, size] : places) {
    for (const TetMesh& mesh : {lattice_mesh({4, 3, 3}, {}, {shift, shift, shift}, size),
                                lattice_mesh({3, 3, 4}, hollow, {shift, shift, shift}, size)})
      EXPECT_EQ(roots(verify::verify(mesh)), Ids{});
  }
}

// The outside of a tetrahedron cut into four looks like crossed diagonals by its numbers alone.
TEST(CrossedDiagonal, ATetrahedronCutIntoFourInsideAnotherIsAnOverlap) {
  const TetMesh mesh{{{0, 0, 0},
                      {4, 0, 0},
                      {0, 4, 0},
                      {0, 0, 4},
                      {0.5, 0.5, 0.5},
                      {1.5, 0.5, 0.5},
                      {0.5, 1.5, 0.5},
                      {0.5, 0.5, 1.5},
                      {0.75, 0.75, 0.75}},
                     {{0, 1, 2, 3}, {8, 5, 6, 7}, {4, 8, 6, 7}, {4, 5, 8, 7}, {4, 5, 6, 8}}};
  const Report report = verify::verify(mesh);
  EXPECT_EQ(report[Check::crossed_diagonal].count, 0) << report_text(report);
  EXPECT_EQ(report[Check::overlap].count, 1) << report_text(report);
}

}  // namespace
}  // namespace tetproof::test
