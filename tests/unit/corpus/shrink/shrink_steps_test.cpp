// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of the shrinker by themselves: collapses, parts, caps, decimals, the ordered search.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <thread>

#include "corpus/shrink/bring_near.hpp"
#include "corpus/shrink/decimals.hpp"
#include "corpus/shrink/editable_surface.hpp"
#include "corpus/shrink/ordered_search.hpp"
#include "corpus/shrink/parts.hpp"
#include "corpus/shrink/patches.hpp"
#include "corpus/surfaces.hpp"
#include "tests/support/surface_facts.hpp"
#include "verify/surface.hpp"

namespace tetproof::corpus {
namespace {

// Three tetrahedra's worth of a tower: a triangle 0 1 2 in the middle is no face, but each of its sides is an
// edge.
TriangleSurface tower() {
  TriangleSurface s;
  s.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 4}, {1, 1, -4}};
  for (const auto& [a, b] : {std::pair<Index, Index>{0, 1}, {1, 2}, {2, 0}}) {
    s.triangles.push_back({a, b, 3});
    s.triangles.push_back({b, a, 4});
  }
  return s;
}

TEST(EditableSurface, RefusesACollapseThatBreaksTheLinkCondition) {
  const TriangleSurface s = tower();
  ASSERT_EQ(verify::judge_surface(s).fault, "");
  const EditableSurface surface(s);
  // 0 and 1 have the common neighbours 2, 3 and 4: the two triangles at vertex 2 would fall together.
  EXPECT_FALSE(surface.allows({0, 1, s.vertices[1]}));
  EXPECT_FALSE(surface.allows({0, 1, {2, -1, 0}}));
  EXPECT_TRUE(surface.allows({3, 0, s.vertices[0]}));
  EXPECT_FALSE(surface.allows({3, 4, s.vertices[4]}));  // no edge
}

TEST(EditableSurface, RefusesToCollapseATetrahedron) {
  TriangleSurface s;
  s.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  s.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  ASSERT_EQ(verify::judge_surface(s).fault, "");
  const EditableSurface surface(s);
  for (const auto& [a, b] : surface.edges()) EXPECT_FALSE(surface.allows({a, b, s.vertices[b]}));
}

// What `allows` says of every collapse must be what the judge says of its result.
TEST(EditableSurface, AgreesWithTheJudge) {
  int allowed = 0, refused = 0;
  for (const char* spec : {"torus:n=60", "random:n=80,roughness=0.8", "hollow:m=3", "shells:count=2,n=40"}) {
    const EditableSurface surface(make_surface(spec));
    for (const auto& [a, b] : surface.edges())
      for (const double t : {0.0, 0.5, 1.0, 3.0}) {
        const Collapse collapse{a, b, (1 - t) * surface.vertices()[a] + t * surface.vertices()[b]};
        EditableSurface next = surface;
        next.apply(collapse);
        const TriangleSurface result = next.surface();
        const std::string fault = verify::judge_surface(result).fault;
        EXPECT_EQ(surface.allows(collapse), fault.empty())
            << spec << ' ' << a << '-' << b << ' ' << t << ": " << fault;
        ++(surface.allows(collapse) ? allowed : refused);
      }
  }
  EXPECT_GT(allowed, 100);
  EXPECT_GT(refused, 100);
}

TEST(Parts, AreRemovedWithTheCavitiesInside) {
  const TriangleSurface s = make_surface("shells:count=3,n=100");
  const Parts parts = find_parts(s);
  ASSERT_EQ(parts.solids.size(), 2u);
  ASSERT_EQ(parts.cavities.size(), 1u);
  const auto left = [&](const std::vector<Index>& set) {
    std::vector<std::uint8_t> removed(3, 0);
    for (const Index part : set) removed[part] = 1;
    return verify::judge_surface(without_parts(s, parts, removed));
  };
  for (const auto& sets : {parts.solids, parts.cavities})
    for (const auto& set : sets) {
      const verify::SurfaceReport report = left(set);
      EXPECT_EQ(report.fault, "");
      EXPECT_TRUE(report.notes.empty());
      EXPECT_EQ(report.components.size(), 3 - set.size());
    }
}

TEST(Patches, AHandleRingLowersTheGenus) {
  const TriangleSurface s = make_surface("torus:n=200");
  const auto rings = handle_rings(s, 1);
  ASSERT_FALSE(rings.empty());
  int cut = 0;
  for (const Patch& ring : rings) {
    const auto result = replace_patch(s, ring);
    if (!result) continue;
    ++cut;
    EXPECT_LT(result->triangles.size(), s.triangles.size());
    EXPECT_EQ(test::facts(*result).euler, 2);
    EXPECT_EQ(test::facts(*result).components, 1);
  }
  EXPECT_GT(cut, 0);
  EXPECT_TRUE(handle_rings(make_surface("sphere:n=100"), 1).empty());
}

