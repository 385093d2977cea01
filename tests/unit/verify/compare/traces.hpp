// SPDX-License-Identifier: GPL-3.0-or-later
// A small handmade trace in which tests plant differences: a box of two cells, four tetrahedra, four
// insertions, two flips, the second of which undoes the first. Every tetrahedron that it names is there when
// it is named.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
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
// The new points of the first two insertions.
inline const Point p = (a + b + c + m) / 4, q = (b + c + d) / 3;

/// The smallest solid angle as a fraction of 4 pi, by the dihedral angles: a solid angle is the sum of the
/// three at its vertex, less pi.
inline double smallest_solid_angle(const Tet& tet) {
  const auto dihedral = [&](int i, int j) {  // at the edge i j
    const int k = (i != 0 && j != 0) ? 0 : (i != 1 && j != 1) ? 1 : 2, l = 6 - i - j - k;
    const Point u = tet[j] - tet[i];
    return std::acos(u.cross(tet[k] - tet[i]).normalized().dot(u.cross(tet[l] - tet[i]).normalized()));
  };
  double smallest = 1;
  for (int i = 0; i < 4; ++i) {
    double sum = -std::numbers::pi;
    for (int j = 0; j < 4; ++j)
      if (j != i) sum += dihedral(i, j);
    smallest = std::min(smallest, sum / (4 * std::numbers::pi));
  }
  return smallest;
}

/// A flip with its right qualities; `quality` measures one tetrahedron.
template <class Quality = double(const Tet&)>
trace::Flip flip(bool two_to_three, const std::array<Point, 3>& face, const std::array<Point, 2>& edge,
                 double e_avg, const Quality& quality = smallest_solid_angle) {
  const auto& [x, y, z] = face;
  const double beside = std::min(quality({x, y, z, edge[0]}), quality({x, y, z, edge[1]}));
  const double around = std::min({quality({x, y, edge[0], edge[1]}), quality({y, z, edge[0], edge[1]}),
                                  quality({z, x, edge[0], edge[1]})});
  return {two_to_three, face, edge, two_to_three ? beside : around, two_to_three ? around : beside, e_avg};
}

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
      Insertion{1, {a, b, c, m}, "1", {0, 1, 2, 3}, p, 0.19},
      Insertion{2, {b, c, d, m}, "3b", {0, 1, 2}, q, 0.18},
      flip(true, {b, c, m}, {p, q}, 0.181),
      flip(false, {b, c, m}, {p, q}, 0.182),
      Insertion{3, {e, f, g, m}, "4c", {0, 1}, (e + f) / 2, 0.17},
      Insertion{4, {f, g, h, m}, "2b", {0, 2}, (f + h) / 2, 0.16},
      End{"no-gain", 4, 2, 0, 13, 11, 0.16},
  };
}

/// The record on a line, to change it.
template <class R>
R& at(std::vector<Record>& records, std::size_t line) {
  return std::get<R>(records.at(line));
}

/// A position in `small_trace` as a line of the file.
constexpr std::int64_t in_file(std::size_t line) {
  return static_cast<std::int64_t>(line) + 1;
}

inline std::string text_of(const std::vector<Record>& records) {
  std::string text;
  for (const Record& record : records) text += trace::to_line(record) + "\n";
  return text;
}

/// Writes both traces to files, other.jsonl and reference.jsonl, and compares them.
inline verify::TraceComparison compare(const TestFiles& files, const std::vector<Record>& other,
                                       const std::vector<Record>& reference, double tolerance = 1e-9,
                                       const verify::CheckTrace& check = {}) {
  return verify::compare_traces(files.write("other.jsonl", text_of(other)),
                                files.write("reference.jsonl", text_of(reference)), tolerance, check);
}

}  // namespace tetproof::test
