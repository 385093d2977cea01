// SPDX-License-Identifier: GPL-3.0-or-later
// Mistakes that implementers make, planted in the page: the comparison of its trace with the fast engine's
// names the step, the place and what differs, and the replay stops at the same insertion.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "corpus/random_surface.hpp"
#include "corpus/surfaces.hpp"
#include "tests/mistakes/testimony.hpp"

namespace tetproof::mistakes {
namespace {

using reference::AdaptOptions;
using reference::Options;
using reference::Region;

struct Case {
  Mistake mistake;
  std::string surface;  // a specification, or the seed of a random surface
  void (*set)(Options&);
  const char* kind;      // the kind of the first record that differs from the record of the right page
  const char* step;      // as tetproof-compare names it
  const char* compared;  // words of what tetproof-compare says
  const char* followed;  // words of what --follow says
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << "on " << c.surface;
}

void none(Options&) {}

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {Mistake::table2_row, "9", none, "first_grid", "first-grid",
       "of the first grid (in lattice tetrahedron xyz of cell (0, 1, 0), row 12f of Table 2): only in",
       "is not in it"},
      {Mistake::higher_diagonal, "9", none, "rows", "table-2",
       "is cut by row 12f of Table 2 in reference, by row 12b in other",
       "are 12f 12f 12f 12f 12f 12f, not 12b"},
      {Mistake::table3_interior_end, "6", none, "cut", "cut",
       "of several, the one closest to the exterior end", "the cut of the lattice edge"},
      {Mistake::asked_for_both, "terrain:m=2,seed=4",
       [](Options& s) {
         s.on_surface = 0;
         s.box_scale = 2;
         s.cells = {7, 8, 4};
       },
       "indicators", "table-3", "after Table 3", "after Table 3 are"},
      {Mistake::case5_kept, "groove:m=4,width=1,depth=1",
       [](Options& s) {
         s.box_scale = 2;
         s.cells = {8, 8, 8};
         s.adapt->points = 20;  // the first tie comes later
       },
       "rows", "table-2", "is cut by row 5- of Table 2 in reference, by row 5 in other",
       "are 5- 5- 5- 5- 5- 5-, not 5 5"},
      {Mistake::distance_to_triangles, "9", none, "first_grid", "distance",
       "the distance d of the tetrahedron", "d1 is "},
      {Mistake::volumes_exchanged, "9", none, "first_grid", "desired",
       "the desired volume V(d) of the tetrahedron", "V(d) of all tetrahedra is eq. (3.1) with other V0"},
      {Mistake::signed_error, "9", none, "first_grid", "error", "the error E of the tetrahedron",
       "E, eq. (3.3), of the tetrahedron"},
      {Mistake::signed_curvature, "9", [](Options& s) { s.adapt->curvature = true; }, "first_grid",
       "curvature", "absolute curvature", "the smallest absolute curvature (D15) is"},
      {Mistake::inverted_curvature_weight, "9", [](Options& s) { s.adapt->curvature = true; }, "first_grid",
       "weight", "the weight omega of the tetrahedron", "omega, eq. (3.6), of the tetrahedron"},
      {Mistake::four_pieces, "9", none, "insertion", "choice", "reference splits the tetrahedron at",
       "the method splits the tetrahedron at"},
      {Mistake::row_3b_as_3a, "9", none, "insertion", "choice", "by row 3a; E'avg",
       "is row 3b of Table 4, not 3a"},
      {Mistake::row_4c_on_face, "21", [](Options& s) { s.on_surface = 0.15; }, "insertion", "choice",
       "by row 4c; E'avg", "row 4c of Table 4 puts the point of the tetrahedron"},
      {Mistake::forgotten_surface_point, "23", none, "insertion", "table-4",
       "reference by row 3a of Table 4, other by row 2a", "is row 3a of Table 4, not 2a"},
      {Mistake::skewed_centroid, "9", none, "insertion", "choice", "reference splits the tetrahedron at",
       "the method splits the tetrahedron at"},
      {Mistake::dilution_ignored, "9",
       [](Options& s) {
         s.cells = {5, 2, 2};
         s.adapt->v0.value = 0.02;
       },
       "insertion", "end", "reference ends (dilution)", "the method has stopped: dilution"},
      {Mistake::worst_flip, "9", none, "flip", "flips", "flip", "the method makes"},
      {Mistake::flips_everywhere, "55",
       [](Options& s) {
         s.cells = {7, 3, 3};  // a small grid: all its pairs and triples of tetrahedra are asked
         s.adapt->points = 10;
       },
       "flip", "flips", "reference makes no further flip",
       "is not one of a strictly convex hexahedron within O_i"},
      {Mistake::tetrahedron_without_neighbours, "9", none, "flip", "flips", "other makes no further flip",
       "the method still makes the"}};
  return all;
}

