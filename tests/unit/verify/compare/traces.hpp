// SPDX-License-Identifier: GPL-3.0-or-later
// A small handmade trace in which tests plant differences: a box of two cells, four tetrahedra, four
// insertions, two flips.
#pragma once

#include <string>
#include <vector>

#include "io/trace.hpp"
#include "tests/support/test_files.hpp"
#include "verify/compare_traces.hpp"

namespace tetproof::test {

using trace::Point;
using trace::Record;
using trace::Tet;

// Corners of the box (0,0,0)-(2,1,1), and its centre.
inline const Point a(0, 0, 0), b(2, 0, 0), c(0, 1, 0), d(2, 1, 0), e(0, 0, 1), f(2, 0, 1), g(0, 1, 1),
    h(2, 1, 1), m(1, 0.5, 0.5);

inline trace::Weight weight(const Tet& tet, double distance, double volume) {
  trace::Weight w;
  w.tet = tet;
  w.d = distance;
  w.omega = 0.5;
  w.kappa = 2;
  w.volume = volume;
  w.desired = 0.1 + distance;
  w.error = std::abs(volume - w.desired);
  return w;
}

/// Positions of the trace's lines, for the tests that change them.
enum Line : std::size_t {
  settings_line,
  lattice_line,
  indicators_line,
  moved_line = indicators_line + 4,
  cut_line,
  rows_line = cut_line + 2,
  mapped_line = rows_line + 2,
  first_grid_line = mapped_line + 2,
  weight_line,
  insertion_line = weight_line + 4,  // 1
  second_insertion_line,             // 2, with two flips
  flip_line,
  third_insertion_line = flip_line + 2,
  fourth_insertion_line,
  end_line,
  lines
};

inline std::vector<Record> small_trace() {
  using namespace trace;
  return {
      Settings{.program = "by hand", .curvature = true, .improve = "solid-angle"},
      Lattice{{a, h}, {2, 1, 1}},
      Indicators{0, 0, "-++", "-++"},
      Indicators{1, 0, "-0+", "-++"},
      Indicators{0, 1, "--+", "--+"},
      Indicators{1, 1, "-++", "-++"},
      Moved{{1, 1, 0}, Point(1, 1, 0.01)},
      Cut{{{{0, 0, 0}, {1, 0, 0}}}, Point(0.5, 0, 0)},
      Cut{{{{0, 1, 1}, {1, 1, 1}}}, Point(0.25, 1, 1)},
      Rows{{0, 0, 0}, {"1", "6", "10a", "5-", "E8", "14"}},
      Rows{{1, 0, 0}, {"14", "14", "14", "13", "12a", "9"}},
      Mapped{Point(0.5, 0, 0), Point(0.5, 0, -0.01)},
      Mapped{Point(0.25, 1, 1), Point(0.25, 1, 1)},
      FirstGrid{9, 4, 0.25, 0.05, 0.5, 1, 1, 3, 0.2},
      weight({a, b, c, m}, 0.5, 0.2),
      weight({b, c, d, m}, 0.6, 0.3),
      weight({e, f, g, m}, 0.7, 0.25),
      weight({f, g, h, m}, 0.8, 0.25),
      Insertion{1, {a, b, c, m}, "1", {0, 1, 2, 3}, (a + b + c + m) / 4, 0.19},
      Insertion{2, {b, c, d, m}, "3b", {0, 1, 2}, (b + c + d) / 3, 0.18},
      Flip{true, {a, b, m}, {c, d}, 0.01, 0.02, 0.181},
      Flip{false, {b, c, m}, {e, f}, 0.02, 0.03, 0.182},
      Insertion{3, {e, f, g, m}, "4c", {0, 1}, (e + f) / 2, 0.17},
      Insertion{4, {f, g, h, m}, "2b", {0, 2}, (f + h) / 2, 0.16},
      End{"no-gain", 4, 2, 0, 13, 12, 0.16},
  };
}

inline std::string text_of(const std::vector<Record>& records) {
  std::string text;
  for (const Record& record : records) text += trace::to_line(record) + "\n";
  return text;
}

/// Writes both traces to files, other.jsonl and reference.jsonl, and compares them.
inline verify::TraceComparison compare(const TestFiles& files, const std::vector<Record>& other,
                                       const std::vector<Record>& reference, double tolerance = 1e-9) {
  return verify::compare_traces(files.write("other.jsonl", text_of(other)),
                                files.write("reference.jsonl", text_of(reference)), tolerance);
}

}  // namespace tetproof::test
