// SPDX-License-Identifier: GPL-3.0-or-later
// Following a trace: our own trace is admissible to its end, and every changed decision is found at its
// record.
#include "reference/follow/follow.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "reference/generate.hpp"

namespace tetproof::reference {
namespace {

using trace::Record;

struct Run {
  TriangleSurface surface;
  Options options;
  std::vector<Record> records;
};

const Run& run() {
  static const Run made = [] {
    Run r{corpus::make_surface("sphere:r=1,n=300"),
          {.cells = {5, 0, 0}, .adapt = AdaptOptions{.v0 = {0.2}, .v1 = {1}, .improve_below = 0.01}},
          {}};
    Options options = r.options;
    options.listener.record = [&](const Record& record) { r.records.push_back(record); };
    generate(r.surface, options);
    return r;
  }();
  return made;
}

class FollowTest : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }

  Follow follow_records(const std::vector<Record>& records) {
    {
      std::ofstream file(path_);
      for (const Record& record : records) file << trace::to_line(record) << '\n';
    }
    Options options = run().options;
    options.follow = path_;
    const Generation made = generate(run().surface, options);
    last_ = made.adaptation->insertions;
    return *made.follow;
  }

  // The position of the n-th record of a kind, from 0.
  template <class Kind>
  static std::size_t find(const std::vector<Record>& records, std::size_t n) {
    for (std::size_t i = 0; i < records.size(); ++i)
      if (std::holds_alternative<Kind>(records[i]) && n-- == 0) return i;
    throw std::logic_error("too few records for this test");
  }

  // Expects the change to be found at record `at`, with these words.
  void expect_found(const std::vector<Record>& records, std::size_t at, const std::string& words) {
    const Follow outcome = follow_records(records);
    EXPECT_FALSE(outcome.admissible);
    EXPECT_EQ(outcome.line, static_cast<std::int64_t>(at) + 1);
    EXPECT_NE(outcome.what.find(words), std::string::npos) << outcome.what;
  }

  std::string path_ = testing::TempDir() + "tetproof-follow-" + std::to_string(::getpid()) + ".jsonl";
  std::int64_t last_ = 0;
};

TEST_F(FollowTest, OurOwnTraceIsAdmissibleToTheEnd) {
  const Follow outcome = follow_records(run().records);
  EXPECT_TRUE(outcome.admissible) << outcome.what;
  EXPECT_EQ(outcome.ties, 0);
  EXPECT_GT(last_, 100);
  const auto& end = std::get<trace::End>(run().records.back());
  EXPECT_EQ(last_, end.insertions);
  EXPECT_GT(end.flips, 10);
}

TEST_F(FollowTest, CoordinatesOfAnotherRoundingAreAdopted) {
  auto records = run().records;
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
  auto records = run().records;
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
  auto records = run().records;
  const std::size_t at = find<trace::Insertion>(records, 7);
  std::get<trace::Insertion>(records[at]).row = "4b";
  expect_found(records, at, "of Table 4, not 4b");
}

TEST_F(FollowTest, APointElsewhere) {
  auto records = run().records;
  const std::size_t at = find<trace::Insertion>(records, 7);
  std::get<trace::Insertion>(records[at]).point.x() += 1e-6;
  expect_found(records, at, "insertion 8: row");
}

TEST_F(FollowTest, AnotherSimplex) {
  auto records = run().records;
  std::size_t n = 0, at = 0;
  do at = find<trace::Insertion>(records, n++);
  while (std::get<trace::Insertion>(records[at]).row != "3b");
  auto& insertion = std::get<trace::Insertion>(records[at]);
  insertion.replaced = {0, 1, 2, 3};
  insertion.point = (insertion.tet[0] + insertion.tet[1] + insertion.tet[2] + insertion.tet[3]) / 4;
  expect_found(records, at, "on another edge or face");
}

TEST_F(FollowTest, AWrongAverage) {
  auto records = run().records;
  const std::size_t at = find<trace::Insertion>(records, 30);
  std::get<trace::Insertion>(records[at]).e_avg *= 1.001;
  expect_found(records, at, "insertion 31: E'avg, eq. (3.5)");
}

