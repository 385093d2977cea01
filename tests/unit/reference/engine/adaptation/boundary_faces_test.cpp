// SPDX-License-Identifier: GPL-3.0-or-later
// Reading D12: a moved point must not carry the boundary through itself.
#include "reference/engine/adaptation/boundary_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "corpus/surfaces.hpp"
#include "reference/generate.hpp"
#include "verify/verify.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;

const BoundaryFace base{{0, 1, 2}, {Vector3d(0, 0, 0), Vector3d(4, 0, 0), Vector3d(0, 4, 0)}};

TEST(FacesMeet, ByTheNumberOfCommonVertices) {
  struct Case {
    const char* what;
    BoundaryFace face;
    bool meet;
  };
  const double up = std::nextafter(0.0, 1.0);
  const Case cases[] = {
      {"apart", {{3, 4, 5}, {Vector3d(0, 0, 1), Vector3d(4, 0, 1), Vector3d(0, 4, 1)}}, false},
      {"through", {{3, 4, 5}, {Vector3d(1, 1, 1), Vector3d(1, 1, -1), Vector3d(9, 9, 0)}}, true},
      {"touching in a point", {{3, 4, 5}, {Vector3d(1, 1, 0), Vector3d(1, 1, 1), Vector3d(1, 2, 1)}}, true},
      {"the least double above",
       {{3, 4, 5}, {Vector3d(1, 1, up), Vector3d(1, 1, 1), Vector3d(1, 2, 1)}},
       false},
      {"coplanar, apart", {{3, 4, 5}, {Vector3d(4, 4, 0), Vector3d(5, 4, 0), Vector3d(4, 5, 0)}}, false},
      {"coplanar, overlapping", {{3, 4, 5}, {Vector3d(1, 1, 0), Vector3d(5, 4, 0), Vector3d(4, 5, 0)}}, true},
      {"a vertex in common", {{0, 4, 5}, {Vector3d(0, 0, 0), Vector3d(-1, 0, 1), Vector3d(0, -1, 1)}}, false},
      {"a vertex in common, through",
       {{0, 4, 5}, {Vector3d(0, 0, 0), Vector3d(1, 1, 1), Vector3d(1, 1, -1)}},
       true},
      {"a vertex in common, an edge upon the face",
       {{0, 4, 5}, {Vector3d(0, 0, 0), Vector3d(1, 1, 0), Vector3d(0, -1, 1)}},
       true},
      {"an edge in common", {{1, 0, 5}, {Vector3d(4, 0, 0), Vector3d(0, 0, 0), Vector3d(1, 1, 3)}}, false},
      {"an edge in common, flat beside",
       {{1, 0, 5}, {Vector3d(4, 0, 0), Vector3d(0, 0, 0), Vector3d(1, -1, 0)}},
       false},
      {"an edge in common, folded flat",
       {{1, 0, 5}, {Vector3d(4, 0, 0), Vector3d(0, 0, 0), Vector3d(1, 3, 0)}},
       true},
      {"an edge in common, folded almost flat",
       {{1, 0, 5}, {Vector3d(4, 0, 0), Vector3d(0, 0, 0), Vector3d(1, 3, up)}},
       false},
      {"the same", base, true}};
  for (const Case& c : cases) {
    EXPECT_EQ(faces_meet(base, c.face), c.meet) << c.what;
    EXPECT_EQ(faces_meet(c.face, base), c.meet) << c.what;
  }
}

TEST(BoundaryFacesInCells, FindWhatAskingAllFinds) {
  std::mt19937_64 random(5);
  const auto coordinate = [&] { return static_cast<double>(random() % 2000) / 100 - 10; };
  const auto small_face = [&](Index n) {
    const Vector3d at(coordinate(), coordinate(), coordinate());
    const auto near = [&] {
      return Vector3d(at + 0.15 * Vector3d(coordinate(), coordinate(), coordinate()));
    };
    return BoundaryFace{{3 * n, 3 * n + 1, 3 * n + 2}, {at, near(), near()}};
  };
  std::vector<BoundaryFace> faces;
  BoundaryFaces held(1.7);
  for (Index n = 0; n < 1500; ++n) {
    faces.push_back(small_face(n));
    held.add(faces.back());
  }
  for (std::size_t n = 0; n < 500; ++n) held.remove(faces[n]);
  const auto all = [](const BoundaryFace&) { return true; };
  int met = 0;
  for (Index n = 0; n < 500; ++n) {
    const BoundaryFace asked = small_face(1500 + n);
    const bool expected = std::any_of(faces.begin() + 500, faces.end(),
                                      [&](const BoundaryFace& f) { return faces_meet(asked, f); });
    EXPECT_EQ(held.meets(asked, all), expected);
    EXPECT_FALSE(held.meets(asked, [](const BoundaryFace&) { return false; }));
    met += expected;
  }
  EXPECT_GT(met, 50);
  EXPECT_LT(met, 450);
  EXPECT_THROW(held.remove(faces[0]), std::logic_error);
}

TEST(Parametric, TheBoundaryOfAThinWingDoesNotCrossItself) {
  // Without the check of the boundary, four pairs of boundary faces intersected here.
  const Generation made =
      generate(corpus::make_surface("wing:naca=0012,n=5000"),
               {.cells = {64, 0, 0},
                .adapt = AdaptOptions{.v0 = {0.1}, .v1 = {1}, .p = 3, .improve = Criterion::none}});
  ASSERT_TRUE(made.adaptation.has_value());
  EXPECT_GT(made.adaptation->left, 0);
  EXPECT_EQ(verify::verify(made.mesh(), {.quality = false}).certificate, true);
}

TEST(Parametric, AFirstGridsPointThatWouldCrossTheBoundaryStays) {
  // The evaluator moves each sheet of a thin plate to the other side of the other sheet. In an inside grid,
  // tetrahedra would be inverted. In an outside grid there is nothing between the sheets, so only the
  // boundary shows the fault.
  TriangleSurface plate = corpus::make_surface("box:x0=0,x1=8,y0=0,y1=8,z0=-0.5,z1=0.5,n=2");
  plate.parameters.clear();
  for (const auto& t : plate.triangles) {
    std::array<Eigen::Vector2d, 3> corners;
    for (int i = 0; i < 3; ++i) {
      const Vector3d& x = plate.vertices[t[i]];
      corners[i] = {x.x() + (x.z() > 0 ? 100 : 0), x.y()};  // u identifies the sheet
    }
    plate.parameters.push_back(corners);
  }
  plate.evaluate = [](const Eigen::Vector2d& uv) {
    const bool top = uv.x() > 50;
    return Vector3d(top ? uv.x() - 100 : uv.x(), uv.y(), top ? -0.6 : 0.6);
  };
  const Generation made = generate(plate, {.region = Region::outside, .cells = {9, 9, 5}, .box_scale = 1.5});
  EXPECT_GT(made.not_mapped, 0);
  EXPECT_EQ(verify::verify(made.grid.mesh, {.quality = false}).certificate, true);
}

}  // namespace
}  // namespace tetproof::reference
