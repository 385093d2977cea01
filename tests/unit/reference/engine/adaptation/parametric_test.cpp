// SPDX-License-Identifier: GPL-3.0-or-later
// Reading D12: points are moved to the true surface, and how much closer the boundary comes to it.
#include "reference/engine/adaptation/parametric.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "corpus/surfaces.hpp"
#include "reference/generate.hpp"
#include "tests/support/exact_mesh.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;

double distance_to_sphere(const Vector3d& p) {
  return std::abs(p.norm() - 1);
}
double distance_to_torus(const Vector3d& p) {
  return std::abs(std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - 0.4);
}

TEST(TrueSurface, PointsOfTheTrianglesLandOnTheSurface) {
  for (const auto& [spec, distance] :
       {std::pair{"sphere:r=1,n=500", &distance_to_sphere}, {"torus:R=1,r=0.4,n=800", &distance_to_torus}}) {
    const TriangleSurface surface = corpus::make_surface(spec);
    const TrueSurface true_surface(surface);
    double before = 0;
    for (const auto& [a, b, c] : surface.triangles)
      for (const Vector3d& weights :
           {Vector3d(0.25, 0.5, 0.25), Vector3d(0.5, 0.5, 0), Vector3d(0.125, 0.25, 0.625)}) {
        const Vector3d p = weights[0] * surface.vertices[a] + weights[1] * surface.vertices[b] +
                           weights[2] * surface.vertices[c];
        before = std::max(before, distance(p));
        EXPECT_LT(distance(true_surface(p)), 1e-14);
        EXPECT_LT((true_surface(p) - p).norm(), 0.15);
      }
    EXPECT_GT(before, 1e-3) << "or nothing was shown";
  }
}

TEST(TrueSurface, AVertexIsItsOwnImage) {
  const TriangleSurface surface = corpus::make_surface("sphere:r=1,n=500");
  const TrueSurface true_surface(surface);
  for (const Vector3d& x : surface.vertices) EXPECT_LT((true_surface(x) - x).norm(), 1e-12);
}

TEST(TrueSurface, AnEvaluatorWithoutAnAnswerLeavesThePoint) {
  TriangleSurface surface = corpus::make_surface("sphere:r=1,n=100");
  surface.evaluate = [](const Eigen::Vector2d&) { return Vector3d(NAN, 0, 0); };
  EXPECT_EQ(TrueSurface(surface)({0.9, 0.1, 0}), Vector3d(0.9, 0.1, 0));
  surface.parameters.clear();
  EXPECT_THROW(TrueSurface{surface}, std::logic_error);
}

TEST(Parametric, NoTetrahedronTurnsOverAndEveryMoveIsCounted) {
  // The evaluator is far off, so most moves would invert a tetrahedron.
  TriangleSurface surface = corpus::make_surface("sphere:r=1,n=300");
  const auto sphere = surface.evaluate;
  surface.evaluate = [sphere](const Eigen::Vector2d& uv) -> Vector3d { return -sphere(uv); };
  const Generation made = generate(surface, {.cells = {6, 0, 0}, .adapt = AdaptOptions{.points = 100}});
  EXPECT_GT(made.not_mapped, 0);
  EXPECT_EQ(exact_mesh::fault(made.grid.mesh), "");
  EXPECT_EQ(exact_mesh::fault(made.mesh()), "");
}

