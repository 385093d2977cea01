// SPDX-License-Identifier: GPL-3.0-or-later
// Tables 1, 2 and 3 against rational arithmetic and facts known by hand.
#include "reference/tables.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "reference/engine/first_grid/row_choice.hpp"
#include "tests/support/exact_mesh.hpp"

namespace tetproof::reference {
namespace {

using namespace tables;
using exact_mesh::Point;
using exact_mesh::Rational;

constexpr std::array<std::array<int, 2>, 6> edges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

// A lattice tetrahedron cut by a plane. A linear function has the value f[i] at vertex i and is 0 on the
// plane; p_ij is its zero on an edge.
struct CutTetrahedron {
  std::array<Point, 11> place;
  Rational volume6, inside6;  // of the whole tetrahedron and of the part where the function is positive
};

CutTetrahedron cut_by_plane(const std::array<std::int8_t, 4>& indicators, std::mt19937_64& random) {
  const auto draw = [&] { return Rational(static_cast<int>(random() % 1000) + 1, 997); };
  CutTetrahedron cut;
  for (;;) {
    for (int i = 0; i < 4; ++i) cut.place[i] = {draw(), draw(), draw()};
    cut.volume6 = exact_mesh::volume6(cut.place[0], cut.place[1], cut.place[2], cut.place[3]);
    if (cut.volume6 > 0) break;
  }
  std::array<Rational, 4> f;
  for (int i = 0; i < 4; ++i) {
    bool repeated;
    do {
      f[i] = indicators[i] * draw();
      repeated = false;
      for (int j = 0; j < i; ++j) repeated = repeated || (f[i] != 0 && f[j] == f[i]);
    } while (repeated);
  }
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = edges[e];
    if (indicators[i] * indicators[j] >= 0) continue;
    const Rational t = f[i] / (f[i] - f[j]);
    for (int x = 0; x < 3; ++x)
      cut.place[p12 + e][x] = cut.place[i][x] + t * (cut.place[j][x] - cut.place[i][x]);
  }
  for (int x = 0; x < 3; ++x) {
    cut.place[c][x] = 0;
    for (const RowPoint p : {v1, v2, v3, p14, p24, p34}) cut.place[c][x] += cut.place[p][x] / 6;
  }
  // The volume of the part of a simplex where a linear function is positive is V * sum of f_i^3 / prod (f_i -
  // f_j) over the positive vertices.
  cut.inside6 = 0;
  for (int i = 0; i < 4; ++i) {
    if (f[i] <= 0) continue;
    Rational term = f[i] * f[i] * f[i];
    for (int j = 0; j < 4; ++j)
      if (j != i) term /= f[i] - f[j];
    cut.inside6 += term * cut.volume6;
  }
  return cut;
}

class Table2 : public testing::TestWithParam<int> {
 protected:
  const Table2Row& row = table2[GetParam()];
};

TEST_P(Table2, TilesExactlyTheInsidePart) {
  std::mt19937_64 random(1994);
  for (int trial = 0; trial < 20; ++trial) {
    const CutTetrahedron cut = cut_by_plane(row.indicators, random);
    Rational sum = 0;
    std::map<std::array<int, 3>, int> faces;
    for (int t = 0; t < row.size; ++t) {
      std::array<int, 4> tet;
      for (int v = 0; v < 4; ++v) tet[v] = row.tets[t][v];
      Rational volume =
          exact_mesh::volume6(cut.place[tet[0]], cut.place[tet[1]], cut.place[tet[2]], cut.place[tet[3]]);
      EXPECT_EQ(volume.sign(), listed_orientation(GetParam(), t)) << row.name << " tetrahedron " << t;
      if (volume < 0) {
        std::swap(tet[2], tet[3]);
        volume = -volume;
      }
      sum += volume;
      for (const auto& f : {std::array{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}) {
        std::array<int, 3> face{tet[f[0]], tet[f[1]], tet[f[2]]};
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        EXPECT_EQ(++faces[face], 1) << row.name << ": a face is induced twice alike";
      }
    }
    // Case 5 has no positive vertex. It is kept as a whole or not at all (reading D10).
    EXPECT_EQ(sum, row.name == "5" ? cut.volume6 : cut.inside6) << row.name;
    // Unmatched faces lie on a face of the lattice tetrahedron or on the surface: all their points are in
    // that plane, and none is the centroid.
    for (const auto& [face, count] : faces) {
      if (faces.contains({face[0], face[2], face[1]})) continue;
      const auto on_lattice_face = [&](int opposite) {
        return std::all_of(face.begin(), face.end(), [&](int p) {
          if (p < 4) return p != opposite;
          return p != c && edges[p - p12][0] != opposite && edges[p - p12][1] != opposite;
        });
      };
      const bool on_surface = std::all_of(face.begin(), face.end(),
                                          [&](int p) { return p < 4 ? row.indicators[p] == 0 : p != c; });
      EXPECT_TRUE(on_surface || on_lattice_face(0) || on_lattice_face(1) || on_lattice_face(2) ||
                  on_lattice_face(3))
          << row.name;
    }
  }
}

TEST_P(Table2, NamesOnlyCutsThatTable1Allows) {
  const auto one = std::find_if(table1.begin(), table1.end(),
                                [&](const Table1Row& r) { return r.indicators == row.indicators; });
  ASSERT_NE(one, table1.end());
  std::set<int> named;
  for (int t = 0; t < row.size; ++t)
    for (const RowPoint p : row.tets[t])
      if (p >= p12 && p <= p34) named.insert(p - p12);
  for (const int p : named) EXPECT_EQ(one->possible[p], y) << row.name << " names cut " << p;
  for (int p = 0; row.size > 0 && p < 6; ++p)
    EXPECT_EQ(named.contains(p), one->possible[p] == y) << row.name << " cut " << p;
}

INSTANTIATE_TEST_SUITE_P(EveryRow, Table2, testing::Range(0, static_cast<int>(table2.size())),
                         [](const auto& each) { return std::string(table2[each.param].name); });

TEST(Table1, HasEveryMultisetOfIndicatorsOnce) {
  std::set<std::array<std::int8_t, 4>> rows;
  for (const Table1Row& row : table1) {
    EXPECT_TRUE(std::is_sorted(row.indicators.rbegin(), row.indicators.rend())) << row.name;
    rows.insert(row.indicators);
    for (int p = 0; p < 6; ++p)
      EXPECT_EQ(row.possible[p] == y, row.indicators[edges[p][0]] * row.indicators[edges[p][1]] < 0)
          << row.name << " edge " << p;
  }
  EXPECT_EQ(rows.size(), 15u);  // 4 indicators of 3 kinds: (4+2 choose 2)
  EXPECT_EQ(table1.size(), 15u);
}

TEST(Table2Errata, NegativeAsListed) {
  // Reading E7. The names are those of the paper.
  const std::set<std::string> expected{"10a.3", "10b.3", "10d.3", "10c.1",
                                       "10c.3", "12a.2", "12e.2", "12f.2"};
  std::set<std::string> found;
  for (std::size_t r = 0; r < table2.size(); ++r)
    for (int t = 0; t < table2[r].size; ++t)
      if (table2[r].size <= 3 && listed_orientation(static_cast<int>(r), t) < 0)
        found.insert(std::string(table2[r].name) + "." + std::to_string(t + 1));
  EXPECT_EQ(found, expected);
}

// Sorting all 81 kinds of tetrahedra: indicators descend, equal ones keep their order, the sign of the
// permutation is right, and the case has these indicators.
TEST(SortVertices, All81) {
  for (int code = 0; code < 81; ++code) {
    std::array<std::int8_t, 4> s;
    for (int i = 0, rest = code; i < 4; ++i, rest /= 3) s[i] = static_cast<std::int8_t>(rest % 3 - 1);
    const SortedVertices sorted = sort_vertices(s);
    std::array<std::pair<int, int>, 4> by_hand;
    for (int i = 0; i < 4; ++i) by_hand[i] = {-s[i], i};
    std::sort(by_hand.begin(), by_hand.end());
    int inversions = 0;
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(sorted.order[i], by_hand[i].second) << code;
      EXPECT_EQ(table2[sorted.first_row].indicators[i], -by_hand[i].first) << code;
      for (int j = 0; j < i; ++j) inversions += by_hand[j].second > by_hand[i].second;
    }
    EXPECT_EQ(sorted.sign, inversions % 2 ? -1 : 1) << code;
    EXPECT_TRUE(sorted.first_row == 0 ||
                table2[sorted.first_row - 1].indicators != table2[sorted.first_row].indicators);
  }
}

struct DiagonalCase {
  const char* first_row;
  std::vector<std::array<RowPoint, 2>> diagonals;
  const char* row;
};

TEST(ChooseRow, ByTheDiagonalsOfItsQuadrilaterals) {
  const std::vector<DiagonalCase> cases{
      {"10a", {{v1, p23}, {v1, p24}}, "10d"},
      {"10a", {{v1, p23}, {v2, p14}}, "10c"},
      {"10a", {{v2, p13}, {v1, p24}}, "10b"},
      {"10a", {{v2, p13}, {v2, p14}}, "10a"},
      {"11a", {{v1, p24}}, "11b"},
      {"11a", {{v2, p14}}, "11a"},
      {"12a", {{v1, p24}, {v1, p34}, {v2, p34}}, "12f"},
      {"12a", {{v1, p24}, {v1, p34}, {v3, p24}}, "12e"},
      {"12a", {{v1, p24}, {v3, p14}, {v3, p24}}, "12d"},
      {"12a", {{v1, p24}, {v3, p14}, {v2, p34}}, "12g"},
      {"12a", {{v2, p14}, {v1, p34}, {v2, p34}}, "12a"},
      {"12a", {{v2, p14}, {v1, p34}, {v3, p24}}, "12h"},
      {"12a", {{v2, p14}, {v3, p14}, {v2, p34}}, "12c"},
      {"12a", {{v2, p14}, {v3, p14}, {v3, p24}}, "12b"},
  };
  for (const DiagonalCase& one : cases) {
    int first = 0;
    while (table2[first].name != one.first_row) ++first;
    const Quads& quads = shared_quads(first);
    ASSERT_EQ(static_cast<std::size_t>(quads.size), one.diagonals.size());
    unsigned from_the_first = 0;
    for (int q = 0; q < quads.size; ++q) {
      const Quad& quad = quads.quads[q];
      for (const auto& d : one.diagonals)
        from_the_first |= static_cast<unsigned>(d == std::array{quad.vi, quad.pje}) << q;
    }
    EXPECT_EQ(table2[choose_row(first, from_the_first)].name, one.row);
  }
}

TEST(Table3, RowsByIndicators) {
  const std::vector<std::tuple<int, int, const char*, int, int>> expected{
      {-1, -1, "1", -1, -1}, {-1, 0, "2", -1, -1}, {-1, 1, "3b", -1, 1},
      {0, 0, "4", 1, 1},     {0, 1, "5", 1, 1},    {1, 1, "6", 1, 1}};
  for (const auto& [vi, vj, name, new_vi, new_vj] : expected) {
    const Table3Row& row = table3[table3_row(vi, vj)];
    EXPECT_EQ(row.name, name);
    EXPECT_EQ(row.new_vi, new_vi) << name;
    EXPECT_EQ(row.new_vj, new_vj) << name;
    EXPECT_EQ(row.selected, std::string(name) == "3b" ? Selected::closest_to_vi : Selected::none) << name;
  }
}

}  // namespace
}  // namespace tetproof::reference
