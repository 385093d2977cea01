// SPDX-License-Identifier: GPL-3.0-or-later
// Where rounding decides, two correct traces may differ and neither is wrong. Elsewhere a difference is still
// one.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

bool says(const verify::TraceComparison& result, const std::string& words) {
  return result.what.find(words) != std::string::npos;
}

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

// New points that are much closer to each other than the tolerance are told apart, also in ties.
TEST(TraceRounding, PointsOfATraceAreKnownByTheirExactCoordinates) {
  const TestFiles files;
  const Point p = (a + b + c + m) / 4, q = p - Point(0, 0, 1e-11), r = q - Point(0, 0, 1e-11);
  const std::vector<Insertion> nested{split({a, b, c, m}, p), split({a, b, c, p}, q), split({a, b, c, q}, r)};
  const Insertion apart = split({b, c, d, m}, (b + c + d + m) / 4);
  const Records first = with_insertions({apart, nested[0], nested[1], nested[2]}),
                last = with_insertions({nested[0], nested[1], nested[2], apart});
  EXPECT_EQ(compare(files, first, first).what, "");
  for (const auto& [other, reference] : {std::pair{&first, &last}, std::pair{&last, &first}}) {
    const verify::TraceComparison result = compare(files, *other, *reference);
    EXPECT_EQ(result.verdict, Verdict::equal) << result.what;
    EXPECT_EQ(result.reordered, 4);
  }
  // The other trace's last digits differ, on both sides of the borders of the tolerance's cells.
  const Point p2 = p + Point(0, 0, 2e-11), q2 = q + Point(0, 0, 2e-11);
  const Records off =
      with_insertions({split({a, b, c, m}, p2), split({a, b, c, p2}, q2), split({a, b, c, q2}, r), apart});
  EXPECT_EQ(compare(files, off, first).verdict, Verdict::equal);
  // A wrong one among them is still found.
  Records wrong = first;
  at<Insertion>(wrong, insertion_line + 3).tet[3] = p;
  at<Insertion>(wrong, insertion_line + 3).point = (a + b + c + p) / 4;
  at<Insertion>(wrong, insertion_line + 3).e_avg = 0.1;  // better, and no sliver
  EXPECT_EQ(compare(files, wrong, first).verdict, Verdict::diverges);
  EXPECT_EQ(compare(files, wrong, first).step, "choice");
  EXPECT_EQ(compare(files, wrong, first).insertion, 4);
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

TEST(TraceRounding, AFlipThatGainsByRounding) {
  const TestFiles files;
  const auto with_flip = [&](double before, double after) {
    Records other = small_trace();
    other.insert(other.begin() + third_insertion_line + 1,
                 Flip{true, {a, b, c}, {m, e}, before, after, 0.17});
    return other;
  };
  for (const auto& [before, after] :
       {std::pair{5e-19, 8e-19}, std::pair{0.1, 0.1}, std::pair{0.1, 0.1 + 1e-14}}) {
    const verify::TraceComparison result = compare(files, with_flip(before, after), small_trace());
    EXPECT_EQ(result.verdict, Verdict::tie);
    EXPECT_EQ(result.step, "flips");
    EXPECT_TRUE(says(result, "is rounding")) << result.what;
    EXPECT_EQ(compare(files, small_trace(), with_flip(before, after)).verdict, Verdict::tie);
  }
  for (const auto& [before, after] :
       {std::pair{0.1, 0.1 + 1e-9}, std::pair{0.1, 0.1 - 1e-9}, std::pair{0.1, 1e-19}})
    EXPECT_EQ(compare(files, with_flip(before, after), small_trace()).verdict, Verdict::diverges) << after;
  // D/A has a unit.
  const auto with_aspect_ratio = [](Records records) {
    at<Settings>(records, settings_line).improve = "aspect-ratio";
    return records;
  };
  const auto verdict = [&](double before, double after) {
    return compare(files, with_aspect_ratio(with_flip(before, after)), with_aspect_ratio(small_trace()))
        .verdict;
  };
  EXPECT_EQ(verdict(0.291667, 0.291667 + 1e-13), Verdict::tie);
  EXPECT_EQ(verdict(0.291667, 0.291667 + 1e-10), Verdict::diverges);
  EXPECT_EQ(verdict(1e6, 1e6 + 1e-7), Verdict::tie);
}

// The flip's new tetrahedra are flat except for the last bits of the coordinates. No solid angle is that
// small.
TEST(TraceRounding, AFlipOfASliver) {
  const TestFiles files;
  const auto with_flip = [&](const Point& end, double before, double after) {
    Records other = small_trace();
    other.insert(other.begin() + third_insertion_line + 1,
                 Flip{true, {a, b, m}, {c, end}, before, after, 0.17});
    return compare(files, other, small_trace());
  };
  EXPECT_EQ(with_flip(d + Point(0, 0, 1e-15), 1e-11, 3e-11).verdict, Verdict::tie);
  EXPECT_TRUE(says(with_flip(d + Point(0, 0, 1e-15), 1e-11, 3e-11), "decided by rounding"));
  EXPECT_EQ(with_flip(d + Point(0, 0, 1e-15), 0.01, 0.02).verdict,
            Verdict::diverges);  // they are not healthy
  EXPECT_EQ(with_flip(d + Point(0, 0, 1e-3), 1e-11, 3e-11).verdict, Verdict::diverges);
  // The D/A of a needle is large, whatever rounding does to it.
  const auto needle = [&](double height) {
    Records other = small_trace(), reference = small_trace();
    for (Records* records : {&other, &reference})
      at<Settings>(*records, settings_line).improve = "aspect-ratio";
    const Point x = m, y = m + Point(1e-5, 0, 0), z = m + Point(1e-6, 1e-7, 0),
                u = m + Point(2e-6, 3e-8, height), w = m + Point(3e-6, 4e-8, -height);
    other.insert(other.begin() + third_insertion_line + 1, Flip{true, {x, y, z}, {u, w}, 1166, 1221, 0.17});
    return compare(files, other, reference).verdict;
  };
  EXPECT_EQ(needle(1e-15), Verdict::tie);
  EXPECT_EQ(needle(1e-7), Verdict::diverges);
}

// The tolerance of section 4 lies within rounding of the smallest solid angle after the split.
TEST(TraceRounding, WhetherFlipsAreAskedFor) {
  const TestFiles files;
  const auto verdict = [&](double below) {
    Records other = small_trace();
    other.insert(other.begin() + insertion_line + 1, Flip{true, {a, b, c}, {m, e}, 0.01, 0.02, 0.19});
    Records reference = small_trace();
    for (Records* records : {&other, &reference}) {
      at<Settings>(*records, settings_line).improve_below = below;
      at<Insertion>(*records, insertion_line) = {
          1,
          {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)},
          "2b",
          {0, 1},
          Point(0.5, 0, 0),
          0.19};
    }
    return compare(files, other, reference).verdict;
  };
  // The halved corner of a cube with edges 1. The smallest angle is at (0,1,0) of the half with (1,0,0),
  // whose edges there are u = (1/2,-1,0), v = (1,-1,0), w = (0,-1,1) with u.v = 3/2, v.w = u.w = 1 and six
  // volumes of 1/2: tan(Omega/2) = (1/2) / (|u||v||w| + u.v |w| + v.w |u| + u.w |v|).
  const double u = std::sqrt(1.25), v = std::sqrt(2.0), w = v;
  const double smallest = 2 * std::atan(0.5 / (u * v * w + 1.5 * w + 1 * u + 1 * v)) / (4 * std::numbers::pi);
  EXPECT_EQ(verdict(smallest), Verdict::tie);
  EXPECT_EQ(verdict(smallest + 1e-9), Verdict::diverges);
  EXPECT_EQ(verdict(smallest - 1e-9), Verdict::diverges);
}

