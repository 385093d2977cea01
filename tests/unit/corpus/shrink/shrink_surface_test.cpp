// SPDX-License-Identifier: GPL-3.0-or-later
// The shrinker on properties whose smallest surfaces are known.
#include "corpus/shrink/shrink_surface.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <thread>

#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "tests/support/exact_surface.hpp"
#include "tests/support/surface_facts.hpp"
#include "verify/surface.hpp"

namespace tetproof::corpus {
namespace {

// Two cones over a ring of n vertices around the z axis, which need not be convex.
TriangleSurface bipyramid(int n) {
  TriangleSurface s;
  s.vertices = {{0.01, 0.02, 1.1}, {-0.03, 0.01, -0.9}};
  for (int i = 0; i < n; ++i) {  // once around a square, so that no rounding differs between machines
    const double t = 4.0 * i / n, side = t - static_cast<int>(t);
    const Eigen::Vector2d corners[] = {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    const Eigen::Vector2d p =
        corners[static_cast<int>(t)] * (1 - side) + corners[static_cast<int>(t) + 1] * side;
    s.vertices.push_back({p.x(), p.y(), 0.01 * (i % 3)});
  }
  for (int i = 0; i < n; ++i) {
    const Index a = 2 + i, b = 2 + (i + 1) % n;
    s.triangles.push_back({a, b, 0});
    s.triangles.push_back({b, a, 1});
  }
  return s;
}

TriangleSurface together(const std::vector<TriangleSurface>& parts) {
  TriangleSurface all;
  for (const TriangleSurface& part : parts) {
    const auto first = static_cast<Index>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& [a, b, c] : part.triangles) all.triangles.push_back({a + first, b + first, c + first});
  }
  return all;
}

TriangleSurface changed(TriangleSurface s, double scale, const Eigen::Vector3d& offset) {
  for (Eigen::Vector3d& p : s.vertices) p = p * scale + offset;
  return s;
}

TriangleSurface generated(const std::string& spec) {
  TriangleSurface s = make_surface(spec);
  s.parameters.clear();
  s.evaluate = nullptr;
  return s;
}

bool always(const TriangleSurface&) {
  return true;
}

std::size_t largest_degree(const TriangleSurface& s) {
  std::vector<std::size_t> degree(s.vertices.size(), 0);
  for (const auto& t : s.triangles)
    for (const Index v : t) ++degree[v];
  return *std::max_element(degree.begin(), degree.end());
}

bool not_convex(const TriangleSurface& s) {
  for (const auto& [a, b, c] : s.triangles) {
    const Eigen::Vector3d n = (s.vertices[b] - s.vertices[a]).cross(s.vertices[c] - s.vertices[a]);
    for (const Eigen::Vector3d& p : s.vertices)
      if (n.dot(p - s.vertices[a]) > 1e-3 * n.norm()) return true;
  }
  return false;
}

bool has_short_edge(const TriangleSurface& s) {
  Eigen::Vector3d low = s.vertices[0], high = low;
  for (const Eigen::Vector3d& p : s.vertices) low = low.cwiseMin(p), high = high.cwiseMax(p);
  for (const auto& t : s.triangles)
    for (int c = 0; c < 3; ++c)
      if ((s.vertices[t[c]] - s.vertices[t[(c + 1) % 3]]).norm() < 1e-6 * (high - low).norm()) return true;
  return false;
}

int deepest(const TriangleSurface& s) {
  int depth = 0;
  for (const auto& c : verify::judge_surface(s).components) depth = std::max(depth, c.depth);
  return depth;
}

// Brute force in rational arithmetic: an edge meets no triangle but at their common vertex.
bool embedded(const TriangleSurface& s) {
  using namespace exact_surface;
  for (const auto& t : s.triangles) {
    const std::array<Point, 3> corners{exact(s.vertices[t[0]]), exact(s.vertices[t[1]]),
                                       exact(s.vertices[t[2]])};
    for (const auto& other : s.triangles)
      for (int c = 0; c < 3; ++c) {
        Index from = other[c], to = other[(c + 1) % 3];
        const auto common = [&](Index v) { return std::count(t.begin(), t.end(), v) > 0; };
        if (common(from) && common(to)) continue;
        if (common(to)) std::swap(from, to);
        const Point origin = exact(s.vertices[from]);
        const auto hit = line_in_triangle(origin, minus(exact(s.vertices[to]), origin), corners);
        if (!hit || (*hit)[0] > 1) continue;
        if (common(from) ? (*hit)[1] > 0 : (*hit)[1] >= 0) return false;
      }
  }
  return true;
}

void expect_valid(const TriangleSurface& s, long euler) {
  const test::SurfaceFacts facts = test::facts(s);
  EXPECT_TRUE(facts.closed_and_oriented);
  EXPECT_TRUE(facts.one_fan_per_vertex);
  EXPECT_EQ(facts.euler, euler);
  EXPECT_GT(facts.volume, 0);
  EXPECT_TRUE(embedded(s));
}

struct Case {
  std::string name;
  TriangleSurface surface;
  StillFails fails;
  std::size_t least, most;  // triangles of the result: what is possible, and what is expected
  long euler;               // of the result
};

std::vector<Case> cases() {
  const auto genus = [](const TriangleSurface& s) { return verify::judge_surface(s).genus; };
  TriangleSurface short_edge = bipyramid(20);
  short_edge.vertices[5] = short_edge.vertices[4] + Eigen::Vector3d(1e-7, 2e-7, 1e-7);
  std::vector<TriangleSurface> many;
  for (int i = 0; i < 30; ++i) many.push_back(changed(bipyramid(i == 17 ? 14 : 8), 1, {3.0 * i, 0, 0}));
  const TriangleSurface torus = generated("torus:n=150");
  return {
      {"ball", generated("sphere:n=300"), always, 4, 4, 2},
      {"torus that may become a ball", torus, always, 4, 4, 2},
      {"genus 1", torus, [=](const TriangleSurface& s) { return genus(s) == 1; }, 14, 20, 0},
      {"genus 2", together({torus, changed(torus, 1, {5, 0, 0})}),
       [=](const TriangleSurface& s) { return genus(s) == 2; }, 28, 40, 0},
      {"genus 1 of two", together({torus, changed(torus, 1, {5, 0, 0})}),
       [=](const TriangleSurface& s) { return genus(s) >= 1; }, 14, 20, 0},
      {"cavity", generated("shells:count=2,n=100"),
       [](const TriangleSurface& s) { return verify::judge_surface(s).cavities() == 1; }, 8, 8, 4},
      {"solid in a cavity", generated("shells:count=3,n=100"),
       [](const TriangleSurface& s) { return deepest(s) == 2; }, 12, 16, 6},
      {"innermost of three", generated("shells:count=3,n=100"),
       [](const TriangleSurface& s) { return s.vertices.back().norm() < 0.6; }, 4, 4, 2},
      {"degree of 13", bipyramid(50), [](const TriangleSurface& s) { return largest_degree(s) > 12; }, 24, 24,
       2},
      {"not convex", generated("random:n=300,roughness=0.5"), not_convex, 6, 6, 2},
      {"short edge", short_edge, has_short_edge, 4, 4, 2},
      {"one of many parts", together(many), [](const TriangleSurface& s) { return largest_degree(s) > 12; },
       24, 24, 2},
  };
}

TEST(ShrinkSurface, ReachesTheSmallestAndIsTheSameForAnyNumberOfThreads) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    ASSERT_TRUE(c.fails(c.surface));
    std::atomic<std::int64_t> calls = 0, invalid = 0;
    const StillFails counted = [&](const TriangleSurface& s) {
      ++calls;
      const test::SurfaceFacts facts = test::facts(s);
      if (!facts.closed_and_oriented || !facts.one_fan_per_vertex) ++invalid;
      if (!verify::judge_surface(s).fault.empty()) ++invalid;
      return c.fails(s);
    };
    const ShrinkResult one = shrink_surface(c.surface, counted, {.threads = 1});
    EXPECT_EQ(one.calls, calls);
    EXPECT_EQ(invalid, 0);
    EXPECT_TRUE(one.finished);
    EXPECT_TRUE(one.confirmed);
    EXPECT_TRUE(c.fails(one.surface));
    EXPECT_GE(one.surface.triangles.size(), c.least);
    EXPECT_LE(one.surface.triangles.size(), c.most) << one.steps;
    expect_valid(one.surface, c.euler);
    RecordProperty(c.name, one.steps);