TEST(Patches, CapsCloseTheSurface) {
  const TriangleSurface s = make_surface("sphere:n=500");
  const auto all = balls(s, 1);
  ASSERT_GT(all.size(), 10u);
  EXPECT_GT(all.front().size(), s.triangles.size() / 2);
  int replaced = 0;
  for (const Patch& ball : all)
    if (const auto result = replace_patch(s, ball)) {
      ++replaced;
      const test::SurfaceFacts facts = test::facts(*result);
      EXPECT_TRUE(facts.closed_and_oriented && facts.one_fan_per_vertex);
      EXPECT_EQ(facts.euler, 2);
    }
  EXPECT_GT(replaced, 10);
}

TEST(Decimals, OfNumbers) {
  EXPECT_EQ(decimals_of(0.25), 2);
  EXPECT_EQ(decimals_of(-3), 0);
  EXPECT_EQ(decimals_of(5000), -3);
  EXPECT_EQ(decimals_of(1.25e-60), 62);
  EXPECT_EQ(decimals_of(0.1 + 0.2), 17);
  EXPECT_EQ(decimals_of(0), std::numeric_limits<int>::min());
}

TEST(Decimals, Rounding) {
  EXPECT_EQ(rounded(0.1 + 0.2, 1), 0.3);
  EXPECT_EQ(rounded(0.1 + 0.2, 15), 0.3);
  EXPECT_EQ(rounded(123456, -3), 123000);
  EXPECT_EQ(rounded(1.26e-60, 61), 1.3e-60);
  EXPECT_EQ(rounded(-7.77e60, -60), -8e60);
  EXPECT_FALSE(std::signbit(rounded(-0.2, 0)));
  EXPECT_EQ(rounded(1e-300, 400), 1e-300);
  for (const double x : {0.123456789, 98765.4321, -1e-5, 1 / 3.0})
    for (int d = 0; d < 12; ++d) EXPECT_LE(decimals_of(rounded(x, d)), d) << x << ' ' << d;
}

TEST(Decimals, BringsNear) {
  TriangleSurface s = tower();
  for (Eigen::Vector3d& p : s.vertices) p = p / 1024 + Eigen::Vector3d(100, 0, 0);
  const TriangleSurface near = brought_near(s, true, true);
  EXPECT_EQ(near.vertices[1] - near.vertices[0], Eigen::Vector3d(1, 0, 0) * (near.vertices[1].x()));
  EXPECT_GE(near.vertices[1].x(), 0.5);
  EXPECT_EQ(brought_near(s, true, false).vertices[1], Eigen::Vector3d(4.0 / 1024, 0, 4.0 / 1024));
  EXPECT_EQ(brought_near(tower(), true, true).vertices, tower().vertices);
}

TEST(FirstSuccess, IsTheLowestForAnyNumberOfThreads) {
  for (const int threads : {1, 2, 8})
    for (int repeat = 0; repeat < 20; ++repeat) {
      const auto found = first_success(100, threads, TimeLimit(60), [&](std::size_t i) {
        if (i % 7 == 3) std::this_thread::sleep_for(std::chrono::microseconds(50 * (i % 5)));
        return i == 31 || i == 33 || i > 40;
      });
      EXPECT_EQ(found, 31u);
    }
  EXPECT_EQ(first_success(100, 3, TimeLimit(60), [](std::size_t) { return false; }), std::nullopt);
  EXPECT_EQ(first_success(0, 3, TimeLimit(60), [](std::size_t) { return true; }), std::nullopt);
}

TEST(FirstSuccess, BeginsNothingAfterTheTime) {
  std::atomic<int> calls = 0;
  EXPECT_EQ(first_success(10, 2, TimeLimit(0), [&](std::size_t) { return ++calls, true; }), std::nullopt);
  EXPECT_EQ(calls, 0);
}

TEST(FirstSuccess, ThrowsOnlyWhatComesBeforeTheAnswer) {
  const auto trial = [](std::size_t i) {
    if (i == 20) throw std::runtime_error("at 20");
    if (i == 25) throw std::logic_error("at 25");
    return i == 22;
  };
  for (const int threads : {1, 4})
    EXPECT_THROW(first_success(40, threads, TimeLimit(60), trial), std::runtime_error);
  EXPECT_EQ(first_success(40, 4, TimeLimit(60), [&](std::size_t i) { return i == 15 || trial(i); }), 15u);
}

}  // namespace
}  // namespace tetproof::corpus