TEST(TraceRounding, ASplitIntoSliversMayBeRefused) {
  const TestFiles files;
  const auto result = [&](double height) {
    Records reference = small_trace(), other = small_trace();
    // The reference splits a tetrahedron over c, d, g of height `height`, which is the best choice. The other
    // splits the next best.
    const Point top = (c + d + g) / 3 + Point(0, -height, 0);
    at<Insertion>(reference, third_insertion_line) = {
        3, {c, d, g, top}, "0", {0, 1, 2, 3}, (c + d + g + top) / 4, 0.17};
    at<Insertion>(other, third_insertion_line).e_avg = 0.171;
    return compare(files, other, reference);
  };
  EXPECT_EQ(result(1e-13).verdict, Verdict::tie);
  EXPECT_EQ(result(1e-13).step, "choice");
  EXPECT_EQ(result(1e-13).insertion, 3);
  EXPECT_TRUE(says(result(1e-13), "decided by rounding")) << result(1e-13).what;
  EXPECT_EQ(result(1e-3).verdict, Verdict::diverges);
  // The slivers of the worse split are no excuse for choosing it.
  Records reference = small_trace(), other = small_trace();
  const Point top = (c + d + g) / 3 + Point(0, -1e-13, 0);
  at<Insertion>(other, third_insertion_line) = {
      3, {c, d, g, top}, "0", {0, 1, 2, 3}, (c + d + g + top) / 4, 0.171};
  EXPECT_EQ(compare(files, other, reference).verdict, Verdict::diverges);
}

TEST(TraceRounding, EquallyLongEdgesOfTable4) {
  const TestFiles files;
  const auto verdict = [&](const Point& apex) {  // its edges to a and b
    Records reference = small_trace();
    at<Insertion>(reference, third_insertion_line) = {3, {a, b, g, apex}, "4d", {0, 3}, (a + apex) / 2, 0.17};
    Records other = reference;
    at<Insertion>(other, third_insertion_line) = {3, {a, b, g, apex}, "4d", {1, 3}, (b + apex) / 2, 0.17};
    const verify::TraceComparison result = compare(files, other, reference);
    EXPECT_EQ(result.step, "table-4");
    return result.verdict;
  };
  EXPECT_EQ(verdict(m), Verdict::tie);
  EXPECT_EQ(verdict(m + Point(1e-15, 0, 0)), Verdict::tie);
  EXPECT_EQ(verdict(m + Point(1e-6, 0, 0)), Verdict::diverges);
}