std::string kind(const trace::Record& record) {
  return trace::name_of(record);
}

class PlantedMistake : public testing::TestWithParam<Case> {};

TEST_P(PlantedMistake, IsLocated) {
  const Case& c = GetParam();
  const bool random = c.surface.find_first_not_of("0123456789") == std::string::npos;
  const TriangleSurface surface =
      random ? corpus::random_closed_surface(std::stoull(c.surface)) : corpus::make_surface(c.surface);
  Options options{.cells = {random ? 4 + std::stoi(c.surface) % 4 : 0, 0, 0},
                  .parametric = false,
                  .adapt = AdaptOptions{.points = 300, .v0 = {0.1}, .v1 = {1}, .improve_below = 0.01}};
  if (c.surface == "9" || c.surface == "21") options.region = Region::outside;
  c.set(options);

  // Without the mistake the two agree, so that what they disagree on is the mistake.
  const Testimony right = testify(surface, options, Mistake::none);
  ASSERT_EQ(right.comparison.verdict, verify::TraceComparison::Verdict::equal)
      << verify::comparison_text(right.comparison);
  ASSERT_TRUE(right.follow.admissible) << right.follow.what;
  const Testimony wrong = testify(surface, options, c.mistake);

  const auto &of_right = right.mistaken, &of_wrong = wrong.mistaken;
  std::size_t first = 0;
  while (first < of_right.size() && first < of_wrong.size() &&
         trace::to_line(of_right[first]) == trace::to_line(of_wrong[first]))
    ++first;
  ASSERT_TRUE(first < of_wrong.size() && first < of_right.size()) << "the mistake makes no difference here";
  const bool flip = kind(of_right[first]) == "flip" || kind(of_wrong[first]) == "flip";
  EXPECT_EQ(flip ? "flip" : kind(of_wrong[first]), c.kind);

  const verify::TraceComparison& compared = wrong.comparison;
  SCOPED_TRACE(verify::comparison_text(compared));
  SCOPED_TRACE(wrong.follow.what);
  EXPECT_EQ(compared.verdict, verify::TraceComparison::Verdict::diverges);
  EXPECT_EQ(compared.step, c.step);
  EXPECT_NE(compared.what.find(c.compared), std::string::npos);
  EXPECT_FALSE(wrong.follow.admissible);
  EXPECT_NE(wrong.follow.what.find(c.followed), std::string::npos);
  const std::int64_t line = static_cast<std::int64_t>(first) + 1;
  if (c.kind != std::string("insertion") && !flip) return;
  // Step (vi) is one decision after the other, so the line must be exactly that one. (For a missing flip, the
  // comparison has only the line of the right side.)
  EXPECT_EQ(kind(of_wrong[first]) == "flip" || !flip ? compared.other.line : compared.reference.line, line);
  EXPECT_EQ(wrong.follow.line, line);
  std::int64_t insertions = flip ? 0 : 1;
  for (std::size_t i = 0; i < first; ++i) insertions += kind(of_right[i]) == "insertion";
  EXPECT_EQ(compared.insertion, insertions);
}

std::string name_of(const testing::TestParamInfo<Case>& tested) {
  for (const NamedMistake& m : mistakes())
    if (m.mistake == tested.param.mistake) {
      std::string name = m.name;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    }
  return "none";
}

INSTANTIATE_TEST_SUITE_P(All, PlantedMistake, testing::ValuesIn(cases()), name_of);

TEST(PlantedMistakes, AreAllTested) {
  std::set<Mistake> tested;
  for (const Case& c : cases()) tested.insert(c.mistake);
  for (const NamedMistake& m : mistakes()) EXPECT_EQ(tested.count(m.mistake), 1u) << m.name;
}

}  // namespace
}  // namespace tetproof::mistakes
