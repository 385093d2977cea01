// SPDX-License-Identifier: GPL-3.0-or-later
// The search at vertices of very many triangles, against all pairs of small sets of triangles, and on fans
// with planted defects. The tests call a vertex of few triangles a hub, so that small sets are searched that
// way.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <atomic>
#include <cmath>
#include <numbers>
#include <random>

#include "verify/triangles/intersections.hpp"

namespace tetproof::test {
namespace {

using verify::Triangle;
using Points = std::vector<Eigen::Vector3d>;
using Pair = std::array<Index, 2>;
constexpr std::size_t never = 1'000'000;

struct Soup {
  Points points;
  std::vector<Triangle> triangles;
};

// Decides every pair, without any search.
verify::Intersections all_pairs(const Soup& soup, const std::vector<std::uint8_t>& excluded,
                                const verify::Near* near) {
  const auto box = [&](Index t) {
    verify::Box wide =
        verify::box_of(soup.points, soup.triangles[static_cast<std::size_t>(t)], static_cast<std::size_t>(t));
    const double room = near ? near->room(t) : 0;
    for (int k = 0; k < 3; ++k) wide.low[k] -= room, wide.high[k] += room;
    return wide;
  };
  verify::Intersections all;
  for (Index s = 0; s < static_cast<Index>(soup.triangles.size()); ++s)
    for (Index t = s + 1; t < static_cast<Index>(soup.triangles.size()); ++t) {
      if (excluded[s] || excluded[t]) continue;
      const bool meet = verify::triangles_meet(soup.points, soup.triangles[s], soup.triangles[t]);
      if (meet) all.pairs.push_back({s, t});
      if (!near) continue;
      const verify::PairNearness pair =
          verify::Nearby(soup.points, soup.triangles, *near).look(box(s), box(t), meet);
      all.contacts.insert(all.contacts.end(), pair.contacts.begin(),
                          pair.contacts.begin() + pair.contact_count);
      if (pair.near) all.near.push_back({s, t});
      if (pair.fold) all.folds.push_back({s, t});
    }
  std::sort(all.contacts.begin(), all.contacts.end());
  all.contacts.erase(std::unique(all.contacts.begin(), all.contacts.end()), all.contacts.end());
  all.count = static_cast<std::int64_t>(all.pairs.size());
  return all;
}

void expect_equal(const verify::Intersections& found, const verify::Intersections& truth) {
  EXPECT_EQ(found.count, truth.count);
  EXPECT_EQ(found.pairs, truth.pairs);
  EXPECT_EQ(found.contacts, truth.contacts);
  EXPECT_EQ(found.folds, truth.folds);
  EXPECT_EQ(found.near, truth.near);
  EXPECT_FALSE(found.more);
  EXPECT_FALSE(found.more_near);
}

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

Eigen::Matrix3d some_rotation(std::mt19937_64& random) {
  const Eigen::Vector3d axis(uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5);
  return Eigen::AngleAxisd(6 * uniform(random), axis.normalized()).toRotationMatrix();
}

// Triangles at two hubs and some others. Vertices 0 and 1 are the hubs.
Soup random_hubs(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Soup soup;
  const int kind = static_cast<int>(seed % 7);
  for (int i = 0; i < 24; ++i) {
    Eigen::Vector3d p(uniform(random), uniform(random), uniform(random));
    if (kind == 0) p = (3 * p).array().floor();              // every special position
    if (kind == 1) p[2] = 0;                                 // all in one plane
    if (kind == 2) p[2] *= 1e-9;                             // nearly in one plane
    if (kind == 3) p *= std::pow(10, -8 * uniform(random));  // of all sizes
    // Near others: a few times the near distance from a coarse lattice, which may be small beside the rest.
    if (kind >= 4)
      p = (kind == 6 && i < 20 ? 1e-6 : 1) * Eigen::Vector3d((3 * p).array().floor()) + 4e-12 * p;
    soup.points.push_back(p);
  }
  if (kind >= 5) {
    const Eigen::Matrix3d turn = some_rotation(random);
    for (Eigen::Vector3d& p : soup.points) p = turn * p;
  }
  for (int i = 0; i < 40; ++i) {
    Triangle t;
    for (Index& v : t) v = static_cast<Index>(random() % soup.points.size());
    if (i < 30) t[random() % 3] = static_cast<Index>(random() % 2);
    if (i < 8) t = {0, 1, t[2]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) soup.triangles.push_back(t);
  }
  return soup;
}

TEST(Hubs, LoseNoPairOfRandomTriangles) {
  std::int64_t meeting = 0, near_pairs = 0, contacts = 0, folds = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Soup soup = random_hubs(seed);
    const auto degenerate = verify::degenerate_triangles(soup.points, soup.triangles);
    const verify::Near near(soup.points, soup.triangles);
    const verify::Intersections truth = all_pairs(soup, degenerate.triangles, &near);
    verify::Intersections without = truth;
    without.contacts.clear(), without.folds.clear(), without.near.clear();
    for (const std::size_t hub_from : {std::size_t{0}, std::size_t{3}, std::size_t{9}, never}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", more than " << hub_from << " triangles");
      expect_equal(verify::self_intersections(soup.points, soup.triangles, degenerate.triangles, 100000,
                                              &near, hub_from),
                   truth);
      expect_equal(verify::self_intersections(soup.points, soup.triangles, degenerate.triangles, 100000,
                                              nullptr, hub_from),
                   without);
    }
    meeting += truth.count, near_pairs += static_cast<std::int64_t>(truth.near.size());
    contacts += static_cast<std::int64_t>(truth.contacts.size());
    folds += static_cast<std::int64_t>(truth.folds.size());
  }
  EXPECT_GT(meeting, 5000);
  EXPECT_GT(near_pairs, 100);
  EXPECT_GT(contacts, 1000);
  EXPECT_GT(folds, 100);
}

