// SPDX-License-Identifier: GPL-3.0-or-later
// Two implementations that share no code, on 100 random surfaces: the same steps (i) to (v), and every
// decision of step (vi) of the one admissible to the other.
#include <gtest/gtest.h>

#include <map>

#include "corpus/random_surface.hpp"
#include "tests/second/testimony.hpp"
#include "verify/verify.hpp"

namespace tetproof::second {
namespace {

// All combinations come up within a few hundred seeds.
Settings settings_for(std::uint64_t seed) {
  const auto pick = [&](int divisor, int choices) { return static_cast<int>(seed / divisor % choices); };
  Settings s;
  s.cells = {4 + pick(1, 4), 0, 0};
  s.outside = pick(1, 3) == 0;
  s.shortest_diagonals = pick(2, 2);
  s.on_surface = pick(1, 4) == 1 ? 0.15 : 1e-6;
  s.p = std::array{1.0, 0.25, 3.0}[pick(3, 3)];
  s.v0 = std::array{0.2, 0.1, 0.05, 2.0}[pick(1, 4)];
  s.v1 = std::array{2.0, 1.0, 0.5}[pick(2, 3)];
  s.curvature = pick(1, 5) < 2;
  s.improve = std::array{Quality::solid_angle, Quality::aspect_ratio, Quality::none}[pick(4, 3)];
  s.improve_below = pick(1, 2) ? 0.02 : 0.002;
  s.insertions = 400;
  if (pick(1, 6) == 5) {
    s.insertions = 100;
    s.past_dilution = true;
  }
  return s;
}

TEST(SecondImplementation, IsAdmissibleOnAHundredRandomSurfaces) {
  int surfaces = 0, equal = 0, mended = 0;
  std::int64_t insertions = 0, flips = 0, refused = 0;
  std::map<std::string, int> rows, stops;
  for (std::uint64_t seed = 1; surfaces < 100; ++seed) {
    const TriangleSurface surface = corpus::random_closed_surface(seed);
    if (surface.triangles.size() > 250) continue;  // for time
    const Settings settings = settings_for(seed);
    const Testimony t = testify(surface, settings);
    if (!t.followed) continue;  // thinner than the lattice everywhere: the grid is empty
    ++surfaces;
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + corpus::describe_random_surface(seed));
    EXPECT_NE(t.comparison.verdict, verify::TraceComparison::Verdict::diverges)
        << verify::comparison_text(t.comparison);
    EXPECT_TRUE(t.follow.admissible) << "line " << t.follow.line << ": " << t.follow.what;
    EXPECT_EQ(verify::verify(t.second.grid).certificate, true);

    equal += t.comparison.verdict == verify::TraceComparison::Verdict::equal;
    mended += t.second.mended;
    const auto& end = std::get<trace::End>(t.second.records.back());
    insertions += end.insertions;
    flips += end.flips;
    refused += end.refused;
    ++stops[end.stopped];
    for (const trace::Record& record : t.second.records)
      if (const auto* insertion = std::get_if<trace::Insertion>(&record)) ++rows[insertion->row];
  }
  // What they say is worth something only if everything came up in them.
  std::cout << equal << " equal, the others but for ties; " << insertions << " insertions, " << flips
            << " flips, " << refused << " refused splits, " << mended << " mended;";
  for (const auto& [row, times] : rows) std::cout << " " << row << ":" << times;
  for (const auto& [why, times] : stops) std::cout << " " << why << ":" << times;
  std::cout << "\n";
  EXPECT_GE(equal, 50);
  EXPECT_GE(insertions, 5000);
  EXPECT_GE(flips, 1000);
  for (const char* row : {"0", "1", "2a", "3a", "3b", "4a", "4b", "4c", "4d"}) EXPECT_GT(rows[row], 0) << row;
  for (const char* why : {"no-gain", "dilution", "points"}) EXPECT_GT(stops[why], 0) << why;
}

}  // namespace
}  // namespace tetproof::second