    const ShrinkResult four = shrink_surface(c.surface, counted, {.threads = 4});
    EXPECT_EQ(four.surface.vertices, one.surface.vertices);
    EXPECT_EQ(four.surface.triangles, one.surface.triangles);
    EXPECT_EQ(four.steps, one.steps);
    EXPECT_EQ(one.calls + four.calls, calls);
    EXPECT_EQ(invalid, 0);
  }
}

TEST(ShrinkSurface, TellsWhatWasDone) {
  const std::string steps = shrink_surface(generated("torus:n=150"), always, {.threads = 1}).steps;
  EXPECT_NE(steps.find("1 handle cut"), std::string::npos) << steps;
  EXPECT_NE(steps.find("coordinates to "), std::string::npos) << steps;
}

TEST(ShrinkSurface, KeepsTheWayInWhichCavitiesAreOriented) {
  TriangleSurface alike = generated("shells:count=2,n=100");
  const auto inner = verify::judge_surface(alike).components[1];
  ASSERT_FALSE(inner.outward);
  for (std::size_t t = inner.first_triangle; t < alike.triangles.size(); ++t)
    std::swap(alike.triangles[t][0], alike.triangles[t][1]);
  const auto cavity = [](const TriangleSurface& s) { return verify::judge_surface(s).cavities() == 1; };
  for (const auto& c : verify::judge_surface(shrink_surface(alike, cavity, {}).surface).components)
    EXPECT_TRUE(c.outward);
}