// The mean and the largest distance of the boundary faces' centroids from the true surface.
struct Distances {
  double mean = 0, worst = 0;
};
Distances of_face_centroids(const TetMesh& mesh, double (*distance)(const Vector3d&)) {
  std::map<std::array<Index, 3>, int> faces;
  for (const auto& tet : mesh.tets)
    for (const auto& [i, j, k] : tet_faces) {
      std::array face{tet[i], tet[j], tet[k]};
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
  Distances found;
  int boundary = 0;
  for (const auto& [face, tets] : faces) {
    if (tets != 1) continue;
    const double d = distance((mesh.points[face[0]] + mesh.points[face[1]] + mesh.points[face[2]]) / 3);
    found.mean += d;
    found.worst = std::max(found.worst, d);
    ++boundary;
  }
  found.mean /= boundary;
  return found;
}

TEST(Parametric, BoundaryFacesComeCloserToTheTrueSphere) {
  // The surface is coarse, so its own facets are visible: without the parametric definition a finer lattice
  // does not help.
  std::map<int, std::array<Distances, 2>> distances;
  for (const int cells : {6, 12, 24}) {
    for (const bool parametric : {false, true}) {
      const Generation made = generate(
          corpus::make_surface("sphere:r=1,n=500"),
          {.cells = {cells, 0, 0}, .parametric = parametric, .adapt = AdaptOptions{.v0 = {0.2}, .v1 = {1}}});
      distances[cells][parametric] = of_face_centroids(made.mesh(), &distance_to_sphere);
    }
    const auto& [without, with] = distances[cells];
    std::printf(
        "%2d cells: face centroids are %.5f from the sphere on average (at most %.5f), and with its "
        "parametric definition %.5f (%.5f)\n",
        cells, without.mean, without.worst, with.mean, with.worst);
    EXPECT_LT(with.mean, 0.8 * without.mean);
    EXPECT_LT(with.worst, without.worst);
  }
  EXPECT_GT(distances[24][false].mean, 0.6 * distances[12][false].mean) << "the facets' own distance stays";
  EXPECT_LT(distances[24][true].mean, 0.5 * distances[12][true].mean)
      << "the grid's own chords shrink, but for the points that had to stay";
  EXPECT_LT(distances[24][true].mean, 0.2 * distances[24][false].mean);
}

TEST(Parametric, NewBoundaryPointsLieOnTheTrueSurface) {
  const TriangleSurface surface = corpus::make_surface("torus:R=1,r=0.4,n=800");
  const Generation made = generate(surface, {.cells = {12, 0, 0}, .adapt = AdaptOptions{}});
  ASSERT_TRUE(made.adaptation.has_value());
  const TrueSurface true_surface(surface);
  std::int64_t on = 0, off = 0;
  for (std::size_t p = made.grid.mesh.points.size(); p < made.mesh().points.size(); ++p)
    if (made.adaptation->on_surface[p]) ++(distance_to_torus(made.mesh().points[p]) < 1e-13 ? on : off);
  EXPECT_GT(on, 100);
  EXPECT_LT(off, on / 20) << "those that had to stay";
  EXPECT_EQ(made.adaptation->left, off);
}

// Why a sphere's picture shows flat places: splits never divide an edge of the boundary that others share.
TEST(Parametric, TheBoundarysEdgesStayChordsOfTheFirstGrid) {
  const auto edges_on_sphere = [](const TetMesh& mesh) {
    std::map<std::array<Index, 3>, int> faces;
    for (const auto& tet : mesh.tets)
      for (const auto& [i, j, k] : tet_faces) {
        std::array face{tet[i], tet[j], tet[k]};
        std::sort(face.begin(), face.end());
        ++faces[face];
      }
    std::set<std::pair<Index, Index>> edges;
    for (const auto& [face, tets] : faces)
      if (tets == 1)
        for (const auto& [i, j] : {std::pair(0, 1), {0, 2}, {1, 2}})
          if (mesh.points[face[i]].norm() < 1.1 && mesh.points[face[j]].norm() < 1.1)
            edges.emplace(face[i], face[j]);
    return edges;
  };
  for (const int cells : {9, 19}) {
    const Options options{.region = Region::outside,
                          .cells = {cells, 0, 0},
                          .box_scale = 2,
                          .adapt = AdaptOptions{.v0 = {0.1}, .v1 = {1}}};
    const Generation made = generate(corpus::make_surface("sphere:r=1,n=2000"), options);
    const auto first = edges_on_sphere(made.grid.mesh), last = edges_on_sphere(made.mesh());
    EXPECT_GT(last.size(), first.size() * 11 / 10) << "faces of the boundary are divided";
    std::size_t off_ends = 0;
    double deepest = 0;
    for (const auto& [i, j] : first) {
      EXPECT_TRUE(last.contains({i, j}));
      const Vector3d &a = made.mesh().points[i], &b = made.mesh().points[j];
      if (distance_to_sphere(a) > 1e-13 || distance_to_sphere(b) > 1e-13) {
        ++off_ends;
        continue;
      }
      const double length = (b - a).norm(), depth = 1 - ((a + b) / 2).norm();
      EXPECT_NEAR(depth, length * length / 8, length * length * length * length / 64);
      deepest = std::max(deepest, depth);
    }
    EXPECT_LT(off_ends, first.size() / 20) << "edges at points that had to stay";
    // No new point is deeper, and each that is not on the sphere is counted.
    std::int64_t off = 0;
    for (std::size_t p = made.grid.mesh.points.size(); p < made.mesh().points.size(); ++p) {
      if (!made.adaptation->on_surface[p] || distance_to_sphere(made.mesh().points[p]) < 1e-13) continue;
      EXPECT_LT(1 - made.mesh().points[p].norm(), 1.34 * deepest) << "a centroid of three chords";
      ++off;
    }
    EXPECT_EQ(made.adaptation->left, off);
    // A chord lies in a lattice tetrahedron, whose longest edge is sqrt(3) cells long.
    const double cell = 4.0 / cells;
    std::printf("%2d cells: chords are at most %.5f below the sphere\n", cells, deepest);
    EXPECT_LT(deepest, 3 * cell * cell / 8);
    EXPECT_GT(deepest, 1.5 * cell * cell / 8);
  }
}

TEST(Parametric, BothEnginesCountThePointsThatHadToStay) {
  for (const auto& [engine, name] : {std::pair(Engine::fast, "fast"), {Engine::paper, "paper"}}) {
    const Generation made =
        generate(corpus::make_surface("sphere:r=1,n=500"), {.engine = engine,
                                                            .region = Region::outside,
                                                            .cells = {5, 0, 0},
                                                            .adapt = AdaptOptions{.v0 = {0.01}}});
    std::int64_t off = 0;
    for (std::size_t p = made.grid.mesh.points.size(); p < made.mesh().points.size(); ++p)
      off += made.adaptation->on_surface[p] && distance_to_sphere(made.mesh().points[p]) > 1e-13;
    EXPECT_EQ(off, 6) << name;
    EXPECT_EQ(made.adaptation->left, 6) << name;
  }
}

}  // namespace
}  // namespace tetproof::reference
