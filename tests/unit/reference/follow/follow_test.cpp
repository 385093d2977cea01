// SPDX-License-Identifier: GPL-3.0-or-later
// Following a trace through step (vi): our own trace is admissible to its end, and every changed decision is
// found at its record.
#include "reference/follow/follow.hpp"

#include <algorithm>

#include "tests/unit/reference/follow/followed.hpp"

namespace tetproof::reference {
namespace {

using trace::Record;

TEST_F(FollowTest, OurOwnTraceIsAdmissibleToTheEnd) {
  const Generation made = generate_along(sphere().records);
  EXPECT_TRUE(made.follow->admissible) << made.follow->what;
  EXPECT_EQ(made.follow->ties, 0);
  EXPECT_EQ(made.follow->not_checked, std::vector<std::string>{"settings"});
  EXPECT_GT(made.adaptation->insertions, 100);
  const auto& end = std::get<trace::End>(sphere().records.back());
  EXPECT_EQ(made.adaptation->insertions, end.insertions);
  EXPECT_GT(end.flips, 10);
}

TEST_F(FollowTest, CoordinatesOfAnotherRoundingAreAdopted) {
  auto records = sphere().records;
  const auto nudge = [](Eigen::Vector3d& p) { p = (p * (1 + 1e-13)).eval(); };
  for (Record& record : records) {
    if (auto* weight = std::get_if<trace::Weight>(&record))
      std::for_each(weight->tet.begin(), weight->tet.end(), nudge);
    if (auto* insertion = std::get_if<trace::Insertion>(&record)) {
      std::for_each(insertion->tet.begin(), insertion->tet.end(), nudge);
      nudge(insertion->point);
    }
    if (auto* flip = std::get_if<trace::Flip>(&record)) {
      std::for_each(flip->face.begin(), flip->face.end(), nudge);
      std::for_each(flip->edge.begin(), flip->edge.end(), nudge);
    }
  }
  const Follow outcome = follow_records(records);
  EXPECT_TRUE(outcome.admissible) << outcome.what;
}

TEST_F(FollowTest, AnInsertionLeftOut) {
  auto records = sphere().records;
  const std::size_t at = find<trace::Insertion>(records, 20);
  records.erase(records.begin() + static_cast<std::ptrdiff_t>(at));
  std::size_t next = at;
  while (!std::holds_alternative<trace::Insertion>(records[next]) &&
         !std::holds_alternative<trace::Flip>(records[next]))
    ++next;
  expect_found(
      records, next,
      std::holds_alternative<trace::Flip>(records[next]) ? "flip after insertion 20" : "insertion 21:");
}

TEST_F(FollowTest, AWrongRow) {
  auto records = sphere().records;
  const std::size_t at = find<trace::Insertion>(records, 7);
  std::get<trace::Insertion>(records[at]).row = "4b";
  expect_found(records, at, "of Table 4, not 4b");
}

TEST_F(FollowTest, APointElsewhere) {
  auto records = sphere().records;
  const std::size_t at = find<trace::Insertion>(records, 7);
  std::get<trace::Insertion>(records[at]).point.x() += 1e-6;
  expect_found(records, at, "insertion 8: row");
}

TEST_F(FollowTest, AnotherSimplex) {
  auto records = sphere().records;
  std::size_t n = 0, at = 0;
  do at = find<trace::Insertion>(records, n++);
  while (std::get<trace::Insertion>(records[at]).row != "3b");
  auto& insertion = std::get<trace::Insertion>(records[at]);
  insertion.replaced = {0, 1, 2, 3};
  insertion.point = (insertion.tet[0] + insertion.tet[1] + insertion.tet[2] + insertion.tet[3]) / 4;
  expect_found(records, at, "on another edge or face");
}

TEST_F(FollowTest, AWrongAverage) {
  auto records = sphere().records;
  const std::size_t at = find<trace::Insertion>(records, 30);
  std::get<trace::Insertion>(records[at]).e_avg *= 1.001;
  expect_found(records, at, "insertion 31: E'avg, eq. (3.5)");
}

// With `literal`, E'avg is a mean over L+3 tetrahedra, but a trace states the average after the split.
TEST_F(FollowTest, AveragesWhereLPlus3IsTakenLiterally) {
  const TracedRun run("terrain:seed=5,m=3", {.cells = {4, 4, 4},
                                             .box_scale = 4.0 / 3,
                                             .literal = true,
                                             .adapt = AdaptOptions{.points = 100, .v0 = {0.1}, .v1 = {1}}});
  auto records = run.records;
  std::size_t n = 0;
  while (get<trace::Insertion>(records, n).replaced.size() == 4) ++n;
  expect_admissible(records, run);
  get<trace::Insertion>(records, n).e_avg *= 1 + 1e-6;
  expect_found(records, find<trace::Insertion>(records, n), "E'avg, eq. (3.5), is ", run);
}

TEST_F(FollowTest, AWorseTetrahedron) {
  auto records = sphere().records;
  const std::size_t first = find<trace::Insertion>(records, 0), later = find<trace::Insertion>(records, 40);
  std::swap(records[first], records[later]);
  expect_found(records, first, "insertion 1: ");
}

TEST_F(FollowTest, AFlipLeftOut) {
  auto records = sphere().records;
  const std::size_t at = find<trace::Flip>(records, 0);
  records.erase(records.begin() + static_cast<std::ptrdiff_t>(at));
  const Follow outcome = follow_records(records);
  EXPECT_FALSE(outcome.admissible);
  EXPECT_NE(outcome.what.find("flip"), std::string::npos) << outcome.what;
  EXPECT_EQ(outcome.line, static_cast<std::int64_t>(at) + 1);
}

TEST_F(FollowTest, AFlipThatIsNone) {
  auto records = sphere().records;
  const std::size_t at = find<trace::Flip>(records, 0);
  auto& flip = std::get<trace::Flip>(records[at]);
  flip.two_to_three = !flip.two_to_three;
  expect_found(records, at, "is not one of a strictly convex hexahedron within O_i");
}

TEST_F(FollowTest, AnEndTooSoonOrForAnotherReason) {
  auto records = sphere().records;
  const trace::End end = std::get<trace::End>(records.back());
  const std::size_t at = find<trace::Insertion>(records, 50);
  records.resize(at);
  records.push_back(end);
  expect_found(records, at, "can still be split");
  records = sphere().records;
  std::get<trace::End>(records.back()).stopped = "stalled";
  expect_found(records, records.size() - 1, "not stalled");
}

TEST_F(FollowTest, AnotherNumberOfTheInsertion) {
  auto records = sphere().records;
  const std::size_t at = find<trace::Insertion>(records, 7);
  std::get<trace::Insertion>(records[at]).n = 9;
  expect_found(records, at, "insertion 8: the trace calls it 9");
}

TEST_F(FollowTest, FalseQualitiesOfAFlip) {
  for (const bool before : {true, false})
    for (const double factor : {1 + 1e-6, -1.0, 0.0}) {
      auto records = sphere().records;
      const std::size_t at = find<trace::Flip>(records, 3);
      auto& flip = std::get<trace::Flip>(records[at]);
      (before ? flip.quality_before : flip.quality_after) *= factor;
      expect_found(records, at,
                   before ? "the smallest quality before the " : "the smallest quality after the ");
    }
}

TEST_F(FollowTest, AFalseAverageAfterAFlip) {
  auto records = sphere().records;
  const std::size_t at = find<trace::Flip>(records, 3);
  std::get<trace::Flip>(records[at]).e_avg *= 1 + 1e-6;
  expect_found(records, at, "E_avg is ");
}

TEST_F(FollowTest, FlipsInAnotherOrder) {
  auto records = sphere().records;
  std::size_t at = 0;
  for (std::size_t n = 0;; ++n) {
    at = find<trace::Flip>(records, n);
    if (std::holds_alternative<trace::Flip>(records[at + 1])) break;
  }
  std::swap(records[at], records[at + 1]);
  expect_found(records, at, "flip after insertion ");
}

TEST_F(FollowTest, AFlipTwice) {
  auto records = sphere().records;
  const std::size_t at = find<trace::Flip>(records, 0);
  insert(records, at, records[at]);
  expect_found(records, at + 1, "is not one of a strictly convex hexahedron within O_i");
}

TEST_F(FollowTest, NumbersOfTheEnd) {
  const auto change = [&](auto&& edit, const std::string& words) {
    auto records = sphere().records;
    edit(get<trace::End>(records));
    expect_found(records, records.size() - 1, words);
  };
  change([](trace::End& end) { ++end.insertions; }, "the end: ");
  change([](trace::End& end) { --end.flips; }, " flips, not ");
  change([](trace::End& end) { ++end.refused; }, "the end: 0 refused splits, not 1");
  change([](trace::End& end) { ++end.points; }, " points, not ");
  change([](trace::End& end) { --end.tets; }, " tetrahedra, not ");
  change([](trace::End& end) { end.e_avg *= 1 + 1e-6; }, "the end: E_avg is ");
}

TEST_F(FollowTest, ARecordAfterTheEndOrOutOfOrder) {
  auto records = sphere().records;
  records.push_back(records.back());
  expect_found(records, records.size() - 1, "a 'end' record after the end");
  records = sphere().records;
  const std::size_t at = find<trace::Insertion>(records, 5);
  insert(records, at, records[find<trace::Weight>(records, 0)]);
  expect_found(records, at, "step (vi): a record of an earlier step, 'weight'");
  records = sphere().records;
  insert(records, find<trace::Insertion>(records, 0), records[find<trace::Flip>(records, 0)]);
  expect_found(records, find<trace::Insertion>(records, 0) - 1, "insertion 0: a flip, although");
}

TEST_F(FollowTest, ATraceThatBreaksOffIsBadInput) {
  const auto message = [&](std::size_t length) {
    auto records = sphere().records;
    records.resize(length);
    return files.message([&] { follow_records(records); });
  };
  const Records& all = sphere().records;
  EXPECT_EQ(message(0),
            "trace.jsonl:0: expected an 'end' record, found the end of the file: the trace breaks off");
  for (const std::size_t length :
       {find<trace::Cut>(all, 3), find<trace::FirstGrid>(all, 0), find<trace::Weight>(all, 5),
        find<trace::Insertion>(all, 0), find<trace::Insertion>(all, 30), all.size() - 1}) {
    const std::string said = message(length);
    EXPECT_EQ(said.substr(0, said.find(": expected")), "trace.jsonl:" + std::to_string(length));
  }
}

}  // namespace
}  // namespace tetproof::reference