TEST(ShrinkSurface, BringsASurfaceNearUnlessItMustBeFar) {
  const TriangleSurface far = changed(bipyramid(9), 1e-4, {1e3, -7e5, 12});
  const ShrinkResult near = shrink_surface(far, always, {});
  for (const Eigen::Vector3d& p : near.surface.vertices)
    for (const double x : p) EXPECT_TRUE(x == static_cast<int>(x) && x >= -10 && x <= 10) << x;
  const ShrinkResult stays =
      shrink_surface(far, [](const TriangleSurface& s) { return s.vertices[0].y() < -6e5; }, {});
  EXPECT_EQ(stays.surface.triangles.size(), 4u);
  EXPECT_LT(stays.surface.vertices[0].y(), -6e5);
  for (const double scale : {1e-60, 1e60, 1e-150}) {
    const ShrinkResult sized = shrink_surface(
        changed(bipyramid(9), scale, {0, 0, 0}),
        [&](const TriangleSurface& s) { return std::abs(s.vertices[0].norm() / scale - 1) < 0.9; }, {});
    EXPECT_EQ(sized.surface.triangles.size(), 4u) << scale << ' ' << sized.steps;
  }
}

TEST(ShrinkSurface, KeepsTheTimeLimit) {
  const StillFails slow = [](const TriangleSurface& s) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return s.triangles.size() > 60;
  };
  const ShrinkResult result = shrink_surface(generated("sphere:n=500"), slow, {.seconds = 0.3, .threads = 2});
  EXPECT_FALSE(result.finished);
  EXPECT_LT(result.seconds, 1);
  EXPECT_LE(result.calls, 2 * result.seconds / 0.02 + 2);
  EXPECT_TRUE(verify::judge_surface(result.surface).fault.empty());
}

TEST(ShrinkSurface, TwoThousandTrianglesTakeSeconds) {
  const ShrinkResult result = shrink_surface(generated("random:n=2000,roughness=0.5"), not_convex, {});
  EXPECT_TRUE(result.finished);
  EXPECT_EQ(result.surface.triangles.size(), 6u);
  EXPECT_LT(result.seconds, 20);
}

TEST(ShrinkSurface, SaysThatASurfaceDoesNotFail) {
  const ShrinkResult result = shrink_surface(bipyramid(5), [](const TriangleSurface&) { return false; }, {});
  EXPECT_FALSE(result.confirmed);
  EXPECT_EQ(result.calls, 1);
  EXPECT_EQ(result.surface.triangles, bipyramid(5).triangles);
  EXPECT_EQ(result.steps, "nothing: the surface did not fail when it was tested again");
}

TEST(ShrinkSurface, SaysThatTheResultIsNotConfirmed) {
  std::atomic<int> calls = 0;
  const StillFails at_first = [&](const TriangleSurface&) { return ++calls <= 3; };
  const ShrinkResult result = shrink_surface(bipyramid(20), at_first, {.threads = 1});
  EXPECT_FALSE(result.confirmed);
  EXPECT_EQ(result.calls, calls);
}

TEST(ShrinkSurface, RefusesASurfaceThatIsNotValid) {
  TriangleSurface open = bipyramid(5);
  open.triangles.pop_back();
  try {
    shrink_surface(open, always, {});
    FAIL() << "an open surface was accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("the surface to shrink is not valid: the surface is open: ", 0),
              0u)
        << error.what();
  }
}

TEST(ShrinkSurface, PassesOnWhatTheTestThrows) {
  std::atomic<int> calls = 0;
  const StillFails throws = [&](const TriangleSurface&) -> bool {
    if (++calls > 2) throw InputError("the disk is full");
    return true;
  };
  EXPECT_THROW(shrink_surface(bipyramid(20), throws, {.threads = 4}), InputError);
}

}  // namespace
}  // namespace tetproof::corpus
