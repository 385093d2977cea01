// SPDX-License-Identifier: GPL-3.0-or-later
// These are no differences: the order of records and points, rounding, ties resolved in another order. And
// files that are no traces.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/unit/verify/compare/traces.hpp"

namespace tetproof::test {
namespace {

using namespace trace;
using Verdict = verify::TraceComparison::Verdict;
using Records = std::vector<Record>;

template <class R>
R& at(Records& records, std::size_t line) {
  return std::get<R>(records.at(line));
}

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
    EXPECT_EQ(result.reordered, 0);
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
  std::swap(other[flip_line], other[flip_line + 1]);  // the same set of flips
  std::swap(at<Flip>(other, flip_line).e_avg, at<Flip>(other, flip_line + 1).e_avg);
  EXPECT_EQ(compare(files, other, small_trace()).verdict, Verdict::equal);
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
    }
    if (auto* r = std::get_if<End>(&record)) number(r->e_avg);
  }
  return records;
}

TEST(TraceTolerance, RoundingIsNoDifference) {
  const TestFiles files;
  EXPECT_EQ(compare(files, rounded(1e-14), small_trace()).what, "");
  EXPECT_EQ(compare(files, rounded(5e-10), small_trace()).what, "");
  EXPECT_EQ(compare(files, rounded(1e-7), small_trace()).verdict, Verdict::diverges);
  EXPECT_EQ(compare(files, rounded(1e-7), small_trace(), 1e-6).what, "");
  EXPECT_EQ(compare(files, rounded(1e-14), small_trace(), 0).verdict, Verdict::diverges);
  EXPECT_EQ(compare(files, small_trace(), small_trace(), 0).verdict, Verdict::equal);
}

// Two points of the reference that are closer than the tolerance remain two points.
TEST(TraceTolerance, CloseNeighboursAreToldApart) {
  const TestFiles files;
  Records reference = small_trace();
  const Point beside = m + Point(1e-10, 0, 0);
  at<Weight>(reference, weight_line + 3).tet = {e, f, g, beside};
  EXPECT_EQ(compare(files, reference, reference).what, "");
  Records other = reference;
  std::swap(at<Weight>(other, weight_line + 2).tet, at<Weight>(other, weight_line + 3).tet);
  EXPECT_EQ(compare(files, other, reference).step, "distance");
}

// Insertions 2 to 4 tie pairwise: all E'avg are the same in both traces, in whatever order they come.
Records ties(const std::vector<int>& order) {
  const Records all = small_trace();
  const std::array<Record, 4> inserted{all[insertion_line], all[second_insertion_line],
                                       all[third_insertion_line], all[fourth_insertion_line]};
  Records records(all.begin(), all.begin() + insertion_line);
  constexpr double e_avg[] = {0.19, 0.18, 0.17, 0.16};
  for (std::size_t n = 0; n < order.size(); ++n) {
    records.push_back(inserted[order[n]]);
    at<Insertion>(records, insertion_line + n).n = static_cast<std::int64_t>(n) + 1;
    at<Insertion>(records, insertion_line + n).e_avg = e_avg[n];
  }
  records.push_back(End{"no-gain", 4, 0, 0, 13, 12, 0.16});
  return records;
}

