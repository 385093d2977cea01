// SPDX-License-Identifier: GPL-3.0-or-later
// Following a trace through steps (i) to (v): every record of these steps is compared with our own, and a
// fault is found at its line.
#include <cmath>
#include <functional>

#include "reference/equations.hpp"
#include "tests/unit/reference/follow/followed.hpp"

namespace tetproof::reference {
namespace {

using FollowFirstSteps = FollowTest;

// Has lattice vertices moved to the surface, and no cuts.
const TracedRun& groove() {
  static const TracedRun run(
      "groove:m=4",
      {.cells = {6, 0, 0}, .box_scale = 1.5, .adapt = AdaptOptions{.points = 5, .v0 = {0.1}, .v1 = {1}}});
  return run;
}

const TracedRun& torus() {
  static const TracedRun run(
      "torus:R=1,r=0.4,n=200",
      {.cells = {4, 4, 2}, .adapt = AdaptOptions{.points = 5, .v0 = {0.1}, .v1 = {1}, .curvature = true}});
  return run;
}

TEST_F(FollowFirstSteps, AWrongRecord) {
  const auto change = [&]<class R>(const std::function<void(R&)>& edit, const std::string& words,
                                   const TracedRun& run = sphere()) {
    auto records = run.records;
    const std::size_t at = find<R>(records, 1);
    edit(std::get<R>(records[at]));
    expect_found(records, at, words, run);
  };
  auto records = sphere().records;
  get<trace::Lattice>(records).box[0].x() -= 1e-6;
  expect_found(records, 0, "step (i): the lattice is ");
  records = sphere().records;
  get<trace::Lattice>(records).cells[1] += 1;
  expect_found(records, 0, "step (i): the lattice has 5 x 5 x 5 cells, not 5 x 6 x 5");
  using Indicators = trace::Indicators;
  change.operator()<Indicators>(
      [](Indicators& r) { r.initial[0] = '0'; },
      "step (iii): the indicators with j = 1, k = 0 before Table 3 are ------, not 0");
  change.operator()<Indicators>([](Indicators& r) { r.after[0] = '+'; }, "j = 1, k = 0 after Table 3 are ");
  change.operator()<Indicators>([](Indicators& r) { r.initial += "-", r.after += "-"; },
                                " are ------, not -------");
  change.operator()<Indicators>([](Indicators& r) { r.j = 77; },
                                "j = 77, k = 0: this run has no such record");
  using Moved = trace::Moved;
  change.operator()<Moved>([](Moved& r) { r.point.y() += 1e-6; },
                           "reading D4: the place of the lattice vertex", groove());
  change.operator()<Moved>([](Moved& r) { r.mended = true; }, "it was not mended because of rounding",
                           groove());
  change.operator()<Moved>([](Moved& r) { r.vertex[0] = 99; }, "this run has no such record", groove());
  using Cut = trace::Cut;
  change.operator()<Cut>([](Cut& r) { r.point.z() += 1e-6; }, "step (ii): the cut of the lattice edge ");
  change.operator()<Cut>([](Cut& r) { r.edge[1][0] = 44; }, "this run has no such record");
  using Rows = trace::Rows;
  change.operator()<Rows>([](Rows& r) { r.rows[5] = "13"; },
                          "step (iv): the rows of Table 2 of the cell (1, 0, 0) are ");
  change.operator()<Rows>([](Rows& r) { r.cell[2] = 5; },
                          "of the cell (1, 0, 5): this run has no such record");
  using Mapped = trace::Mapped;
  change.operator()<Mapped>([](Mapped& r) { r.to.x() += 1e-6; }, "reading D12: the mapped point ");
  change.operator()<Mapped>([](Mapped& r) { r.from.x() += 1e-6; }, "this run has no such record");
}

TEST_F(FollowFirstSteps, ARecordMissingOrTwice) {
  const auto change = [&]<class R>(std::size_t n, const TracedRun& run) {
    auto records = run.records;
    const std::size_t at = find<R>(records, n);
    drop(records, at);
    expect_found(records, find<trace::FirstGrid>(records, 0), ": the trace has no such record", run);
    records = run.records;
    insert(records, at, records[at]);
    expect_found(records, at + 1, ": stands twice", run);
  };
  change.operator()<trace::Indicators>(2, sphere());
  change.operator()<trace::Moved>(2, groove());
  change.operator()<trace::Cut>(2, sphere());
  change.operator()<trace::Rows>(2, sphere());
  change.operator()<trace::Mapped>(2, sphere());
  // The lattice comes first.
  auto records = sphere().records;
  insert(records, 1, records[0]);
  expect_found(records, 1, "step (i): the lattice: stands twice");
  records = sphere().records;
  std::swap(records[0], records[1]);
  expect_found(records, 0, "step (i): a 'indicators' record before the lattice");
  drop(records, 1);
  expect_found(records, 0, "step (i): a 'indicators' record before the lattice");
}

TEST_F(FollowFirstSteps, AKindOfRecordsLeftOutIsNotChecked) {
  const auto without = [&](auto kind, const TracedRun& run) {
    auto records = run.records;
    std::erase_if(records, [&](const trace::Record& r) { return std::holds_alternative<decltype(kind)>(r); });
    return follow_records(records, run);
  };
  using Words = std::vector<std::string>;
  EXPECT_EQ(without(trace::Indicators{}, sphere()).not_checked, (Words{"settings", "indicators"}));
  EXPECT_EQ(without(trace::Cut{}, sphere()).not_checked, (Words{"settings", "cuts"}));
  EXPECT_EQ(without(trace::Rows{}, sphere()).not_checked, (Words{"settings", "rows of Table 2"}));
  EXPECT_TRUE(without(trace::Rows{}, sphere()).admissible);
  EXPECT_EQ(without(trace::Cut{}, groove()).not_checked, Words{"settings"});  // it has no cuts
  // These are not in every run: without them the trace says that nothing was moved.
  EXPECT_FALSE(without(trace::Moved{}, groove()).admissible);
  EXPECT_FALSE(without(trace::Mapped{}, sphere()).admissible);
  // With settings, everything was checked.
  auto records = sphere().records;
  insert(records, 0, settings_of(sphere().options, true));
  EXPECT_EQ(follow_records(records).not_checked, Words{});
  insert(records, 0, records[0]);
  expect_found(records, 1, "settings: stand twice");
}

TEST_F(FollowFirstSteps, OtherSettings) {
  const auto change = [&](auto&& edit, const std::string& words) {
    auto records = sphere().records;
    trace::Settings settings{.parametric = true, .improve = "solid-angle", .improve_below = 0.01};
    edit(settings);
    records.insert(records.begin(), settings);
    const Follow outcome = follow_records(records);
    EXPECT_EQ(outcome.admissible, words.empty()) << outcome.what;
    EXPECT_NE(outcome.what.find(words), std::string::npos) << outcome.what;
    EXPECT_EQ(outcome.line, words.empty() ? 0 : 1);
  };
  change([](trace::Settings&) {}, "");
  change([](trace::Settings& s) { s.points = "500"; }, "the trace has points 500, this run auto");
  change([](trace::Settings& s) { s.parametric = false; },
         "settings: the trace has parametric false, this run true");
  change([](trace::Settings& s) { s.region = "outside"; }, "the trace has region outside, this run inside");
  change([](trace::Settings& s) { s.p = 3; }, "the trace has p 3, this run 1");
  change([](trace::Settings& s) { s.improve_below = 0.002; }, "improve_below 0.002, this run 0.01");
  change([](trace::Settings& s) { s.curvature = true; }, "curvature true");
  change([](trace::Settings& s) { s.past_dilution = true; }, "past_dilution true");
  change([](trace::Settings& s) { s.literal = true; }, "literal true");
  change([](trace::Settings& s) { s.diagonals = "shortest"; }, "diagonals shortest, this run lowest");
  change([](trace::Settings& s) { s.box_scale = 1.3; }, "box_scale 1.3, this run 1.2");
  change([](trace::Settings& s) { s.on_surface = 0; }, "on_surface 0, this run 1e-06");
  change([](trace::Settings& s) { s.improve = "none"; }, "improve none, this run solid-angle");
}

TEST_F(FollowFirstSteps, WeightsOfStepV) {
  const auto change = [&](auto&& edit, const std::string& words, const TracedRun& run = sphere()) {
    auto records = run.records;
    const std::size_t at = find<trace::Weight>(records, 3);
    edit(std::get<trace::Weight>(records[at]));
    expect_found(records, at, words, run);
  };
  change([](trace::Weight& w) { w.d *= 1.01; }, "d, eq. (3.2)");
  change([](trace::Weight& w) { w.omega = 0.5; }, "omega, eq. (3.6)");
  change([](trace::Weight& w) { w.volume *= 1.01; }, "V of the tetrahedron");
  change([](trace::Weight& w) { w.desired *= 1.01; }, "V(d), eq. (3.1)");
  change([](trace::Weight& w) { w.error = 0; }, "E, eq. (3.3)");
  change([](trace::Weight& w) { w.tet[0].x() += 1; }, "there is no point");
  change([](trace::Weight& w) { w.kappa = *w.kappa * 1.01; }, "the absolute curvature kappa (D15)", torus());
  change([](trace::Weight& w) { w.kappa.reset(); }, "is missing", torus());
  auto records = sphere().records;
  const std::size_t at = find<trace::Weight>(records, 3), first = find<trace::FirstGrid>(records, 0);
  insert(records, at, records[at]);
  expect_found(records, at + 1, "is listed twice");
  records = sphere().records;
  drop(records, at);
  expect_found(records, first, "the first grid: no tetrahedron at ");
  records = sphere().records;
  get<trace::Weight>(records, 3).tet[0] = get<trace::Weight>(records, 40).tet[2];
  expect_found(records, at, " is not in it");
}

TEST_F(FollowFirstSteps, NumbersOfTheFirstGrid) {
  const auto change = [&](auto&& edit, const std::string& words, const TracedRun& run = sphere()) {
    auto records = run.records;
    edit(get<trace::FirstGrid>(records));
    expect_found(records, find<trace::FirstGrid>(records, 0), words, run);
  };
  using trace::FirstGrid;
  change([](FirstGrid& g) { ++g.points; }, "the first grid has ");
  change([](FirstGrid& g) { --g.tets; }, " tetrahedra, not ");
  change([](FirstGrid& g) { g.mean_volume *= 1 + 1e-6; }, "the mean volume is ");
  change([](FirstGrid& g) { g.v0 *= 1 + 1e-6; }, "V0 is ");
  change([](FirstGrid& g) { g.v1 *= -1; }, "V1 is ");
  change([](FirstGrid& g) { g.d1 *= 2; }, "d1 is ");
  change([](FirstGrid& g) { g.e_avg *= 1 + 1e-6; }, "E_avg of the first grid, eq. (3.4), is ");
  change([](FirstGrid& g) { g.e_avg_goal = 0.1; }, "the E_avg at which the insertion ends is 0, not 0.1");
  change([](FirstGrid& g) { *g.kappa_min *= 1.01; }, "the smallest absolute curvature (D15) is ", torus());
  change([](FirstGrid& g) { *g.kappa_max *= 1.01; }, "the largest absolute curvature (D15) is ", torus());
  change([](FirstGrid& g) { g.kappa_min.reset(); }, "the smallest absolute curvature (D15) is missing",
         torus());
  change([](FirstGrid& g) { g.kappa_max.reset(); }, "the largest absolute curvature (D15) is missing",
         torus());
  auto records = sphere().records;
  const std::size_t at = find<trace::FirstGrid>(records, 0);
  insert(records, at, records[at]);
  expect_found(records, at + 1, "step (v): a second first_grid record");
  records = sphere().records;
  insert(records, at + 2, records[find<trace::Cut>(records, 0)]);
  expect_found(records, at + 2, "step (v): a record of an earlier step, 'cut'");
  records = sphere().records;
  drop(records, at);
  EXPECT_NE(files.message([&] { follow_records(records); })
                .find(": expected the records 'first_grid' and 'weight'"),
            std::string::npos);
}

// If V0 is asked for as the trace states it, but all its V(d) come from another one, the first_grid record is
// at fault, not the first weight.
TEST_F(FollowFirstSteps, ConstantsThatNoWeightFollows) {
  for (const bool of_v0 : {true, false}) {
    TracedRun run = torus();
    auto& stated = get<trace::FirstGrid>(run.records);
    (of_v0 ? stated.v0 : stated.v1) *= 1.5;
    run.options.adapt->v0 = {stated.v0, true};
    run.options.adapt->v1 = {stated.v1, true};
    expect_found(run.records, find<trace::FirstGrid>(run.records, 0),
                 "V(d) of all tetrahedra is eq. (3.1) with other V0, V1 or d1 than are stated", run);
  }
}

// V(d) is steep at d = 0 where p < 1. There d is only rounding, and so may V(d) be.
TEST_F(FollowFirstSteps, DesiredVolumesWhereDIsRounding) {
  const TracedRun run("groove:m=3,depth=1",
                      {.region = Region::outside,
                       .cells = {3, 4, 2},
                       .box_scale = 4.0 / 3,
                       .on_surface = 0.1,
                       .adapt = AdaptOptions{.points = 5, .v0 = {0.2}, .v1 = {2}, .p = 0.25}});
  auto records = run.records;
  const trace::FirstGrid& first = get<trace::FirstGrid>(records);
  std::size_t n = 0;
  while (get<trace::Weight>(records, n).d > 1e-12 || get<trace::Weight>(records, n).d == 0) ++n;
  auto& weight = get<trace::Weight>(records, n);
  const double desired = weight.desired;
  weight.d *= 2;
  weight.desired = desired_volume(weight.d, {.v0 = first.v0, .v1 = first.v1, .d1 = first.d1, .p = 0.25});
  weight.error = std::abs(weight.volume - weight.desired);
  EXPECT_GT(std::abs(weight.desired - desired), 1e-5 * desired);
  expect_admissible(records, run);
  weight.desired *= 1.1;
  expect_found(records, find<trace::Weight>(records, n), "V(d), eq. (3.1)", run);
}

// One cell: no lattice vertex is inside, and the first grid is empty.
TEST_F(FollowFirstSteps, AnEmptyGrid) {
  const TracedRun run("sphere:r=1,n=300", {.cells = {1, 1, 1}, .adapt = AdaptOptions{}});
  ASSERT_TRUE(std::get<trace::End>(run.records.back()).stopped == "not-asked");
  expect_admissible(run.records, run);
  auto records = run.records;
  const std::size_t end = records.size() - 1;
  insert(records, end, sphere().records[find<trace::Insertion>(sphere().records, 0)]);
  expect_found(records, end,
               "the first grid is empty, so that it is not adapted; the trace has a 'insertion' record", run);
  records = run.records;
  get<trace::End>(records).stopped = "no-gain";
  expect_found(records, end, "the end: stopped: not-asked, not no-gain", run);
  records = run.records;
  get<trace::End>(records).tets = 1;
  expect_found(records, end, "the end: 0 tetrahedra, not 1", run);
  records = run.records;
  get<trace::End>(records).e_avg = 1;
  expect_found(records, end, "the end: E_avg is 0, not 1", run);
  records.back() = run.records.back();
  records.push_back(records.back());
  expect_found(records, end + 1, "a 'end' record after the end", run);
  records.resize(end);
  EXPECT_NE(files.message([&] { follow_records(records, run); }).find("the trace breaks off"),
            std::string::npos);
}

TEST_F(FollowFirstSteps, AGridThatIsNotAdapted) {
  const TracedRun run("sphere:r=1,n=300", {.cells = {4, 0, 0}});
  expect_admissible(run.records, run);
  auto records = run.records;
  const std::size_t end = records.size() - 1;
  insert(records, end, sphere().records[find<trace::FirstGrid>(sphere().records, 0)]);
  expect_found(records, end,
               "the first grid is the result, so that it is not adapted; the trace has a 'first_grid' record",
               run);
  records = run.records;
  get<trace::End>(records).points += 1;
  expect_found(records, end, " points, not ", run);
}

}  // namespace
}  // namespace tetproof::reference
