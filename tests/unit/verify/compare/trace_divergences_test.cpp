// SPDX-License-Identifier: GPL-3.0-or-later
// Plants each kind of difference into a handmade trace. The comparison finds it at its step, names the lines
// of both files, and describes it in the paper's words.
#include <gtest/gtest.h>

#include <functional>
#include <ostream>

#include "tests/unit/verify/compare/traces.hpp"

namespace tetproof::test {
namespace {

using namespace trace;
using Verdict = verify::TraceComparison::Verdict;
using Records = std::vector<Record>;

struct Case {
  std::string name;
  std::function<void(Records&)> plant;  // into the other trace
  std::string step;
  std::int64_t insertion, reference_line, other_line;  // lines count from 1; 0: none
  std::string what;
  // Whether the traces part there; or were asked for different things; or the changed one contradicts itself.
  enum { part, asked, contradicts } kind = part;

  friend void PrintTo(const Case& test, std::ostream* out) { *out << test.name; }
};

void drop(Records& records, std::size_t line) {
  records.erase(records.begin() + static_cast<std::ptrdiff_t>(line));
}

const std::vector<Case> cases{
    {"Settings",
     [](Records& r) {
       at<Settings>(r, settings_line).p = 0.25;
       at<Settings>(r, settings_line).region = "outside";
     },
     "settings", 0, 1, 1,
     "the settings differ: region is inside in reference, outside in other; p is 1 in reference, 0.25 in "
     "other",
     Case::asked},
    {"Cells",
     [](Records& r) {
       at<Lattice>(r, lattice_line).cells = {2, 2, 1};
     },
     "lattice", 0, 2, 2, "the lattice has 2 x 1 x 1 cells in reference, 2 x 2 x 1 in other", Case::asked},
    {"Box", [](Records& r) { at<Lattice>(r, lattice_line).box[1].x() = 2.1; }, "lattice", 0, 2, 2,
     "the lattice's boxes differ"},
    {"InitialIndicator", [](Records& r) { at<Indicators>(r, indicators_line + 1).initial = "-++"; },
     "indicators", 0, in_file(indicators_line + 1), in_file(indicators_line + 1),
     "lattice vertex (1, 1, 0) is initially on the surface (0) in reference, interior (+1) in other"},
    {"IndicatorAfterTable3", [](Records& r) { at<Indicators>(r, indicators_line + 1).after = "--+"; },
     "table-3", 0, in_file(indicators_line + 1), in_file(indicators_line + 1),
     "lattice vertex (1, 1, 0) is after Table 3 interior (+1) in reference, exterior (-1) in other"},
    {"IndicatorsMissing", [](Records& r) { drop(r, indicators_line + 3); }, "indicators", 0,
     in_file(indicators_line + 3), 0, "indicators of the lattice vertices (0..2, 1, 1): only in reference"},
    {"Moved", [](Records& r) { at<Moved>(r, moved_line).point.z() = 0.02; }, "moved", 0, in_file(moved_line),
     in_file(moved_line),
     "lattice vertex (1, 1, 0) is moved to the surface at (1, 1, 0.01) in reference, at (1, 1, 0.02) in "
     "other, 0.01 apart"},
    {"NotMoved", [](Records& r) { drop(r, moved_line); }, "moved", 0, in_file(moved_line), 0,
     "lattice vertex (1, 1, 0) is moved to the surface: only in reference"},
    {"MovedToo",
     [](Records& r) {
       r.insert(r.begin() + moved_line, Moved{{2, 0, 1}, Point(2, 0, 0.9)});
     },
     "moved", 0, 0, in_file(moved_line), "lattice vertex (2, 0, 1) is moved to the surface: only in other"},
    {"Cut", [](Records& r) { at<Cut>(r, cut_line + 1).point.x() = 0.75; }, "cut", 0, in_file(cut_line + 1),
     in_file(cut_line + 1),
     "cut of the lattice edge (0, 1, 1)-(1, 1, 1) at (0.25, 1, 1) in reference, at (0.75, 1, 1) in other, "
     "0.5 apart (Table 3, row 3b: "
     "of several, the one closest to the exterior end)"},
    {"CutMissing", [](Records& r) { drop(r, cut_line); }, "cut", 0, in_file(cut_line), 0,
     "cut of the lattice edge (0, 0, 0)-(1, 0, 0): only in reference"},
    {"CutTwice", [](Records& r) { r.insert(r.begin() + cut_line, r[cut_line]); }, "cut", 0, in_file(cut_line),
     in_file(cut_line + 1), "cut of the lattice edge (0, 0, 0)-(1, 0, 0): twice in other"},
    {"RowOfTable2",  // and its consequence
     [](Records& r) {
       at<Rows>(r, rows_line).rows[2] = "10d";
       at<Weight>(r, weight_line).tet[2] = d;
     },
     "table-2", 0, in_file(rows_line), in_file(rows_line),
     "tetrahedron yxz of cell (0, 0, 0) is cut by row 10a of Table 2 in reference, by row 10d in other"},
    {"NameOfTable2", [](Records& r) { at<Rows>(r, rows_line).rows[2] = "10d"; }, "table-2", 0,
     in_file(rows_line), in_file(rows_line),
     "tetrahedron yxz of cell (0, 0, 0) is cut by row 10a of Table 2 in reference, by row 10d in other; the "
     "tetrahedra of the first grid are the same"},
    {"Mapped", [](Records& r) { at<Mapped>(r, mapped_line).to.z() = 0; }, "mapped", 0, in_file(mapped_line),
     in_file(mapped_line),
     "cut (0.5, 0, 0) is taken to the parametric surface at (0.5, 0, -0.01) in reference, at (0.5, 0, 0) in "
     "other, 0.01 apart"},
    {"FirstGridMissesOne", [](Records& r) { drop(r, weight_line + 2); }, "first-grid", 0,
     in_file(weight_line + 2), 0,
     "tetrahedron at (0.75, 0.375, 0.875) of the first grid (in lattice tetrahedron zxy of cell (0, 0, 0), "
     "row E8 of Table 2): only in reference"},
    {"FirstGridHasAnother", [](Records& r) { at<Weight>(r, weight_line).tet[2] = d; }, "first-grid", 0,
     in_file(weight_line), 0,
     "tetrahedron at (0.75, 0.375, 0.125) of the first grid (in lattice tetrahedron xyz of cell (0, 0, 0), "
     "row 1 of Table 2): only in reference"},
    {"FirstGridHasOneTwice", [](Records& r) { r.insert(r.begin() + weight_line, r[weight_line + 1]); },
     "first-grid", 0, in_file(weight_line + 1), in_file(weight_line + 2),
     "tetrahedron at (1.25, 0.625, 0.125) of the first grid (in lattice tetrahedron yxz of cell (1, 0, 0), "
     "row 14 of Table 2): twice in other"},
    {"FirstGridsCount", [](Records& r) { at<FirstGrid>(r, first_grid_line).tets = 5; }, "first-grid", 0,
     in_file(first_grid_line), in_file(first_grid_line),
     "the number of tetrahedra of the first grid is 4 in reference, 5 in other"},
    {"NotAdapted", [](Records& r) { r.erase(r.begin() + first_grid_line, r.begin() + insertion_line); },
     "first-grid", 0, in_file(first_grid_line), 0, "reference is adapted (it has a first_grid record)"},
    {"Distance",  // and its consequences
     [](Records& r) {
       at<FirstGrid>(r, first_grid_line).d1 = 0.8;
       at<Weight>(r, weight_line + 1) = weight(at<Weight>(r, weight_line + 1).tet, 0.55, 0.3);
     },
     "distance", 0, in_file(weight_line + 1), in_file(weight_line + 1),
     "the distance d of the tetrahedron at (1.25, 0.625, 0.125) of the first grid is 0.6 in reference, 0.55 "
     "in other"},
    {"Curvature", [](Records& r) { at<Weight>(r, weight_line).kappa = 2.5; }, "curvature", 0,
     in_file(weight_line), in_file(weight_line),
     "the absolute curvature kappa of the tetrahedron at (0.75, 0.375, 0.125) of the first grid is 2 in "
     "reference, 2.5 in other"},
    {"NoCurvature", [](Records& r) { at<Weight>(r, weight_line).kappa.reset(); }, "curvature", 0,
     in_file(weight_line), in_file(weight_line),
     "the absolute curvature kappa of the tetrahedron at (0.75, 0.375, 0.125) of the first grid is 2 in "
     "reference, none in other"},
    {"LargestCurvature", [](Records& r) { at<FirstGrid>(r, first_grid_line).kappa_max = 2.9; }, "curvature",
     0, in_file(first_grid_line), in_file(first_grid_line),
     "the largest absolute curvature is 3 in reference, 2.9 in other"},
    {"Omega", [](Records& r) { at<Weight>(r, weight_line).omega = 0.4; }, "weight", 0, in_file(weight_line),
     in_file(weight_line),
     "the weight omega of the tetrahedron at (0.75, 0.375, 0.125) of the first grid is 0.5 in reference, 0.4 "
     "in other"},
    {"Volume", [](Records& r) { at<Weight>(r, weight_line).volume = 0.20000001; }, "volume", 0,
     in_file(weight_line), in_file(weight_line),
     "the volume V of the tetrahedron at (0.75, 0.375, 0.125) of the first grid is 0.2 in reference, "
     "0.20000001 in other"},
    {"MeanVolume", [](Records& r) { at<FirstGrid>(r, first_grid_line).mean_volume = 0.26; }, "volume-law", 0,
     in_file(first_grid_line), in_file(first_grid_line),
     "the mean volume is 0.25 in reference, 0.26 in other"},
    {"V0", [](Records& r) { at<FirstGrid>(r, first_grid_line).v0 = 0.06; }, "volume-law", 0,
     in_file(first_grid_line), in_file(first_grid_line), "V_0 is 0.05 in reference, 0.06 in other"},
    {"D1", [](Records& r) { at<FirstGrid>(r, first_grid_line).d1 = 0.8; }, "volume-law", 0,
     in_file(first_grid_line), in_file(first_grid_line), "d_1 is 1 in reference, 0.8 in other"},
    {"Desired", [](Records& r) { at<Weight>(r, weight_line + 3).desired = 0.8; }, "desired", 0,
     in_file(weight_line + 3), in_file(weight_line + 3),
     "the desired volume V(d) of the tetrahedron at (1.25, 0.625, 0.875) of the first grid is 0.9 in "
     "reference, 0.8 in other"},
    {"Error", [](Records& r) { at<Weight>(r, weight_line).error = 0.1; }, "error", 0, in_file(weight_line),
     in_file(weight_line),
     "the error E of the tetrahedron at (0.75, 0.375, 0.125) of the first grid is 0.4 in reference, 0.1 in "
     "other"},
    {"FirstAverage", [](Records& r) { at<FirstGrid>(r, first_grid_line).e_avg = 0.21; }, "average", 0,
     in_file(first_grid_line), in_file(first_grid_line),
     "E_avg of the first grid is 0.2 in reference, 0.21 in other"},
    {"Goal", [](Records& r) { at<FirstGrid>(r, first_grid_line).e_avg_goal = 0.1; }, "average", 0,
     in_file(first_grid_line), in_file(first_grid_line),
     "the E_avg at which the insertion ends is 0 in reference, 0.1 in other", Case::asked},
    {"Choice",
     [](Records& r) {
       at<Insertion>(r, third_insertion_line).tet = {f, g, h, m};
       at<Insertion>(r, third_insertion_line).row = "2b";
       at<Insertion>(r, third_insertion_line).e_avg = 0.171;
     },
     "choice", 3, in_file(third_insertion_line), in_file(third_insertion_line),
     "insertion 3: reference splits the tetrahedron at (0.75, 0.375, 0.875) by row 4c, other the one at "
     "(1.25, 0.625, 0.875) by row 2b; "
     "E'avg 0.17 against 0.171"},
    {"RowOfTable4", [](Records& r) { at<Insertion>(r, second_insertion_line).row = "3a"; }, "table-4", 2,
     in_file(second_insertion_line), in_file(second_insertion_line),
     "insertion 2: both split the tetrahedron at (1.25, 0.625, 0.125), reference by row 3b of Table 4, other "
     "by row 3a"},
    {"OtherEdge",
     [](Records& r) {
       at<Insertion>(r, third_insertion_line).replaced = {0, 2};
     },
     "table-4", 3, in_file(third_insertion_line), in_file(third_insertion_line),
     "insertion 3: both split the tetrahedron at (0.75, 0.375, 0.875) by row 4c of Table 4, but the new "
     "point lies in different simplices"},
    {"NewPoint", [](Records& r) { at<Insertion>(r, third_insertion_line).point.z() = 0.875; }, "point", 3,
     in_file(third_insertion_line), in_file(third_insertion_line),
     "insertion 3: both split the tetrahedron at (0.75, 0.375, 0.875) by row 4c, but the new points are "
     "0.125 apart"},
    {"AverageAfter", [](Records& r) { at<Insertion>(r, third_insertion_line).e_avg = 0.169; },
     "average-after", 3, in_file(third_insertion_line), in_file(third_insertion_line),
     "insertion 3: both split the tetrahedron at (0.75, 0.375, 0.875) by row 4c, but E'avg is 0.17 against "
     "0.169"},
    {"FlipMissing", [](Records& r) { drop(r, flip_line + 1); }, "flips", 2, in_file(flip_line + 1),
     in_file(second_insertion_line),
     "insertion 2, flip 2: reference makes the 3-2 flip at (1.017, 0.5083, 0.125), other makes no further "
     "flip"},
    {"FlipTooMany",
     [](Records& r) {
       r.insert(r.begin() + third_insertion_line + 1, flip(true, {b, c, m}, {p, q}, 0.15));
     },
     "flips", 3, in_file(third_insertion_line), in_file(third_insertion_line + 1),
     "insertion 3, flip 1: other makes the 2-3 flip at (1.017, 0.5083, 0.125), reference makes no further "
     "flip"},
    {"OtherFlip",
     [](Records& r) {
       r[flip_line] = flip(false, {b, c, m}, {a, p}, 0.181);
     },
     "flips", 2, in_file(flip_line), in_file(flip_line),
     "insertion 2, flip 1: reference makes the 2-3 flip at (1.017, 0.5083, 0.125), other makes the 3-2 flip "
     "at (0.75, 0.375, 0.125)"},
    {"AverageAfterFlips", [](Records& r) { at<Flip>(r, flip_line + 1).e_avg = 0.19; }, "average-after", 2,
     in_file(flip_line + 1), in_file(flip_line + 1),
     "insertion 2: after the same flips E_avg is 0.182 against 0.19"},
    {"EndsEarlier",
     [](Records& r) {
       drop(r, fourth_insertion_line);
       at<End>(r, fourth_insertion_line) = {"dilution", 3, 2, 0, 12, 11, 0.17};
     },
     "end", 4, in_file(fourth_insertion_line), in_file(fourth_insertion_line),
     "insertion 4: other ends (dilution), reference splits the tetrahedron at (1.25, 0.625, 0.875) by row "
     "2b"},
    {"SplitsAnotherFirst",  // insertions 3 and 4 exchanged
     [](Records& r) {
       auto &third = at<Insertion>(r, third_insertion_line),
            &fourth = at<Insertion>(r, fourth_insertion_line);
       std::swap(third, fourth);
       std::swap(third.n, fourth.n), std::swap(third.e_avg, fourth.e_avg);
     },
     "choice", 3, in_file(third_insertion_line), in_file(third_insertion_line),
     "insertion 3: reference splits the tetrahedron at (0.75, 0.375, 0.875) by row 4c, other the one at "
     "(1.25, 0.625, 0.875) by row 2b; E'avg 0.17 against 0.17"},
    {"Stopped", [](Records& r) { at<End>(r, end_line).stopped = "stalled"; }, "end", 4, in_file(end_line),
     in_file(end_line),
     "the end: reference ends (no-gain) after 4 insertions and 2 flips, 0 splits refused, with 13 points, 11 "
     "tetrahedra, E_avg 0.16, other ends (stalled) after 4 insertions and 2 flips, 0 splits refused, with 13 "
     "points, 11 tetrahedra, E_avg 0.16"},
    {"SplitsATetrahedronThatIsSplit",
     [](Records& r) {
       at<Insertion>(r, third_insertion_line).tet = {a, b, c, m};
     },
     "choice", 3, 0, in_file(third_insertion_line),
     "insertion 3: there is no tetrahedron at (0, 0, 0) (2, 0, 0) (0, 1, 0) (1, 0.5, 0.5) in the grid that "
     "the trace has built",
     Case::contradicts},
    {"SplitsAtAPointThatIsNone", [](Records& r) { at<Insertion>(r, third_insertion_line).tet[2].z() = 9; },
     "choice", 3, 0, in_file(third_insertion_line),
     "insertion 3: there is no tetrahedron at (0, 0, 1) (2, 0, 1) (0, 1, 9) (1, 0.5, 0.5) in the grid that "
     "the trace has built",
     Case::contradicts},
    {"FlipOfTheOtherKind",
     [](Records& r) {
       r[flip_line] = flip(false, {b, c, m}, {p, q}, 0.181);
     },
     "flips", 2, 0, in_file(flip_line),
     "insertion 2: the 3-2 flip of the face (2, 0, 0) (0, 1, 0) (1, 0.5, 0.5) and the edge (0.75, 0.375, "
     "0.125) (1.33333, 0.666667, 0): its tetrahedra are not in the grid that the trace has built",
     Case::contradicts},
    {"FlipOfAnotherFace",
     [](Records& r) {
       r[flip_line] = flip(true, {b, c, a}, {p, q}, 0.181);
     },
     "flips", 2, 0, in_file(flip_line),
     "insertion 2: the 2-3 flip of the face (2, 0, 0) (0, 1, 0) (0, 0, 0) and the edge (0.75, 0.375, 0.125) "
     "(1.33333, 0.666667, 0): its tetrahedra are not in the grid that the trace has built",
     Case::contradicts},
    {"FlipOfAPointThatIsNone",
     [](Records& r) {
       r[flip_line] = flip(true, {b, c, m}, {p, Point(1, 1, -1)}, 0.181);
     },
     "flips", 2, 0, in_file(flip_line),
     "insertion 2: the 2-3 flip of the face (2, 0, 0) (0, 1, 0) (1, 0.5, 0.5) and the edge (0.75, 0.375, "
     "0.125) (1, 1, -1): its tetrahedra are not in the grid that the trace has built",
     Case::contradicts},
    {"BreaksOff", [](Records& r) { r.resize(fourth_insertion_line); }, "end", 4, 0,
     in_file(fourth_insertion_line) - 1, "the trace breaks off after line 23, without an end record",
     Case::contradicts},
    {"NoEnd", [](Records& r) { r.pop_back(); }, "end", 4, 0, in_file(end_line) - 1,
     "the trace breaks off after line 24, without an end record", Case::contradicts},
};

class Divergences : public ::testing::TestWithParam<Case> {
 protected:
  const TestFiles files;
};

INSTANTIATE_TEST_SUITE_P(All, Divergences, ::testing::ValuesIn(cases),
                         [](const auto& test) { return test.param.name; });

Verdict verdict_of(const Case& test) {
  return test.kind == Case::part ? Verdict::unresolved : Verdict::diverges;
}

TEST_P(Divergences, AreFoundAtTheirStep) {
  Records other = small_trace();
  GetParam().plant(other);
  const verify::TraceComparison result = compare(files, other, small_trace());
  EXPECT_EQ(result.verdict, verdict_of(GetParam()));
  EXPECT_EQ(result.step, GetParam().step);
  EXPECT_EQ(result.insertion, GetParam().insertion);
  EXPECT_EQ(result.what, GetParam().what);
  EXPECT_EQ(result.reference.line, GetParam().reference_line);
  EXPECT_EQ(result.other.line, GetParam().other_line);
  EXPECT_EQ(result.wrong.file, GetParam().kind == Case::contradicts ? files.path("other.jsonl") : "");
  EXPECT_EQ(result.wrong.line, GetParam().kind == Case::contradicts ? GetParam().other_line : 0);
  // The JSON shows the records of these lines.
  for (const auto& [side, records] :
       {std::pair{&result.reference, small_trace()}, std::pair{&result.other, other}})
    if (side->line && !side->record.empty()) {
      EXPECT_EQ(side->record, to_line(records.at(side->line - 1)));
    }
}

// A difference in the reference is found as well, with the two sides exchanged.
TEST_P(Divergences, AreFoundFromTheOtherSide) {
  Records reference = small_trace();
  GetParam().plant(reference);
  if (GetParam().name.ends_with("Twice")) {  // the reference must be in order
    EXPECT_THROW(compare(files, small_trace(), reference), InputError);
    return;
  }
  const verify::TraceComparison result = compare(files, small_trace(), reference);
  EXPECT_EQ(result.verdict, verdict_of(GetParam()));
  EXPECT_EQ(result.step, GetParam().step);
  EXPECT_EQ(result.insertion, GetParam().insertion);
  EXPECT_EQ(result.wrong.file, GetParam().kind == Case::contradicts ? files.path("reference.jsonl") : "");
  EXPECT_EQ(result.wrong.line, GetParam().kind == Case::contradicts ? GetParam().other_line : 0);
}

// Of two differences the one of the earlier step is reported, whatever the order of the records in the files.
TEST(DivergenceOrder, IsThatOfThePaper) {
  const TestFiles files;
  std::vector<std::string> steps;
  for (const verify::TraceStep& step : verify::trace_steps()) steps.push_back(step.name);
  const auto rank = [&](const std::string& step) {
    return std::find(steps.begin(), steps.end(), step) - steps.begin();
  };
  int pairs = 0;
  for (const Case& one : cases)
    for (const Case& two : cases) {
      // Only differences that do not move lines can be planted together.
      const auto changes_in_place = [](const Case& test) {
        Records records = small_trace();
        test.plant(records);
        return records.size() == small_trace().size() && test.step != "end";
      };
      if (!changes_in_place(one) || !changes_in_place(two) || one.insertion > 0 || two.insertion > 0)
        continue;
      Records other = small_trace();
      one.plant(other);
      two.plant(other);
      const verify::TraceComparison result = compare(files, other, small_trace());
      EXPECT_EQ(rank(result.step), std::min(rank(one.step), rank(two.step)))
          << one.name << " and " << two.name;
      ++pairs;
    }
  EXPECT_GT(pairs, 300);
}

TEST(DivergenceOrder, TheFirstOfManyIsToldWithTheirNumber) {
  const TestFiles files;
  Records other = small_trace();
  for (std::size_t i : {weight_line + 3, weight_line + 1, weight_line + 2}) at<Weight>(other, i).d += 0.01;
  std::swap(other[weight_line + 1], other[weight_line + 3]);
  const verify::TraceComparison result = compare(files, other, small_trace());
  EXPECT_EQ(result.step, "distance");
  EXPECT_EQ(result.count, 3);
  EXPECT_EQ(result.reference.line, in_file(weight_line + 1));
  EXPECT_EQ(result.other.line, in_file(weight_line + 3));
}

}  // namespace
}  // namespace tetproof::test
