// SPDX-License-Identifier: GPL-3.0-or-later
// These are no differences: the order of records before the first insertion, the order of points, rounding.
// The order of insertions and flips is one. And files that are no traces.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/unit/verify/compare/traces.hpp"

namespace tetproof::test {
namespace {

using namespace trace;
using Verdict = verify::TraceComparison::Verdict;
using Records = std::vector<Record>;

TEST(TraceOrder, RecordsOfAStepComeInAnyOrder) {
  const TestFiles files;
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    Records other = small_trace();
    const auto begin = other.begin();
    std::shuffle(begin + indicators_line, begin + first_grid_line, random);
    std::shuffle(begin + first_grid_line, begin + insertion_line, random);
    const verify::TraceComparison result = compare(files, other, small_trace());
    EXPECT_EQ(result.verdict, Verdict::equal) << result.what;
    EXPECT_EQ(result.insertions, 4);
    EXPECT_EQ(result.flips, 2);
    EXPECT_TRUE(result.not_compared.empty());
    EXPECT_TRUE(result.notes.empty());
    EXPECT_EQ(compare(files, small_trace(), other).verdict, Verdict::equal);
  }
}

TEST(TraceOrder, PointsOfATetrahedronEdgeAndFaceComeInAnyOrder) {
  const TestFiles files;
  Records other = small_trace();
  for (Record& record : other) {
    if (auto* weight = std::get_if<Weight>(&record))
      std::rotate(weight->tet.begin(), weight->tet.begin() + 1, weight->tet.end());
    if (auto* insertion = std::get_if<Insertion>(&record)) {
      std::reverse(insertion->tet.begin(), insertion->tet.end());
      for (int& position : insertion->replaced) position = 3 - position;
    }
    if (auto* flip = std::get_if<Flip>(&record)) {
      std::swap(flip->edge[0], flip->edge[1]);
      std::rotate(flip->face.begin(), flip->face.begin() + 1, flip->face.end());
    }
    if (auto* cut = std::get_if<Cut>(&record)) std::swap(cut->edge[0], cut->edge[1]);
  }
  EXPECT_EQ(compare(files, other, small_trace()).verdict, Verdict::equal);
}

// After all four insertions, the flips of the faces below and above the centre do not touch each other.
TEST(TraceOrder, FlipsCountInTheirOrder) {
  const TestFiles files;
  const auto flipped = [](bool upper_first) {
    Records records = small_trace();
    records.resize(insertion_line);
    const Point above = (e + f + g + m) / 4, beside = (f + g + h) / 3;
    records.insert(records.end(), {Insertion{1, {a, b, c, m}, "1", {0, 1, 2, 3}, p, 0.19},
                                   Insertion{2, {e, f, g, m}, "1", {0, 1, 2, 3}, above, 0.18},
                                   Insertion{3, {b, c, d, m}, "3b", {0, 1, 2}, q, 0.17},
                                   Insertion{4, {f, g, h, m}, "3b", {0, 1, 2}, beside, 0.16}});
    const Record lower = flip(true, {b, c, m}, {p, q}, 0.15),
                 upper = flip(true, {f, g, m}, {above, beside}, 0.15);
    records.insert(records.end(), {upper_first ? upper : lower, upper_first ? lower : upper});
    records.push_back(End{"no-gain", 4, 2, 0, 13, 15, 0.15});
    return records;
  };
  EXPECT_EQ(compare(files, flipped(true), flipped(true)).what, "");
  const verify::TraceComparison result = compare(files, flipped(true), flipped(false));
  EXPECT_EQ(result.verdict, Verdict::unresolved);
  EXPECT_EQ(result.step, "flips");
  EXPECT_EQ(result.insertion, 4);
  EXPECT_EQ(
      result.what,
      "insertion 4, flip 1: reference makes the 2-3 flip at (1.017, 0.5083, 0.125), other makes the 2-3 "
      "flip at (1.017, 0.5083, 0.875)");
}

// Changes every number by `relative` of its size, and points by `relative` of the diagonal.
Records rounded(double relative) {
  std::mt19937 random(7);
  const auto off = [&] { return std::uniform_real_distribution<double>(-relative, relative)(random); };
  const auto number = [&](double& value) { value *= 1 + off(); };
  const auto point = [&](Point& p) { p += Point(off(), off(), off()); };
  Records records = small_trace();
  for (Record& record : records) {
    if (auto* r = std::get_if<Moved>(&record)) point(r->point);
    if (auto* r = std::get_if<Cut>(&record)) point(r->point);
    if (auto* r = std::get_if<Mapped>(&record)) point(r->from), point(r->to);
    if (auto* r = std::get_if<FirstGrid>(&record)) number(r->mean_volume), number(r->d1), number(r->e_avg);
    if (auto* r = std::get_if<Weight>(&record)) {
      for (Point& p : r->tet) point(p);
      number(r->d), number(*r->kappa), number(r->omega), number(r->volume), number(r->desired),
          number(r->error);
    }
    if (auto* r = std::get_if<Insertion>(&record)) {
      for (Point& p : r->tet) point(p);
      point(r->point), number(r->e_avg);
    }
    if (auto* r = std::get_if<Flip>(&record)) {
      for (Point& p : r->face) point(p);
      for (Point& p : r->edge) point(p);
      number(r->e_avg);
      *r = flip(r->two_to_three, r->face, r->edge, r->e_avg);
    }
    if (auto* r = std::get_if<End>(&record)) number(r->e_avg);
  }
  return records;
}

TEST(TraceTolerance, RoundingIsNoDifference) {
  const TestFiles files;
  EXPECT_EQ(compare(files, rounded(1e-14), small_trace()).what, "");
  EXPECT_EQ(compare(files, rounded(5e-10), small_trace()).what, "");
  EXPECT_EQ(compare(files, rounded(1e-7), small_trace()).verdict, Verdict::unresolved);
  EXPECT_EQ(compare(files, rounded(1e-7), small_trace(), 1e-6).what, "");
  EXPECT_EQ(compare(files, rounded(1e-14), small_trace(), 0).verdict, Verdict::unresolved);
  EXPECT_EQ(compare(files, small_trace(), small_trace(), 0).verdict, Verdict::equal);
}

// Two points of the reference that are closer than the tolerance remain two points.
TEST(TraceTolerance, CloseNeighboursAreToldApart) {
  const TestFiles files;
  Records reference = small_trace();
  const Point beside = m + Point(1e-10, 0, 0);
  at<Weight>(reference, weight_line + 3).tet = {e, f, g, beside};
  at<Insertion>(reference, fourth_insertion_line).tet = {e, f, g, beside};
  EXPECT_EQ(compare(files, reference, reference).what, "");
  Records other = reference;
  std::swap(at<Weight>(other, weight_line + 2).tet, at<Weight>(other, weight_line + 3).tet);
  EXPECT_EQ(compare(files, other, reference).step, "distance");
}

TEST(TraceNotCompared, KindsOfRecordsThatOneDoesNotTell) {
  const TestFiles files;
  const auto without = [](auto kind) {
    Records records = small_trace();
    std::erase_if(records,
                  [&](const Record& record) { return std::holds_alternative<decltype(kind)>(record); });
    return records;
  };
  const auto not_compared = [&](const Records& other, const Records& reference) {
    const verify::TraceComparison result = compare(files, other, reference);
    EXPECT_EQ(result.verdict, Verdict::equal) << result.what;
    return result.not_compared;
  };
  using Notes = std::vector<std::string>;
  EXPECT_EQ(not_compared(without(Indicators{}), small_trace()), Notes{"indicators: other has none"});
  EXPECT_EQ(not_compared(small_trace(), without(Indicators{})), Notes{"indicators: reference has none"});
  EXPECT_EQ(not_compared(without(Rows{}), small_trace()), Notes{"rows of Table 2: other has none"});
  EXPECT_EQ(not_compared(without(Weight{}), small_trace()),
            Notes{"the tetrahedra of the first grid: other has no weight records"});
  EXPECT_EQ(not_compared(small_trace(), without(Weight{})),
            Notes{"the tetrahedra of the first grid: reference has no weight records"});
  // Two traces that both break off have a wrong one.
  EXPECT_EQ(compare(files, without(End{}), without(End{})).wrong.file, files.path("other.jsonl"));
  // A trace without cuts or moved vertices, however, says that there are none.
  EXPECT_EQ(compare(files, without(Cut{}), small_trace()).step, "cut");
  EXPECT_EQ(compare(files, without(Moved{}), small_trace()).step, "moved");
}

TEST(TraceRefused, OutOfOrderOrNotInOrder) {
  const TestFiles files;
  const auto message = [&](const Records& other, const Records& reference = small_trace()) {
    return files.message([&] { compare(files, other, reference); });
  };
  Records records = small_trace();
  std::swap(records[lattice_line], records[cut_line]);
  EXPECT_EQ(message(records),
            "other.jsonl:2: expected a lattice record before all others but settings, found cut");
  EXPECT_EQ(message(small_trace(), records),
            "reference.jsonl:2: expected a lattice record before all others but settings, found cut");
  records = small_trace();
  records.insert(records.begin() + 3, records[lattice_line]);
  EXPECT_EQ(message(records), "other.jsonl:4: expected no second lattice record after line 2, found lattice");
  records = small_trace();
  records.insert(records.begin() + weight_line + 2, records[cut_line]);
  EXPECT_EQ(message(records), "other.jsonl:17: expected first_grid, weight, insertion or end, found cut");
  records = small_trace();
  records.push_back(records[weight_line]);
  EXPECT_EQ(message(records), "other.jsonl:26: expected nothing after the end, found weight");
  records = small_trace();
  at<Insertion>(records, third_insertion_line).n = 4;
  EXPECT_EQ(message(records), "other.jsonl:23: expected insertion 3, found insertion 4");
  records = small_trace();
  records.insert(records.begin() + cut_line, records[cut_line]);
  EXPECT_EQ(message(small_trace(), records),
            "reference.jsonl:9: expected another cut record, found the one of line 8 again");
  EXPECT_EQ(
      message({}),
      "other.jsonl:0: expected a lattice record before all others but settings, found the end of the trace");
  EXPECT_EQ(
      files.message([&] { verify::compare_traces(files.path("none.jsonl"), files.path("none.jsonl")); }),
      "none.jsonl: cannot open: No such file or directory");
  // If the tolerance is so large that everything lies within it, the comparison is refused.
  records = small_trace();
  records.resize(weight_line);
  for (int i = 0; i < 2000; ++i) records.push_back(weight({a, b, c, m + Point(0, 0, i * 1e-6)}, 1, 1));
  EXPECT_EQ(files.message([&] { compare(files, records, records, 1e-2); }).substr(0, 55),
            "more than 512 points lie within 8 times the tolerance 0");
}

}  // namespace
}  // namespace tetproof::test