TEST(TraceTies, TheSameSplitsInAnotherOrderGoOn) {
  const TestFiles files;
  const std::vector<int> straight{0, 1, 2, 3};
  std::vector<int> order = straight;
  do {
    const verify::TraceComparison result = compare(files, ties(order), ties(straight));
    EXPECT_EQ(result.verdict, Verdict::equal) << result.what;
    EXPECT_EQ(result.insertions, 4);
    // Groups of positions that are permuted among themselves. A group of one position stays in place.
    std::int64_t reordered = 0;
    for (int i = 0, start = 0; i < 4; ++i)
      if (*std::max_element(order.begin(), order.begin() + i + 1) == i) {
        if (i > start) reordered += i - start + 1;
        start = i + 1;
      }
    EXPECT_EQ(result.reordered, reordered);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(TraceTies, EavgMayDifferByRoundingOnly) {
  const TestFiles files;
  Records other = ties({0, 2, 1, 3});
  at<Insertion>(other, insertion_line + 1).e_avg *= 1 + 5e-13;
  EXPECT_EQ(compare(files, other, ties({0, 1, 2, 3})).verdict, Verdict::equal);
  at<Insertion>(other, insertion_line + 1).e_avg = 0.18 * (1 + 5e-12);
  const verify::TraceComparison result = compare(files, other, ties({0, 1, 2, 3}));
  EXPECT_EQ(result.verdict, Verdict::diverges);
  EXPECT_EQ(result.step, "choice");
  EXPECT_EQ(result.insertion, 2);
  // If E_avg already differed by rounding before, the choice is still a tie.
  at<Insertion>(other, insertion_line).e_avg = 0.19 + 0.18 * 5e-12;
  EXPECT_EQ(compare(files, other, ties({0, 1, 2, 3})).verdict, Verdict::equal);
}

TEST(TraceTies, ATieThatLeadsElsewhereEndsTheComparison) {
  const TestFiles files;
  Records other = ties({0, 2, 1, 3});
  at<Insertion>(other, insertion_line + 2).e_avg = 0.165;  // after the first of the two
  const verify::TraceComparison result = compare(files, other, ties({0, 1, 2, 3}));
  EXPECT_EQ(result.verdict, Verdict::tie);
  EXPECT_EQ(result.step, "choice");
  EXPECT_EQ(result.insertion, 2);
  EXPECT_EQ(result.insertions, 1);
  EXPECT_EQ(result.what,
            "insertion 2: reference splits the tetrahedron at (1.25, 0.625, 0.125) by row 3b, other the one "
            "at (0.75, 0.375, 0.875) by row 4c; "
            "E'avg 0.18 against 0.18: a tie");
  EXPECT_NE(
      verify::comparison_text(result).find(
          "from here on the two can't be compared step by step; tetproof-mesh --follow checks the rest"),
      std::string::npos);

  EXPECT_EQ(result.notes,
            std::vector<std::string>{"the tie was never closed; E'avg first differs at insertion 3: 0.17 in "
                                     "reference, 0.165 in other"});

  // The traces may also end before the tie is closed.
  Records shorter = ties({0, 1}), reference = ties({0, 2});
  EXPECT_EQ(compare(files, shorter, reference).verdict, Verdict::tie);
  EXPECT_EQ(compare(files, shorter, ties({0, 2, 3})).verdict, Verdict::tie);
}

TEST(TraceTies, WithinATieRowsAreStillCompared) {
  const TestFiles files;
  Records other = ties({0, 2, 1, 3});
  at<Insertion>(other, insertion_line + 1).row = "4d";
  const verify::TraceComparison result = compare(files, other, ties({0, 1, 2, 3}));
  EXPECT_EQ(result.verdict, Verdict::diverges);
  EXPECT_EQ(result.step, "table-4");
  EXPECT_EQ(result.insertion, 3);
}

// Only one trace has split a tetrahedron so far. When the other splits it, too, the pieces are matched.
TEST(TraceTies, SplitsOfPiecesWait) {
  const TestFiles files;
  const auto records = [](bool swapped) {
    Records r = ties({});
    r.pop_back();
    Insertion one{1, {a, b, c, m}, "1", {0, 1, 2, 3}, (a + b + c + m) / 4, 0.19},
        piece{2, {a, b, c, (a + b + c + m) / 4}, "1", {0, 1, 2, 3}, (a * 5 + b * 5 + c * 5 + m) / 16, 0.18},
        two{3, {b, c, d, m}, "1", {0, 1, 2, 3}, (b + c + d + m) / 4, 0.17},
        piece_of_two{4,   {b, c, d, (b + c + d + m) / 4}, "1", {0, 1, 2, 3}, (b * 5 + c * 5 + d * 5 + m) / 16,
                     0.16};
    if (swapped) {
      std::swap(one, two), std::swap(piece, piece_of_two);
      std::swap(one.n, two.n), std::swap(piece.n, piece_of_two.n);
      std::swap(one.e_avg, two.e_avg), std::swap(piece.e_avg, piece_of_two.e_avg);
      // Differs in one bit, as another implementation's centroid may.
      two.point += Point(1e-16, 0, 0), piece_of_two.tet[3] = two.point;
    }
    r.insert(r.end(), {one, piece, two, piece_of_two, End{"points", 4, 0, 0, 13, 12, 0.16}});
    return r;
  };
  const verify::TraceComparison result = compare(files, records(true), records(false));
  EXPECT_EQ(result.verdict, Verdict::equal) << result.what;
  EXPECT_EQ(result.reordered, 4);
}

TEST(TraceTies, FlipsOfEqualGain) {
  const TestFiles files;
  Records other = small_trace();
  at<Flip>(other, flip_line).edge[1] = e;  // another flip with the same qualities
  const verify::TraceComparison result = compare(files, other, small_trace());
  EXPECT_EQ(result.verdict, Verdict::tie);
  EXPECT_EQ(result.step, "flips");
  EXPECT_EQ(result.what,
            "insertion 2, flip 1: reference makes the 2-3 flip at (1, 0.5, 0.1), other makes the 2-3 flip at "
            "(0.6, 0.3, 0.3); "
            "a tie: both raise the smallest quality by 0.01");
}

TEST(TraceNotes, KindsOfRecordsThatOneDoesNotTell) {
  const TestFiles files;
  const auto without = [](auto kind) {
    Records records = small_trace();
    std::erase_if(records,
                  [&](const Record& record) { return std::holds_alternative<decltype(kind)>(record); });
    return records;
  };
  const auto notes = [&](const Records& other, const Records& reference) {
    const verify::TraceComparison result = compare(files, other, reference);
    EXPECT_EQ(result.verdict, Verdict::equal) << result.what;
    return result.notes;
  };
  using Notes = std::vector<std::string>;
  EXPECT_EQ(notes(without(Indicators{}), small_trace()),
            Notes{"indicators are not compared: other has none"});
  EXPECT_EQ(notes(small_trace(), without(Indicators{})),
            Notes{"indicators are not compared: reference has none"});
  EXPECT_EQ(notes(without(Rows{}), small_trace()), Notes{"rows of Table 2 are not compared: other has none"});
  EXPECT_EQ(notes(without(Weight{}), small_trace()),
            Notes{"the tetrahedra of the first grid are not compared: other has no weight records"});
  EXPECT_EQ(notes(small_trace(), without(Weight{})),
            Notes{"the tetrahedra of the first grid are not compared: reference has no weight records"});
  EXPECT_EQ(notes(without(End{}), without(End{})), Notes{"both traces break off, without an end record"});
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
  EXPECT_EQ(message(records), "other.jsonl:23: expected insertion 3, after 2, found insertion");
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