TEST(TraceRounding, TheLastGain) {
  const TestFiles files;
  const auto verdict = [&](double gain, const std::string& stopped) {
    Records other = small_trace(), reference = small_trace();
    at<Insertion>(reference, fourth_insertion_line).e_avg = 0.17 - gain;
    other.erase(other.begin() + fourth_insertion_line);
    at<End>(other, fourth_insertion_line) = {stopped, 3, 2, 0, 12, 11, 0.17};
    const verify::TraceComparison result = compare(files, other, reference);
    EXPECT_EQ(result.step, "end");
    EXPECT_EQ(result.insertion, 4);
    EXPECT_EQ(compare(files, reference, other).verdict, result.verdict);
    return result.verdict;
  };
  EXPECT_EQ(verdict(1e-16, "no-gain"), Verdict::tie);
  EXPECT_EQ(verdict(1e-11, "no-gain"), Verdict::diverges);
  EXPECT_EQ(verdict(1e-16, "points"), Verdict::diverges);
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
  EXPECT_EQ(result.verdict, Verdict::tie);
  EXPECT_EQ(result.step, "weight");
  EXPECT_EQ(compare(files, flat(6e-3, 0.1), flat(6e-3, 1)).verdict, Verdict::diverges);
  EXPECT_EQ(compare(files, flat(6e-3, 0.1), flat(3e-3, 0.1)).step, "curvature");
}

TEST(TraceRounding, AVertexAsCloseToTwoPointsOfTheSurface) {
  const TestFiles files;
  Records other = small_trace();  // vertex (1, 1, 0) lies at (1, 1, 0), the reference moves it up by 0.01
  at<Moved>(other, moved_line).point = Point(1.01, 1, 0);
  const verify::TraceComparison result = compare(files, other, small_trace());
  EXPECT_EQ(result.verdict, Verdict::tie);
  EXPECT_EQ(result.step, "moved");
  EXPECT_TRUE(says(result, "both as close to it; decided by rounding")) << result.what;
  EXPECT_EQ(verify::comparison_text(result).find("--follow"), std::string::npos);
  at<Moved>(other, moved_line).point = Point(1.02, 1, 0);
  EXPECT_EQ(compare(files, other, small_trace()).verdict, Verdict::diverges);
}

TEST(TraceRounding, IndicatorsOfMendedVertices) {
  const TestFiles files;
  Records reference = small_trace(), other = small_trace();
  at<Moved>(reference, moved_line).mended = at<Moved>(other, moved_line).mended = true;
  at<Indicators>(other, indicators_line + 1).initial = "-++";  // was 0 in the middle
  EXPECT_EQ(compare(files, other, reference).what, "");
  // An earlier difference counts first: another vertex after Table 3.
  at<Indicators>(other, indicators_line + 2).after = "-++";
  other.erase(other.begin() + moved_line);
  verify::TraceComparison result = compare(files, other, reference);
  EXPECT_EQ(result.verdict, Verdict::diverges);
  EXPECT_EQ(result.step, "table-3");
  EXPECT_TRUE(says(result, "lattice vertex (1, 0, 1)")) << result.what;
  // A vertex is mended in one trace only: first where no thin tetrahedron is the reason, then beside a cut.
  at<Indicators>(other, indicators_line + 2).after = "--+";
  result = compare(files, other, reference);
  EXPECT_EQ(result.verdict, Verdict::diverges);
  EXPECT_EQ(result.step, "moved");
  at<Cut>(other, cut_line - 1) =
      at<Cut>(reference, cut_line) = {{{{1, 1, 0}, {1, 1, 1}}}, Point(1, 1, 1e-16)};
  EXPECT_EQ(compare(files, other, reference).verdict, Verdict::tie);
  EXPECT_EQ(compare(files, reference, other).verdict, Verdict::tie);
}

// Without a tolerance, the last bit of the lattice decides which vertices are exactly on the surface.
TEST(TraceRounding, ExactZeros) {
  const TestFiles files;
  Records reference = small_trace(), other = small_trace();
  at<Indicators>(other, indicators_line + 1).initial = "-++";  // 0 in the reference
  for (Records* records : {&reference, &other})
    at<Cut>(*records, cut_line) = {{{{0, 1, 0}, {1, 1, 0}}}, Point(1 - 1e-16, 1, 0)};
  EXPECT_EQ(compare(files, other, reference).verdict, Verdict::diverges);
  for (Records* records : {&reference, &other}) at<Settings>(*records, settings_line).on_surface = 0;
  EXPECT_EQ(compare(files, other, reference).verdict, Verdict::tie);
  EXPECT_EQ(compare(files, reference, other).verdict, Verdict::tie);
  EXPECT_EQ(compare(files, other, reference).step, "indicators");
  for (Records* records : {&reference, &other}) at<Cut>(*records, cut_line).point.x() = 0.9;
  EXPECT_EQ(compare(files, other, reference).verdict, Verdict::diverges);
}

}  // namespace
}  // namespace tetproof::test