TEST_F(FollowTest, AWorseTetrahedron) {
  auto records = run().records;
  const std::size_t first = find<trace::Insertion>(records, 0), later = find<trace::Insertion>(records, 40);
  std::swap(records[first], records[later]);
  expect_found(records, first, "insertion 1: ");
}

TEST_F(FollowTest, AFlipLeftOut) {
  auto records = run().records;
  const std::size_t at = find<trace::Flip>(records, 0);
  records.erase(records.begin() + static_cast<std::ptrdiff_t>(at));
  const Follow outcome = follow_records(records);
  EXPECT_FALSE(outcome.admissible);
  EXPECT_NE(outcome.what.find("flip"), std::string::npos) << outcome.what;
  EXPECT_EQ(outcome.line, static_cast<std::int64_t>(at) + 1);
}

TEST_F(FollowTest, AFlipThatIsNone) {
  auto records = run().records;
  const std::size_t at = find<trace::Flip>(records, 0);
  auto& flip = std::get<trace::Flip>(records[at]);
  flip.two_to_three = !flip.two_to_three;
  expect_found(records, at, "is not one of a strictly convex hexahedron within O_i");
}

TEST_F(FollowTest, AnEndTooSoonOrForAnotherReason) {
  auto records = run().records;
  const trace::End end = std::get<trace::End>(records.back());
  const std::size_t at = find<trace::Insertion>(records, 50);
  records.resize(at);
  records.push_back(end);
  expect_found(records, at, "can still be split");
  records = run().records;
  std::get<trace::End>(records.back()).stopped = "stalled";
  expect_found(records, records.size() - 1, "not stalled");
}

TEST_F(FollowTest, WeightsOfStepV) {
  const auto change = [&](auto&& edit, const std::string& words) {
    auto records = run().records;
    edit(std::get<trace::Weight>(records[find<trace::Weight>(records, 3)]));
    const Follow outcome = follow_records(records);
    EXPECT_FALSE(outcome.admissible);
    EXPECT_NE(outcome.what.find(words), std::string::npos) << outcome.what;
  };
  change([](trace::Weight& w) { w.d *= 1.01; }, "d, eq. (3.2)");
  change([](trace::Weight& w) { w.omega = 0.5; }, "omega, eq. (3.6)");
  change([](trace::Weight& w) { w.volume *= 1.01; }, "V of the tetrahedron");
  change([](trace::Weight& w) { w.desired *= 1.01; }, "V(d), eq. (3.1)");
  change([](trace::Weight& w) { w.error = 0; }, "E, eq. (3.3)");
  change([](trace::Weight& w) { w.tet[0].x() += 1; }, "there is no point");
  auto records = run().records;
  std::get<trace::FirstGrid>(records[find<trace::FirstGrid>(records, 0)]).d1 *= 2;
  EXPECT_NE(follow_records(records).what.find("d1 is"), std::string::npos);
}

TEST_F(FollowTest, OtherSettings) {
  const auto change = [&](auto&& edit, const std::string& words) {
    auto records = run().records;
    trace::Settings settings{.parametric = true, .improve = "solid-angle", .improve_below = 0.01};
    edit(settings);
    records.insert(records.begin(), settings);
    const Follow outcome = follow_records(records);
    EXPECT_EQ(outcome.admissible, words.empty()) << outcome.what;
    EXPECT_NE(outcome.what.find(words), std::string::npos) << outcome.what;
  };
  change([](trace::Settings&) {}, "");
  change([](trace::Settings& s) { s.points = "500"; }, "");
  change([](trace::Settings& s) { s.parametric = false; },
         "settings: the trace has parametric false, this run true");
  change([](trace::Settings& s) { s.region = "outside"; }, "the trace has region outside, this run inside");
  change([](trace::Settings& s) { s.p = 3; }, "the trace has p 3, this run 1");
  change([](trace::Settings& s) { s.improve_below = 0.002; }, "improve_below 0.002, this run 0.01");
  change([](trace::Settings& s) { s.curvature = true; }, "curvature true");
  change([](trace::Settings& s) { s.improve = "none"; }, "improve none, this run solid-angle");
}

TEST_F(FollowTest, ATraceThatBreaksOffIsBadInput) {
  auto records = run().records;
  records.pop_back();
  EXPECT_THROW(follow_records(records), InputError);
  EXPECT_THROW(follow_records({}), InputError);
}

}  // namespace
}  // namespace tetproof::reference
