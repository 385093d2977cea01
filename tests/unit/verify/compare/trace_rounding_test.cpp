// SPDX-License-Identifier: GPL-3.0-or-later
// Rounding: points that are closer than the tolerance, V(d) where it is steep, the qualities of flips, and
// differences of which the comparison says that rounding may decide them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/unit/verify/compare/traces.hpp"

namespace tetproof::test {
namespace {

using namespace trace;
using Verdict = verify::TraceComparison::Verdict;
using Records = std::vector<Record>;

bool says(const verify::TraceComparison& result, const std::string& words) {
  return result.what.find(words) != std::string::npos;
}

const std::string may_decide = "; rounding may decide that";

// The handmade trace up to its first insertion, followed by these insertions, with the same E_avg at the same
// position.
Records with_insertions(const std::vector<Insertion>& insertions) {
  Records records = small_trace();
  records.resize(insertion_line);
  double e_avg = 0.2;
  std::int64_t n = 0;
  for (Insertion insertion : insertions) {
    insertion.n = ++n;
    insertion.e_avg = e_avg *= 0.9;
    records.push_back(insertion);
  }
  records.push_back(End{"points", n, 0, 0, 20, 20, e_avg});
  return records;
}

Insertion split(const Tet& tet, const Point& point) {
  return {1, tet, "1", {0, 1, 2, 3}, point, 0};
}

// New points that are much closer to each other than the tolerance are told apart.
TEST(TraceRounding, PointsOfATraceAreKnownByTheirExactCoordinates) {
  const TestFiles files;
  const Point x = p, y = x - Point(0, 0, 1e-11), z = y - Point(0, 0, 1e-11);
  const Insertion apart = split({b, c, d, m}, (b + c + d + m) / 4);
  const Records reference =
      with_insertions({apart, split({a, b, c, m}, x), split({a, b, c, x}, y), split({a, b, c, y}, z)});
  EXPECT_EQ(compare(files, reference, reference).what, "");
  // The other trace's last digits differ, on both sides of the borders of the tolerance's cells.
  const Point x2 = x + Point(0, 0, 2e-11), y2 = y + Point(0, 0, 2e-11);
  const Records off =
      with_insertions({apart, split({a, b, c, m}, x2), split({a, b, c, x2}, y2), split({a, b, c, y2}, z)});
  EXPECT_EQ(compare(files, off, reference).what, "");
  // A wrong one among them is still found: this tetrahedron has been split.
  Records wrong = reference;
  at<Insertion>(wrong, insertion_line + 3).tet[3] = x;
  const verify::TraceComparison result = compare(files, wrong, reference);
  EXPECT_EQ(result.verdict, Verdict::diverges);
  EXPECT_EQ(result.step, "choice");
  EXPECT_EQ(result.insertion, 4);
  EXPECT_EQ(result.wrong.file, files.path("other.jsonl"));
}

TEST(TraceRounding, AnyNumberOfInsertionsCrowdsTogether) {
  const TestFiles files;
  std::vector<Insertion> insertions;
  Tet tet{a, b, c, m};
  for (int i = 0; i < 1500; ++i) {
    const Point p = m - Point(0, 0, (i + 1) * 1e-12);
    insertions.push_back(split(tet, p));
    tet[3] = p;
  }
  const Records records = with_insertions(insertions);
  EXPECT_EQ(compare(files, records, records).what, "");
}

// D/A: the smallest height over the area below it.
double aspect_ratio(const Tet& tet) {
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 4; ++i) {
    const Point normal = (tet[(i + 2) % 4] - tet[(i + 1) % 4]).cross(tet[(i + 3) % 4] - tet[(i + 1) % 4]);
    const double height = std::abs(normal.normalized().dot(tet[i] - tet[(i + 1) % 4]));
    smallest = std::min(smallest, height / (normal.norm() / 2));
  }
  return smallest;
}

// The qualities of flips are computed again, for each trace from its own points.
TEST(TraceRounding, QualitiesOfFlips) {
  const TestFiles files;
  const auto with = [](const std::string& improve, double before, double after) {
    Records records = small_trace();
    at<Settings>(records, settings_line).improve = improve;
    for (const std::size_t line : {flip_line + 0, flip_line + 1})
      if (auto& its = at<Flip>(records, line); improve == "aspect-ratio")
        its = flip(its.two_to_three, its.face, its.edge, its.e_avg, aspect_ratio);
    at<Flip>(records, flip_line).quality_before *= before;
    at<Flip>(records, flip_line).quality_after *= after;
    return records;
  };
  for (const std::string improve : {"solid-angle", "aspect-ratio"}) {
    const Records right = with(improve, 1, 1);
    EXPECT_EQ(compare(files, right, right).what, "");
    EXPECT_EQ(compare(files, with(improve, 1 + 1e-12, 1 - 1e-12), right).what, "");
    for (const auto& [before, after, when] :
         {std::tuple{1 + 1e-6, 1.0, "before"}, std::tuple{1.0, 1 - 1e-6, "after"},
          std::tuple{-1.0, 1.0, "before"}, std::tuple{1.0, 0.0, "after"}})
      for (const bool in_other : {true, false}) {
        const Records wrong = with(improve, before, after);
        const verify::TraceComparison result =
            in_other ? compare(files, wrong, right) : compare(files, right, wrong);
        EXPECT_EQ(result.verdict, Verdict::diverges);
        EXPECT_EQ(result.step, "flips");
        EXPECT_EQ(result.insertion, 2);
        EXPECT_EQ(result.wrong.file, files.path(in_other ? "other.jsonl" : "reference.jsonl"));
        EXPECT_EQ(result.wrong.line, in_file(flip_line));
        EXPECT_TRUE(says(result, std::string("the smallest quality ") + when + " it is ")) << result.what;
      }
    // The measure is the one that the settings name.
    Records other_measure = right;
    at<Settings>(other_measure, settings_line).improve =
        improve == "solid-angle" ? "aspect-ratio" : "solid-angle";
    EXPECT_EQ(compare(files, other_measure, other_measure).step, "flips");
  }
}

// V(d) is steep where d is only rounding: two traces may differ there by far more than the tolerance.
TEST(TraceRounding, DesiredVolumesWhereTheyAreSteep) {
  const TestFiles files;
  const auto with = [](double d, double factor) {  // beside a vertex of the surface
    Records records = small_trace();
    at<Settings>(records, settings_line).p = 0.25;
    const auto& law = at<FirstGrid>(records, first_grid_line);
    auto& weight = at<Weight>(records, weight_line);
    const double t = std::pow(weight.omega * d / law.d1, 0.25);
    weight.d = d;
    weight.desired = ((1 - t) * law.v0 + t * law.v1) * factor;
    weight.error = std::abs(weight.volume - weight.desired);
    return records;
  };
  EXPECT_EQ(compare(files, with(2.2e-16, 1), with(1.1e-16, 1)).what, "");
  EXPECT_EQ(compare(files, with(0, 1), with(1.1e-16, 1)).what, "");
  EXPECT_EQ(compare(files, with(1.1e-16, 1.2), with(1.1e-16, 1)).step, "desired");
  // Farther away it is not steep.
  EXPECT_EQ(compare(files, with(0.5, 1), with(0.5, 1)).what, "");
  EXPECT_EQ(compare(files, with(0.5, 1 + 1e-7), with(0.5, 1)).step, "desired");
}

TEST(TraceRounding, CurvaturesOfAFlatSurface) {
  const TestFiles files;
  const auto flat = [](double scale, double omega) {
    Records records = small_trace();
    at<FirstGrid>(records, first_grid_line).kappa_min = scale / 2;
    at<FirstGrid>(records, first_grid_line).kappa_max = scale;
    for (int i = 0; i < 4; ++i) {
      at<Weight>(records, weight_line + i).kappa = scale;
      at<Weight>(records, weight_line + i).omega = omega;
    }
    return records;
  };
  EXPECT_EQ(compare(files, flat(6e-16, 0.5), flat(3e-16, 0.5)).what, "");
  const verify::TraceComparison result = compare(files, flat(6e-16, 0.1), flat(3e-16, 1));
  EXPECT_EQ(result.verdict, Verdict::unresolved);
  EXPECT_EQ(result.step, "weight");
  EXPECT_TRUE(says(result, may_decide)) << result.what;
  EXPECT_FALSE(says(compare(files, flat(6e-3, 0.1), flat(6e-3, 1)), may_decide));
  EXPECT_EQ(compare(files, flat(6e-3, 0.1), flat(3e-3, 0.1)).step, "curvature");
}

TEST(TraceRounding, AVertexAsCloseToTwoPointsOfTheSurface) {
  const TestFiles files;
  Records other = small_trace();  // vertex (1, 1, 0) lies at (1, 1, 0), the reference moves it up by 0.01
  at<Moved>(other, moved_line).point = Point(1.01, 1, 0);
  const verify::TraceComparison result = compare(files, other, small_trace());
  EXPECT_EQ(result.verdict, Verdict::unresolved);
  EXPECT_EQ(result.step, "moved");
  EXPECT_TRUE(says(result, "both as close to it; rounding may decide that")) << result.what;
  at<Moved>(other, moved_line).point = Point(1.02, 1, 0);
  EXPECT_FALSE(says(compare(files, other, small_trace()), may_decide));
}

TEST(TraceRounding, IndicatorsOfMendedVertices) {
  const TestFiles files;
  Records reference = small_trace(), other = small_trace();
  at<Moved>(reference, moved_line).mended = at<Moved>(other, moved_line).mended = true;
  EXPECT_EQ(compare(files, other, reference).what, "");
  at<Indicators>(other, indicators_line + 1).initial = "-++";  // was 0 in the middle
  EXPECT_EQ(compare(files, other, reference).step, "indicators");
  // If only one trace has mended the vertex, that is the difference and not the indicators. An earlier
  // difference counts first: another vertex after Table 3.
  at<Indicators>(other, indicators_line + 2).after = "-++";
  other.erase(other.begin() + moved_line);
  verify::TraceComparison result = compare(files, other, reference);
  EXPECT_EQ(result.verdict, Verdict::unresolved);
  EXPECT_EQ(result.step, "table-3");
  EXPECT_TRUE(says(result, "lattice vertex (1, 0, 1)")) << result.what;
  // A vertex is mended in one trace only: first where no thin tetrahedron is the reason, then beside a cut.
  at<Indicators>(other, indicators_line + 2).after = "--+";
  result = compare(files, other, reference);
  EXPECT_EQ(result.step, "moved");
  EXPECT_FALSE(says(result, may_decide)) << result.what;
  at<Cut>(other, cut_line - 1) =
      at<Cut>(reference, cut_line) = {{{{1, 1, 0}, {1, 1, 1}}}, Point(1, 1, 1e-16)};
  EXPECT_TRUE(says(compare(files, other, reference), may_decide));
  EXPECT_TRUE(says(compare(files, reference, other), may_decide));
  // A vertex that both have moved, but only one has mended.
  other = reference;
  at<Moved>(other, moved_line).mended = false;
  result = compare(files, other, reference);
  EXPECT_EQ(result.step, "moved");
  EXPECT_EQ(
      result.what,
      "lattice vertex (1, 1, 0) is moved to the surface in both, but only in reference because of rounding" +
          may_decide);
}

// Without a tolerance, the last bit of the lattice decides which vertices are exactly on the surface.
TEST(TraceRounding, ExactZeros) {
  const TestFiles files;
  Records reference = small_trace(), other = small_trace();
  at<Indicators>(other, indicators_line + 1).initial = "-++";  // 0 in the reference
  for (Records* records : {&reference, &other})
    at<Cut>(*records, cut_line) = {{{{0, 1, 0}, {1, 1, 0}}}, Point(1 - 1e-16, 1, 0)};
  EXPECT_FALSE(says(compare(files, other, reference), may_decide));
  for (Records* records : {&reference, &other}) at<Settings>(*records, settings_line).on_surface = 0;
  EXPECT_TRUE(says(compare(files, other, reference), may_decide));
  EXPECT_TRUE(says(compare(files, reference, other), may_decide));
  EXPECT_EQ(compare(files, other, reference).step, "indicators");
  for (Records* records : {&reference, &other}) at<Cut>(*records, cut_line).point.x() = 0.9;
  EXPECT_FALSE(says(compare(files, other, reference), may_decide));
}

}  // namespace
}  // namespace tetproof::test
