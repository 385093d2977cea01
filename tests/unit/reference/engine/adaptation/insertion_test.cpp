// SPDX-License-Identifier: GPL-3.0-or-later
// Step (vi): the queues find the literal choice of eq. (3.5), and insertion stops by its rules.
#include "reference/engine/adaptation/insertion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "corpus/random_surface.hpp"
#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "reference/engine/adaptation/invariants.hpp"
#include "reference/generate.hpp"

namespace tetproof::reference {
namespace {

// The choice of eq. (3.5), found by asking every tetrahedron. Ties go to the lowest number. Tetrahedra whose
// split would be degenerate are left out.
std::optional<Candidate> by_brute_force(const WeightedGrid& grid) {
  std::array<std::optional<Candidate>, 5>
      least;  // by number of pieces: their changes are compared (reading D16)
  for (Index t = 0; t < grid.grid().numbers(); ++t) {
    if (!grid.grid().alive(t)) continue;
    const Candidate c = grid.candidate(t);
    auto& best = least[c.split.pieces];
    if (best && !(c.change < best->change)) continue;
    if (grid.is_positive(c)) best = c;
  }
  std::optional<Candidate> best;
  for (const auto& c : least)
    if (c && (!best || grid.e_avg_after(*c) < grid.e_avg_after(*best) ||
              (grid.e_avg_after(*c) == grid.e_avg_after(*best) && c->tet < best->tet)))
      best = c;
  return best;
}

struct Case {
  std::string title, surface;
  int cells;
  AdaptOptions adapt;
  Region region = Region::inside;
  double on_surface = 1e-6;
};

class EveryStep : public testing::TestWithParam<Case> {};

TEST_P(EveryStep, ChoosesWhatAskingEveryTetrahedronChooses) {
  const Case& c = GetParam();
  const TriangleSurface surface = corpus::make_surface(c.surface);
  const Generation first =
      generate(surface, {.region = c.region, .cells = {c.cells, 0, 0}, .on_surface = c.on_surface});
  const TrueSurface true_surface(surface);
  Insertion insertion(first.grid, surface, c.adapt, &true_surface, {});
  std::int64_t steps = 0;
  for (;;) {
    const std::optional<Candidate> expected = by_brute_force(insertion.grid());
    const Choice choice = insertion.choose();
    ASSERT_EQ(choice.best.has_value(), expected.has_value());
    ASSERT_EQ(choice.best->tet, expected->tet) << "insertion " << steps + 1;
    ASSERT_EQ(choice.best->change, expected->change);
    ASSERT_EQ(choice.best->split.point, expected->split.point);
    if (choice.stop) break;
    std::vector<Index> set = insertion.insert(*choice.best);
    if (insertion.needs_improvement())
      while (const auto flip = best_flip(insertion.grid().grid(), set, c.adapt.improve))
        set = insertion.flip(*flip, set);
    insertion.end_step();
    ASSERT_NO_THROW(check_invariants(insertion.grid()));
    ++steps;
  }
  EXPECT_GT(steps, 50);
}

INSTANTIATE_TEST_SUITE_P(
    Small, EveryStep,
    testing::Values(
        Case{"Sphere", "sphere:r=1,n=500", 5, {.improve = Criterion::none}},
        Case{"FarFromTheOrigin", "sphere:r=1,n=300,x=9e5,y=-2e5", 4, {.v0 = {0.1}, .v1 = {1}}},
        Case{"SphereSymmetric",
             "sphere:r=1,n=100",
             4,
             {.v0 = {0.05}, .v1 = {0.5}, .improve = Criterion::none}},
        Case{"SphereFlips", "sphere:r=1,n=500", 4, {.v1 = {1}, .improve_below = 0.01}},
        Case{"SphereOutside", "sphere:r=1,n=300", 4, {.v0 = {0.1}, .v1 = {3}, .p = 3}, Region::outside},
        Case{"TorusCurvature",
             "torus:R=1,r=0.4,n=600",
             8,
             {.curvature = true, .improve = Criterion::aspect_ratio}},
        Case{"TorusRoot", "torus:R=1,r=0.4,n=600", 7, {.v0 = {0.3}, .v1 = {1.5}, .p = 0.25}},
        Case{"TorusSnapped", "torus:R=1,r=0.4,n=600", 7, {.v0 = {0.3}, .v1 = {1}}, Region::inside, 0.15},
        Case{"VolumesExchanged", "sphere:r=1,n=300", 4, {.v0 = {2}, .v1 = {0.2}}}),
    [](const auto& tested) { return tested.param.title; });

Generation adapted(const std::string& surface, int cells, const AdaptOptions& adapt, Listener listener = {}) {
  return generate(corpus::make_surface(surface),
                  {.cells = {cells, 0, 0}, .adapt = adapt, .listener = std::move(listener)});
}

TEST(Stopping, AtANumberOfPoints) {
  const Generation made = adapted("sphere:n=500", 5, {.points = 17});
  EXPECT_EQ(made.adaptation->insertions, 17);
  EXPECT_EQ(made.adaptation->stopped, Stop::points);
  EXPECT_EQ(made.mesh().points.size(), made.grid.mesh.points.size() + 17);
  // The smallest height over the square root of the largest face, for the worst tetrahedron of the final
  // grid.
  double least = 1;
  for (const auto& [a, b, c, d] : made.mesh().tets) {
    const auto& x = made.mesh().points;
    const double volume_times_3 = std::abs((x[b] - x[a]).cross(x[c] - x[a]).dot(x[d] - x[a])) / 2;
    double area = 0;
    for (const auto& [p, q, r] : {std::array{a, b, c}, {a, b, d}, {a, c, d}, {b, c, d}})
      area = std::max(area, (x[q] - x[p]).cross(x[r] - x[p]).norm() / 2);
    least = std::min(least, volume_times_3 / area / std::sqrt(area));
  }
  EXPECT_NEAR(made.adaptation->smallest_d_over_sqrt_a, least, 1e-14);
}

TEST(Stopping, AtAnAverageError) {
  const Generation all = adapted("sphere:n=500", 5, {.improve = Criterion::none});
  const double goal = (all.adaptation->e_avg_first + all.adaptation->e_avg_last) / 2;
  const Generation made = adapted("sphere:n=500", 5, {.e_avg = {goal, true}, .improve = Criterion::none});
  EXPECT_EQ(made.adaptation->stopped, Stop::e_avg);
  EXPECT_LE(made.adaptation->e_avg_last, goal);
  EXPECT_LT(made.adaptation->insertions, all.adaptation->insertions);
  const Generation one_less =
      adapted("sphere:n=500", 5, {.points = made.adaptation->insertions - 1, .improve = Criterion::none});
  EXPECT_GT(one_less.adaptation->e_avg_last, goal);
}

TEST(Stopping, WhereNoSplitLowersTheAverage) {
  // The desired volume is far above all volumes of the grid: every split only makes it worse.
  const Generation made = adapted("sphere:n=500", 5, {.v0 = {50}, .v1 = {50}});
  EXPECT_EQ(made.adaptation->stopped, Stop::no_gain);
  EXPECT_EQ(made.adaptation->insertions, 0);
  // The average is 0 already: in a cube of equal cells each tetrahedron has the desired size.
  const Generation perfect =
      generate(corpus::make_surface("box:x0=0,y0=0,z0=0,x1=4,y1=4,z1=4"),
               {.cells = {8, 0, 0}, .box_scale = 2, .adapt = AdaptOptions{.v0 = {1}, .v1 = {1}}});
  EXPECT_EQ(perfect.adaptation->stopped, Stop::no_gain);
  EXPECT_EQ(perfect.adaptation->e_avg_last, 0);
}

TEST(Stopping, ByDilutionWhereV0IsFarBelowTheAverage) {
  double smallest = 1;  // the volume over the desired volume, of the tetrahedra that were split
  const Generation made = adapted("sphere:n=500", 6, {.v0 = {0.001}, .v1 = {1}, .improve = Criterion::none});
  EXPECT_EQ(made.adaptation->stopped, Stop::dilution);
  const Generation past = adapted("sphere:n=500", 6,
                                  {.points = made.adaptation->insertions + 500,
                                   .v0 = {0.001},
                                   .v1 = {1},
                                   .past_dilution = true,
                                   .improve = Criterion::none},
                                  {.after_step = [&](const WeightedGrid& grid) {
                                    for (Index t = grid.grid().numbers() - 4; t < grid.grid().numbers(); ++t)
                                      smallest =
                                          std::min(smallest, grid.weight(t).volume / grid.weight(t).desired);
                                  }});
  EXPECT_EQ(past.adaptation->insertions, made.adaptation->insertions + 500) << "E_avg falls for ever";
  EXPECT_LT(past.adaptation->e_avg_last, made.adaptation->e_avg_last);
  EXPECT_LT(smallest, 1);
}

TEST(Stopping, WhereTheAverageHasSetNoNewMinimumForLong) {
  // The test forces splits that only raise the average, as flips may do.
  const TriangleSurface surface = corpus::make_surface("sphere:n=500");
  const Generation first = generate(surface, {.cells = {5, 0, 0}});
  Insertion insertion(first.grid, surface, {.v0 = {50}, .v1 = {50}, .improve = Criterion::none}, nullptr, {});
  for (int n = 0; n < 1000; ++n) {
    const Choice choice = insertion.choose();
    ASSERT_EQ(choice.stop, Stop::no_gain) << "after " << n;
    insertion.insert(*choice.best);
    insertion.end_step();
  }
  ASSERT_LT(insertion.grid().grid().tets(), 10000);
  EXPECT_EQ(insertion.choose().stop, Stop::stalled);
}

TEST(Options, OutOfRangeIsBadInput) {
  const auto refused = [](const AdaptOptions& options, const std::string& word) {
    try {
      adapted("sphere:n=100", 4, options);
      ADD_FAILURE() << "no error about " << word;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  refused({.v0 = {0}}, "v0");
  refused({.v1 = {-1}}, "v1");
  refused({.v1 = {NAN}}, "v1");
  refused({.p = 0}, "p");
  refused({.p = INFINITY}, "p");
  refused({.d1 = -1}, "d1");
  refused({.e_avg = {-1}}, "e-avg");
  refused({.improve_below = 2}, "improve-below");
  refused({.points = -7}, "points");
  refused({.past_dilution = true}, "past-dilution");
  refused({.v0 = {1e-15, true}, .v1 = {1e-15, true}}, "tetrahedra");
}

TEST(CompensatedSums, KeepWhatDoublesLose) {
  CompensatedSum sum;
  for (const double x : {1.0, 1e100, 1.0, -1e100}) sum.add(x);
  EXPECT_EQ(sum.value(), 2);
}

TEST(Invariants, HoldForEverySettingAndFailForABrokenGrid) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const TriangleSurface surface = corpus::random_closed_surface(seed);
    EXPECT_NO_THROW(generate(surface, {.region = seed % 2 ? Region::inside : Region::outside,
                                       .cells = {5, 0, 0},
                                       .adapt = AdaptOptions{.points = 60,
                                                             .v0 = {0.1},
                                                             .v1 = {1},
                                                             .curvature = seed % 3 == 0,
                                                             .improve_below = 0.02,
                                                             .check_every_step = true}}))
        << corpus::describe_random_surface(seed);
  }
  // Two tetrahedra on one side of their face.
  const TetMesh folded{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 2}},
                       {{0, 1, 2, 3}, {0, 1, 2, 4}}};
  TriangleSurface surface;
  surface.vertices = folded.points;
  const Weighting weighting(surface, false);
  const WeightedGrid grid(Triangulation(folded, std::vector<std::uint8_t>(5, 0)), weighting, {1, 1}, {});
  EXPECT_THROW(check_invariants(grid), std::logic_error);
}

}  // namespace
}  // namespace tetproof::reference
