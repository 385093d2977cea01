// SPDX-License-Identifier: GPL-3.0-or-later
// A reduced surface is closed, has the same topology, does not intersect itself, and is close to the
// original.
#include "reference/reduce.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "reference/engine/first_grid/contacts.hpp"
#include "verify/surface.hpp"

namespace tetproof::reference {
namespace {

const std::string source = TETPROOF_SOURCE_DIR;

std::array<Eigen::Vector3d, 3> corners(const TriangleSurface& surface, const std::array<Index, 3>& t) {
  return {surface.vertices[t[0]], surface.vertices[t[1]], surface.vertices[t[2]]};
}

// The largest distance from a vertex of `from` to the triangles of `to`.
double distance(const TriangleSurface& from, const TriangleSurface& to) {
  double largest = 0;
  for (const Eigen::Vector3d& p : from.vertices) {
    double squared = std::numeric_limits<double>::infinity();
    for (const auto& t : to.triangles)
      squared = std::min(squared, (closest_point(corners(to, t), p) - p).squaredNorm());
    largest = std::max(largest, squared);
  }
  return std::sqrt(largest);
}

std::string fault_of(const TriangleSurface& surface) {
  const verify::JudgedSurface judged(surface);
  return judged.report().fault;
}

std::string message_of(const TriangleSurface& surface, int triangles) {
  try {
    reduce(surface, triangles);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class Reduction : public testing::TestWithParam<const char*> {};

TEST_P(Reduction, KeepsClosednessAndTopology) {
  const TriangleSurface whole = corpus::open_surface(GetParam());
  const verify::JudgedSurface judged(whole);
  ASSERT_EQ(judged.report().fault, "");
  std::size_t before = whole.triangles.size();
  for (const double part : {0.5, 0.2, 0.1, 0.05, 0.02, 0.005}) {
    const int wanted = std::max(4, static_cast<int>(part * static_cast<double>(whole.triangles.size())));
    const TriangleSurface reduced = reduce(whole, wanted);
    const verify::JudgedSurface after(reduced);
    EXPECT_EQ(after.report().fault, "") << wanted;
    EXPECT_EQ(after.report().components.size(), judged.report().components.size()) << wanted;
    EXPECT_EQ(after.report().genus, judged.report().genus) << wanted;
    EXPECT_EQ(after.report().cavities(), judged.report().cavities()) << wanted;
    EXPECT_LE(reduced.triangles.size(), before);
    before = reduced.triangles.size();
    if (part >= 0.2) {
      EXPECT_NEAR(after.report().volume, judged.report().volume, 0.05 * judged.report().volume);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Generated, Reduction,
                         testing::Values("sphere", "torus:n=4000", "wing:naca=2412,n=4000",
                                         "random:seed=7,n=3000", "random:seed=8,n=3000,roughness=0.9",
                                         "shells:n=3000", "box:n=8", "groove", "terrain:seed=4", "pair"));

TEST(ReductionOfFiles, KeepsClosednessAndTopology) {
  struct File {
    const char* name;
    int wanted;
    std::size_t expected;  // more than wanted if fewer would make an intersection
  };
  for (const File& file : {File{"spot.obj", 600, 600}, File{"plate_holes.STL", 300, 300},
                           File{"hull-body.obj", 500, 500}, File{"Cray_left.obj", 100, 576}}) {
    const TriangleSurface whole = corpus::open_surface(source + "/corpus/surfaces/" + file.name);
    const TriangleSurface reduced = reduce(whole, file.wanted);
    const verify::JudgedSurface before(whole), after(reduced);
    EXPECT_EQ(after.report().fault, "") << file.name;
    EXPECT_EQ(after.report().components.size(), before.report().components.size()) << file.name;
    EXPECT_EQ(after.report().genus, before.report().genus) << file.name;
    EXPECT_EQ(reduced.triangles.size(), file.expected) << file.name;
  }
}

TEST(Reduce, ComesCloserWithMoreTriangles) {
  for (const char* spec : {"sphere:n=3200", "torus:n=3200"}) {
    const TriangleSurface whole = corpus::make_surface(spec);
    double before = std::numeric_limits<double>::infinity();
    for (const int wanted : {100, 400, 1600}) {
      const TriangleSurface reduced = reduce(whole, wanted);
      EXPECT_LE(static_cast<int>(reduced.triangles.size()), wanted);
      EXPECT_GE(static_cast<int>(reduced.triangles.size()), wanted - 1);
      const double off = std::max(distance(whole, reduced), distance(reduced, whole));
      EXPECT_LT(off, 0.5 * before) << spec << " " << wanted;  // a quarter is to be expected
      before = off;
    }
    EXPECT_LT(before, 0.02) << spec;
  }
}

TEST(Reduce, FlatFacesStayFlat) {
  const TriangleSurface whole = corpus::make_surface("box:n=8,x1=2,y1=3");
  const TriangleSurface reduced = reduce(whole, 12);
  EXPECT_EQ(reduced.triangles.size(), 12u);
  EXPECT_LT(distance(whole, reduced), 1e-12);
  EXPECT_LT(distance(reduced, whole), 1e-12);
}

TEST(Reduce, MoreThanPresentIsUnchanged) {
  const TriangleSurface whole = corpus::make_surface("sphere:n=500");
  for (const int wanted : {static_cast<int>(whole.triangles.size()), 1000000}) {
    const TriangleSurface same = reduce(whole, wanted);
    EXPECT_EQ(same.vertices, whole.vertices);
    EXPECT_EQ(same.triangles, whole.triangles);
    EXPECT_EQ(same.parameters.size(), whole.triangles.size());
  }
  const TriangleSurface fewer = reduce(whole, static_cast<int>(whole.triangles.size()) - 2);
  EXPECT_EQ(fewer.triangles.size() + 2, whole.triangles.size());
  EXPECT_TRUE(fewer.parameters.empty());
  EXPECT_FALSE(fewer.evaluate);
  // This is one collapse: all other vertices keep their coordinates, bit by bit.
  std::size_t kept = 0;
  for (const Eigen::Vector3d& p : fewer.vertices)
    kept += std::count(whole.vertices.begin(), whole.vertices.end(), p);
  EXPECT_EQ(kept, whole.vertices.size() - 2);
}

TEST(Reduce, AsFewAsTheTopologyAllows) {
  EXPECT_EQ(reduce(corpus::make_surface("sphere:n=500"), 4).triangles.size(), 4u);
  const TriangleSurface torus = reduce(corpus::make_surface("torus:n=500"), 4);
  EXPECT_EQ(fault_of(torus), "");
  EXPECT_GE(torus.triangles.size(), 14u);  // no torus has fewer
  EXPECT_LE(torus.triangles.size(), 40u);
}

TEST(Reduce, ScalesByPowersOfTwoExactly) {
  const TriangleSurface once = corpus::make_surface("random:seed=2,n=1500");
  const TriangleSurface expected = reduce(once, 300);
  EXPECT_EQ(reduce(once, 300).vertices, expected.vertices);
  for (const int exponent : {1, -300, 250}) {
    TriangleSurface scaled = once;
    for (Eigen::Vector3d& p : scaled.vertices) p = p * std::ldexp(1.0, exponent);
    const TriangleSurface found = reduce(scaled, 300);
    EXPECT_EQ(found.triangles, expected.triangles) << exponent;
    ASSERT_EQ(found.vertices.size(), expected.vertices.size());
    for (std::size_t v = 0; v < found.vertices.size(); ++v)
      EXPECT_EQ(found.vertices[v], expected.vertices[v] * std::ldexp(1.0, exponent)) << exponent;
  }
}

TEST(Reduce, BadInputIsOneLine) {
  TriangleSurface sphere = corpus::make_surface("sphere:n=500");
  EXPECT_EQ(message_of(sphere, 3), "reduction: expected at least 4 triangles, found 3");
  EXPECT_EQ(message_of(sphere, -1), "reduction: expected at least 4 triangles, found -1");
  TriangleSurface open = sphere;
  open.triangles.pop_back();
  EXPECT_EQ(message_of(open, 100), "the surface cannot be reduced: it is open");
  TriangleSurface twice = sphere;
  twice.triangles.push_back(twice.triangles.front());
  EXPECT_EQ(message_of(twice, 100),
            "the surface cannot be reduced: it is not 2-manifold, or not consistently oriented");
  TriangleSurface turned = sphere;
  std::swap(turned.triangles[7][0], turned.triangles[7][1]);
  EXPECT_EQ(message_of(turned, 100),
            "the surface cannot be reduced: it is not 2-manifold, or not consistently oriented");
  TriangleSurface wild = sphere;
  wild.triangles[5][2] = 100000;
  EXPECT_EQ(message_of(wild, 100), "the surface cannot be reduced: it has no vertex 100000");
  TriangleSurface infinite = sphere;
  infinite.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of(infinite, 100), "the surface cannot be reduced: vertex 3 is not finite");
  EXPECT_NE(message_of(corpus::open_surface(source + "/corpus/surfaces/shared.STL"), 10), "");
  TriangleSurface degenerate = sphere;
  degenerate.triangles[5][2] = degenerate.triangles[5][1];
  EXPECT_NE(message_of(degenerate, 100), "");
}

}  // namespace
}  // namespace tetproof::reference
