// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/first_grid/row_choice.hpp"

#include <algorithm>
#include <stdexcept>

namespace tetproof::reference {

using namespace tables;

namespace {

constexpr std::size_t rows = table2.size();

// The tetrahedron v1 = 0, v2 = 12 e1, v3 = 12 e2, v4 = 12 e3 with its cuts at midpoints. All points are
// integers, because 12 is a multiple of 2 and of 6.
using Point = std::array<int, 3>;
constexpr Point place(RowPoint p) {
  constexpr std::array<Point, 4> v{{{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {0, 0, 12}}};
  constexpr std::array<std::array<int, 2>, 6> ends{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  if (p <= v4) return v[p];
  Point sum{};
  if (p <= p34) {
    for (int x = 0; x < 3; ++x) sum[x] = (v[ends[p - p12][0]][x] + v[ends[p - p12][1]][x]) / 2;
    return sum;
  }
  for (const RowPoint q : {v1, v2, v3, p14, p24, p34})
    for (int x = 0; x < 3; ++x) sum[x] += place(q)[x];
  for (int& x : sum) x /= 6;
  return sum;
}

constexpr int orientation_as_listed(const std::array<RowPoint, 4>& tet) {
  const Point a = place(tet[0]), b = place(tet[1]), c = place(tet[2]), d = place(tet[3]);
  int m[3][3]{};
  for (int x = 0; x < 3; ++x) {
    m[0][x] = b[x] - a[x];
    m[1][x] = c[x] - a[x];
    m[2][x] = d[x] - a[x];
  }
  const int det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                  m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                  m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return det > 0 ? 1 : det < 0 ? -1 : 0;
}

constexpr auto orientations = [] {
  std::array<std::array<int, 8>, rows> signs{};
  for (std::size_t r = 0; r < rows; ++r)
    for (int t = 0; t < table2[r].size; ++t) signs[r][t] = orientation_as_listed(table2[r].tets[t]);
  return signs;
}();

constexpr RowPoint cut(int i, int e) {  // p_ie; i < e
  constexpr std::array<std::array<int, 4>, 4> number{{{0, 0, 1, 2}, {0, 0, 3, 4}, {0, 0, 0, 5}, {}}};
  return static_cast<RowPoint>(p12 + number[i][e]);
}

constexpr Quads quads_of(const std::array<std::int8_t, 4>& s) {
  Quads found;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      for (int e = j + 1; e < 4; ++e)
        if (s[i] > 0 && s[j] > 0 && s[e] < 0)
          found.quads[found.size++] = {static_cast<RowPoint>(i), static_cast<RowPoint>(j), cut(i, e),
                                       cut(j, e)};
  return found;
}

constexpr bool has_edge(const Table2Row& row, RowPoint a, RowPoint b) {
  for (int t = 0; t < row.size; ++t) {
    bool has_a = false, has_b = false;
    for (const RowPoint p : row.tets[t]) {
      has_a |= p == a;
      has_b |= p == b;
    }
    if (has_a && has_b) return true;
  }
  return false;
}

constexpr int find_row(int first_row, unsigned from_the_first) {
  const Quads quads = quads_of(table2[first_row].indicators);
  for (std::size_t r = first_row; r < rows && table2[r].indicators == table2[first_row].indicators; ++r) {
    bool fits = true;
    for (int q = 0; q < quads.size; ++q) {
      const Quad& quad = quads.quads[q];
      fits = fits && (from_the_first >> q & 1 ? has_edge(table2[r], quad.vi, quad.pje)
                                              : has_edge(table2[r], quad.vj, quad.pie));
    }
    if (fits) return static_cast<int>(r);
  }
  return -1;
}

struct Choices {
  std::array<Quads, rows> quads{};
  std::array<std::array<int, 8>, rows> row{};
};
constexpr Choices choices = [] {
  Choices all;
  for (std::size_t r = 0; r < rows; ++r) {
    all.quads[r] = quads_of(table2[r].indicators);
    for (unsigned mask = 0; mask < 8; ++mask)
      all.row[r][mask] = find_row(static_cast<int>(r), mask & ((1u << all.quads[r].size) - 1));
  }
  return all;
}();

constexpr SortedVertices sorted(std::array<std::int8_t, 4> s) {
  SortedVertices result{{0, 1, 2, 3}, 1, 0};
  // Bubble sort keeps equal ones in order, and each exchange changes the sign.
  for (int pass = 0; pass < 3; ++pass)
    for (int a = 0; a < 3; ++a)
      if (s[a] < s[a + 1]) {
        std::swap(s[a], s[a + 1]);
        std::swap(result.order[a], result.order[a + 1]);
        result.sign = -result.sign;
      }
  while (table2[result.first_row].indicators != s) ++result.first_row;
  return result;
}

constexpr int code(const std::array<std::int8_t, 4>& s) {
  return s[0] + 1 + 3 * (s[1] + 1) + 9 * (s[2] + 1) + 27 * (s[3] + 1);
}

constexpr auto all_sorted = [] {
  std::array<SortedVertices, 81> all{};
  for (std::int8_t d = -1; d <= 1; ++d)
    for (std::int8_t e = -1; e <= 1; ++e)
      for (std::int8_t f = -1; f <= 1; ++f)
        for (std::int8_t g = -1; g <= 1; ++g) all[code({d, e, f, g})] = sorted({d, e, f, g});
  return all;
}();

}  // namespace

SortedVertices sort_vertices(const std::array<std::int8_t, 4>& indicators) {
  return all_sorted[code(indicators)];
}
const Quads& shared_quads(int first_row) {
  return choices.quads[first_row];
}
int choose_row(int first_row, unsigned from_the_first) {
  return choices.row[first_row][from_the_first];
}
int listed_orientation(int row, int t) {
  return orientations[row][t];
}

}  // namespace tetproof::reference