TEST(Hubs, LoseNoPairAtAnyScale) {
  std::int64_t meeting = 0;
  for (int k = -1000; k <= 900; k += 100)
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      SCOPED_TRACE(testing::Message() << "2^" << k << ", seed " << seed);
      Soup soup = random_hubs(seed);
      for (Eigen::Vector3d& p : soup.points)
        for (int axis = 0; axis < 3; ++axis) p[axis] = std::ldexp(p[axis], seed % 2 && axis == 1 ? k / 2 : k);
      const auto degenerate = verify::degenerate_triangles(soup.points, soup.triangles);
      const verify::Near near(soup.points, soup.triangles);
      const verify::Intersections truth = all_pairs(soup, degenerate.triangles, &near);
      for (const std::size_t hub_from : {std::size_t{0}, std::size_t{3}}) {
        const verify::Intersections found = verify::self_intersections(
            soup.points, soup.triangles, degenerate.triangles, 100000, &near, hub_from);
        EXPECT_EQ(found.pairs, truth.pairs);
        EXPECT_EQ(found.near, truth.near);
      }
      meeting += truth.count;
    }
  EXPECT_GT(meeting, 2000);
}

// Two hubs, 0 and 1, around an axis, and n vertices in a ring between them whose distance from the axis is
// random between 1 and 1 + `bump`. Twice n triangles, outward.
Soup spindle(int n, double height, double bump) {
  std::mt19937_64 random(1);
  Soup soup{{{0, 0, height}, {0, 0, -height}}, {}};
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n, r = 1 + bump * uniform(random);
    soup.points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.2 * bump * height * uniform(random));
    const Index here = 2 + i, next = 2 + (i + 1) % n;
    soup.triangles.push_back({0, here, next});
    soup.triangles.push_back({1, next, here});
  }
  return soup;
}

verify::Intersections search(const Soup& soup) {
  const verify::Near near(soup.points, soup.triangles);
  return verify::self_intersections(soup.points, soup.triangles, {}, 100000, &near);
}

TEST(Hubs, SpindlesAreSound) {
  std::mt19937_64 random(3);
  for (const double height : {1.0, 0.01})
    for (const double bump : {0.0, 0.5})
      for (const double shift : {0.0, 1000.0}) {
        Soup soup = spindle(500, height, bump);
        const Eigen::Matrix3d turn = some_rotation(random);
        for (Eigen::Vector3d& p : soup.points) p = turn * p + Eigen::Vector3d(shift, -shift, 3 * shift);
        expect_equal(search(soup), {});
      }
}

// What the searches at hubs propose grows with the number of triangles, not with its square: boxes would
// propose the half of all pairs.
TEST(Hubs, ProposeFewPairs) {
  const auto proposed = [](const Soup& soup) {
    std::atomic<std::int64_t> count = 0;
    verify::Hubs(soup.points, soup.triangles, {})
        .candidates([](Index) { return 1e-12; }, verify::Threads::all, [&](Index, Index) { ++count; });
    return count.load();
  };
  for (const double height : {1.0, 0.001})
    for (const double bump : {0.0, 0.5})
      for (const int n : {500, 5000}) {
        const Soup soup = spindle(n, height, bump);
        EXPECT_LT(proposed(soup), 20 * n) << "height " << height << ", bump " << bump << ", " << n;
        EXPECT_GE(proposed(soup), n) << "neighbours have a common edge";
      }
  // Triangles around one edge.
  Soup book{{{0, 0, 0}, {0, 0, 1}}, {}};
  for (int i = 0; i < 5000; ++i) {
    book.points.emplace_back(std::cos(0.001 * i), std::sin(0.001 * i), 0.5);
    book.triangles.push_back({0, 1, 2 + i});
  }
  EXPECT_LT(proposed(book), 20 * 5000);
}

