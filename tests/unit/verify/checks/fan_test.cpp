// SPDX-License-Identifier: GPL-3.0-or-later
// Fans of many tetrahedra around one edge or vertex, sound and with one planted defect each.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/meshes.hpp"
#include "tests/support/root_checks.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Report;

// n tetrahedra around the edge from vertex 0 (above) to vertex 1 (below), from `begin` to `end` in turns. The
// fan is closed if that is one turn. The ring lies in the plane z = 0; vertex 2 is its first.
TetMesh fan(int n, double begin = 0, double end = 1, double shift = 0) {
  TetMesh mesh;
  mesh.points = {{0, 0, 1 + shift}, {0, 0, -1 + shift}};
  const bool closed = end - begin == 1;
  const int ring = closed ? n : n + 1;
  for (int i = 0; i < ring; ++i) {
    const double angle = 2 * std::numbers::pi * (begin + (end - begin) * i / n);
    const double r = i % 2 ? 1 : 1.25;
    mesh.points.emplace_back(r * std::cos(angle), r * std::sin(angle), shift);
  }
  for (int i = 0; i < n; ++i) mesh.tets.push_back({1, 0, 2 + i, 2 + (i + 1) % ring});
  return mesh;
}

// Both meshes together. The vertices of `other` that are keys of `same` are vertices of `mesh`.
TetMesh glued(TetMesh mesh, const TetMesh& other, const std::map<Index, Index>& same) {
  std::vector<Index> number;
  for (Index v = 0; v < static_cast<Index>(other.points.size()); ++v) {
    const auto known = same.find(v);
    number.push_back(known != same.end() ? known->second : static_cast<Index>(mesh.points.size()));
    if (known == same.end()) mesh.points.push_back(other.points[v]);
  }
  for (const auto& [a, b, c, d] : other.tets)
    mesh.tets.push_back({number[a], number[b], number[c], number[d]});
  return mesh;
}

TEST(Fans, AreCertified) {
  const Report closed = verify::verify(fan(500));
  EXPECT_EQ(roots(closed), Ids{});
  EXPECT_EQ(closed.certificate, true);
  EXPECT_EQ(closed.mesh.boundary_faces, 1000);

  const Report open = verify::verify(fan(500, 0, 0.7));
  EXPECT_EQ(roots(open), Ids{});
  EXPECT_EQ(open.certificate, true);
  EXPECT_EQ(open.mesh.boundary_faces, 1002);
}

TEST(Fans, TwoAtOneEdge) {
  // Both belong to the edge from 0 to 1, with gaps between them.
  const Report report = verify::verify(glued(fan(300, 0, 0.45), fan(200, 0.5, 0.95), {{0, 0}, {1, 1}}));
  EXPECT_EQ(roots(report), Ids{"boundary-nonmanifold-edge"});
  EXPECT_EQ(report[Check::boundary_nonmanifold_edge].count, 1);
  EXPECT_EQ(report[Check::boundary_nonmanifold_edge].findings[0].faces.size(), 4u);
  EXPECT_EQ(report.certificate, true);
  EXPECT_EQ(report.mesh.components, 2) << "one for each wedge of tetrahedra at the edge";
}

TEST(Fans, TwoAtOneVertex) {
  const Report report = verify::verify(glued(fan(300), fan(200, 0, 1, 2), {{1, 0}}));
  EXPECT_EQ(roots(report), Ids{"boundary-nonmanifold-vertex"});
  EXPECT_EQ(report[Check::boundary_nonmanifold_vertex].findings[0].vertices, std::vector<Index>{0});
  EXPECT_EQ(report.certificate, true);
}

// A small tetrahedron of its own around a place.
TetMesh speck(const Eigen::Vector3d& place, double size) {
  TetMesh mesh;
  for (const Eigen::Vector3d& corner : {Eigen::Vector3d(1, 1, 1), {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}})
    mesh.points.push_back(place + size * corner);
  mesh.tets.push_back({1, 0, 2, 3});
  return mesh;
}

TEST(Fans, AnotherPartOverlaps) {
  const TetMesh mesh = fan(500);
  const Eigen::Vector3d hub = mesh.points[0], ring = (mesh.points[202] + mesh.points[203]) / 2;
  struct Place {
    std::string name;
    Eigen::Vector3d at;
    double size;
    std::string root;
  };
  for (const Place& p :
       {Place{"a face at the hub, near the ring", hub + 0.99 * (ring - hub), 1e-4,
              "boundary-self-intersection"},
        {"a face at the hub, near the hub", hub + 1e-4 * (ring - hub), 1e-7, "boundary-self-intersection"},
        {"the hub itself", hub, 1e-3, "boundary-self-intersection"},
        {"inside", {0.3, 0.2, 0.1}, 1e-3, "overlap"},
        {"outside", {0.3, 0.2, 2}, 1e-3, ""}}) {
    SCOPED_TRACE(p.name);
    const Report report = verify::verify(glued(mesh, speck(p.at, p.size), {}));
    EXPECT_EQ(roots(report), p.root.empty() ? Ids{} : Ids{p.root});
    EXPECT_EQ(report.certificate, p.root.empty());
  }
}

TEST(Fans, OneTetrahedronTooFar) {
  // An open fan that goes on past its beginning: its last tetrahedra lie on its first.
  const Report report = verify::verify(fan(500, 0, 1.01));
  EXPECT_EQ(report.certificate, false);
  EXPECT_FALSE(sound(report));
}

TEST(Fans, HangingNodeOnAFace) {
  // Tetrahedron 100 has a face at the hub and the vertices 102 and 103. Three tetrahedra stand on that face,
  // around a node in its middle, which tetrahedron 100 does not use.
  TetMesh mesh = fan(500);
  const auto n = static_cast<Index>(mesh.points.size());
  const Eigen::Vector3d middle = (mesh.points[0] + mesh.points[102] + mesh.points[103]) / 3;
  mesh.points.push_back(middle);
  mesh.points.push_back(middle * 1.001);
  mesh.tets.push_back({n, 0, 102, n + 1});
  mesh.tets.push_back({n, 102, 103, n + 1});
  mesh.tets.push_back({n, 103, 0, n + 1});
  const Report report = verify::verify(mesh);
  ASSERT_EQ(report[Check::hanging_node].count, 1);
  EXPECT_EQ(report[Check::hanging_node].findings[0].vertices, std::vector<Index>{n});
  EXPECT_EQ(report[Check::hanging_node].findings[0].faces.size(), 4u) << "the face, and three opposite";
  EXPECT_FALSE(sound(report));
}

}  // namespace
}  // namespace tetproof::test