TEST(Hubs, TriangleOfAnotherPartThroughAFan) {
  // It pierces the triangles 2 i of the upper hub near the ring, half-way and close to the hub.
  const Soup fan = spindle(400, 1, 0);
  for (const int i : {0, 57, 399})
    for (const double from_hub : {0.999, 0.5, 1e-6}) {
      SCOPED_TRACE(testing::Message() << i << " at " << from_hub);
      Soup soup = fan;
      const Eigen::Vector3d ring = (fan.points[2 + i] + fan.points[2 + (i + 1) % 400]) / 2;
      const Eigen::Vector3d place = fan.points[0] + from_hub * (ring - fan.points[0]);
      // Narrow, and much shorter than the triangle is wide at that place.
      const Eigen::Vector3d out(ring.x(), ring.y(), 1), along = out.cross(Eigen::Vector3d::UnitZ());
      const double size = 1e-4 * from_hub;
      soup.points.insert(soup.points.end(),
                         {place + size * out, place + size * (along - out), place - size * (along + out)});
      soup.triangles.push_back({402, 403, 404});
      const verify::Intersections found = search(soup);
      EXPECT_EQ(found.pairs, (std::vector<Pair>{{static_cast<Index>(2 * i), 800}}));
    }
}

TEST(Hubs, FacesOfOneFanThatOverlap) {
  // Vertex 2 + 100 of the ring is moved over the next one: the triangles on both sides of the edge to it, and
  // those of the edge to vertex 2 + 101, overlap in both cones. The ring lies in a plane and is convex.
  Soup soup = spindle(400, 1, 0);
  soup.points[102] = 0.5 * (soup.points[103] + soup.points[104]);
  const Soup& moved = soup;
  const verify::Near near(moved.points, moved.triangles);
  const verify::Intersections truth =
      all_pairs(moved, std::vector<std::uint8_t>(moved.triangles.size(), 0), &near);
  EXPECT_GT(truth.count, 2);
  expect_equal(search(moved), truth);
}

TEST(Hubs, NodeOnAFan) {
  // A vertex in the middle of triangle 2 * 30, to which only a triangle of another part belongs: exactly on
  // it up to rounding, and clearly off it.
  for (const double off : {0.0, 1e-9}) {
    Soup soup = spindle(400, 1, 0);
    const auto& [a, b, c] = soup.triangles[60];
    const Eigen::Vector3d middle = (soup.points[a] + soup.points[b] + soup.points[c]) / 3;
    soup.points.insert(soup.points.end(),
                       {middle * (1 + off), middle * 2, middle * 2 + Eigen::Vector3d(0, 0, 1)});
    soup.triangles.push_back({402, 403, 404});
    const verify::Intersections found = search(soup);
    if (off == 0)
      EXPECT_EQ(found.contacts, (std::vector<verify::Contact>{{402, 60}}));
    else
      expect_equal(found, {});
  }
}

TEST(Hubs, FansThatTouch) {
  // Two spindles with a common hub, which is all that they have in common.
  Soup soup = spindle(300, 1, 0.3);
  const Soup other = spindle(200, 1, 0.3);
  const auto number = [&](Index v) { return v == 1 ? Index{0} : static_cast<Index>(v + 302); };
  for (const Eigen::Vector3d& p : other.points) soup.points.push_back(p + Eigen::Vector3d(0, 0, 2));
  for (const Triangle& t : other.triangles)
    soup.triangles.push_back({number(t[0]), number(t[1]), number(t[2])});
  expect_equal(search(soup), {});

  // With a hub of its own at the same place, each of the other's 200 triangles there meets each of the 300.
  for (std::size_t t = 600; t < soup.triangles.size(); ++t)
    for (Index& v : soup.triangles[t])
      if (v == 0) v = 303;
  EXPECT_EQ(search(soup).count, 200 * 300);
}

TEST(Hubs, CountsPairsUpToTheLimit) {
  // Triangles at one vertex whose other sides are chords of a circle, from one half of it to the other. Two
  // chords cross exactly if their ends have the same order in both halves.
  std::mt19937_64 random(9);
  for (const int n : {1200, 2200}) {
    Soup soup{{{0, 0, 0}}, {}};
    std::vector<std::array<double, 2>> chords;
    for (int i = 0; i < n; ++i) {
      chords.push_back({uniform(random), uniform(random)});
      for (int k = 0; k < 2; ++k) {
        const double angle = std::numbers::pi * (k + 0.9 * chords.back()[k]);
        soup.points.emplace_back(std::cos(angle), std::sin(angle), 1);
      }
      soup.triangles.push_back({0, 2 * i + 1, 2 * i + 2});
    }
    std::int64_t crossing = 0;
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < i; ++k) crossing += (chords[i][0] < chords[k][0]) == (chords[i][1] < chords[k][1]);
    const verify::Intersections found = verify::self_intersections(soup.points, soup.triangles, {}, 10);
    EXPECT_EQ(found.more, crossing > verify::most_counted_pairs);
    EXPECT_EQ(found.count, std::min(crossing, verify::most_counted_pairs));
    EXPECT_EQ(found.pairs.size(), 10u);
    EXPECT_EQ(found.more, n == 2200) << crossing;
  }
}

}  // namespace
}  // namespace tetproof::test
