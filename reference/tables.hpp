// SPDX-License-Identifier: GPL-3.0-or-later
// Tables 1 to 4 of the paper, row by row in the page's order and notation. Corrections to the printed rows
// name their reading (readings.md). Both engines use them.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace tetproof::reference::tables {

// clang-format off
// Each row of a table is one line, as on the page.

/// The points that a row of Table 2 can name: v_i, the vertices of the lattice tetrahedron; p_ij, the intersection point on edge v_i v_j; and c, the
/// centroid of the six points of case 12 (reading E2).
enum RowPoint : std::uint8_t { v1, v2, v3, v4, p12, p13, p14, p23, p24, p34, c };

inline constexpr int n = 0, y = 1;

/// Table 1: the indicators of a lattice tetrahedron, in descending order, and the edges that can have an intersection point.
struct Table1Row {
  std::string_view name;
  std::array<std::int8_t, 4> indicators;  ///< of v1 .. v4: -1 outside, 0 on the surface, 1 inside
  std::array<int, 6> possible;            ///< p12, p13, p14, p23, p24, p34
};

inline constexpr std::array table1{
    //        case   v1  v2  v3  v4     p12 p13 p14 p23 p24 p34
    Table1Row{"1",  {-1, -1, -1, -1},  {n,  n,  n,  n,  n,  n}},
    Table1Row{"2",  { 0, -1, -1, -1},  {n,  n,  n,  n,  n,  n}},
    Table1Row{"3",  { 0,  0, -1, -1},  {n,  n,  n,  n,  n,  n}},
    Table1Row{"4",  { 0,  0,  0, -1},  {n,  n,  n,  n,  n,  n}},
    Table1Row{"5",  { 0,  0,  0,  0},  {n,  n,  n,  n,  n,  n}},
    Table1Row{"6",  { 1, -1, -1, -1},  {y,  y,  y,  n,  n,  n}},
    Table1Row{"7",  { 1,  0, -1, -1},  {n,  y,  y,  n,  n,  n}},
    Table1Row{"8",  { 1,  0,  0, -1},  {n,  n,  y,  n,  n,  n}},
    Table1Row{"9",  { 1,  0,  0,  0},  {n,  n,  n,  n,  n,  n}},
    Table1Row{"10", { 1,  1, -1, -1},  {n,  y,  y,  y,  y,  n}},
    Table1Row{"11", { 1,  1,  0, -1},  {n,  n,  y,  n,  y,  n}},
    Table1Row{"12", { 1,  1,  1, -1},  {n,  n,  y,  n,  y,  y}},
    Table1Row{"13", { 1,  1,  1,  0},  {n,  n,  n,  n,  n,  n}},
    Table1Row{"14", { 1,  1,  1,  1},  {n,  n,  n,  n,  n,  n}},
    Table1Row{"E8", { 1,  1,  0,  0},  {n,  n,  n,  n,  n,  n}},  // not printed (reading E8)
};

/// Table 2: one triangulation of the part of a lattice tetrahedron that lies inside.
struct Table2Row {
  std::string_view name;
  std::array<std::int8_t, 4> indicators;
  int size = 0;                                   ///< number of tetrahedra
  std::array<std::array<RowPoint, 4>, 8> tets{};  ///< as printed; orientation is corrected where the row is applied (reading E7)

  constexpr Table2Row(std::string_view name_, std::array<std::int8_t, 4> indicators_,
                      std::initializer_list<std::array<RowPoint, 4>> tets_)
      : name(name_), indicators(indicators_) {
    for (const auto& tet : tets_) tets[size++] = tet;
  }
};

inline constexpr std::array table2{
    //        case     v1  v2  v3  v4     first tetrahedron     second tetrahedron    third tetrahedron
    Table2Row{"1",    {-1, -1, -1, -1},  {}},
    Table2Row{"2",    { 0, -1, -1, -1},  {}},
    Table2Row{"3",    { 0,  0, -1, -1},  {}},
    Table2Row{"4",    { 0,  0,  0, -1},  {}},
    Table2Row{"5",    { 0,  0,  0,  0},  {{v1, v2, v3, v4}}},  // kept only if its centroid is inside (reading D10)
    Table2Row{"6",    { 1, -1, -1, -1},  {{v1, p12, p13, p14}}},
    Table2Row{"7",    { 1,  0, -1, -1},  {{v1, v2, p13, p14}}},
    Table2Row{"8",    { 1,  0,  0, -1},  {{v1, v2, v3, p14}}},
    Table2Row{"9",    { 1,  0,  0,  0},  {{v1, v2, v3, v4}}},
    Table2Row{"10a",  { 1,  1, -1, -1},  {{v1, v2, p13, p14},   {v2, p13, p14, p24},  {v2, p13, p23, p24}}},
    Table2Row{"10b",  { 1,  1, -1, -1},  {{v1, v2, p13, p24},   {v1, p13, p14, p24},  {v2, p13, p23, p24}}},
    Table2Row{"10c",  { 1,  1, -1, -1},  {{v1, v2, p14, p23},   {v1, p13, p14, p23},  {v2, p14, p23, p24}}},
    Table2Row{"10d",  { 1,  1, -1, -1},  {{v1, v2, p23, p24},   {v1, p13, p14, p24},  {v1, p13, p23, p24}}},
    Table2Row{"11a",  { 1,  1,  0, -1},  {{v1, v2, v3, p14},    {v2, v3, p14, p24}}},
    Table2Row{"11b",  { 1,  1,  0, -1},  {{v1, v2, v3, p24},    {v1, v3, p14, p24}}},
    Table2Row{"12a",  { 1,  1,  1, -1},  {{v1, v2, v3, p34},    {v1, v2, p14, p34},   {v2, p14, p24, p34}}},  // reading E1
    Table2Row{"12b",  { 1,  1,  1, -1},  {{v1, v2, v3, p14},    {v2, v3, p14, p24},   {v3, p14, p24, p34}}},
    Table2Row{"12c",  { 1,  1,  1, -1},  {{v1, v2, v3, p14},    {v2, v3, p14, p34},   {v2, p14, p24, p34}}},
    Table2Row{"12d",  { 1,  1,  1, -1},  {{v1, v2, v3, p24},    {v1, v3, p14, p24},   {v3, p14, p24, p34}}},
    Table2Row{"12e",  { 1,  1,  1, -1},  {{v1, v2, v3, p24},    {v1, v3, p24, p34},   {v1, p14, p24, p34}}},
    Table2Row{"12f",  { 1,  1,  1, -1},  {{v1, v2, v3, p34},    {v1, v2, p24, p34},   {v1, p14, p24, p34}}},
    // The two triangulations that Table 2 does not list, from the text below it (reading E2).
    Table2Row{"12g",  { 1,  1,  1, -1},  {{v1, v2, v3, c}, {p14, p24, p34, c}, {v1, v2, p24, c}, {v1, p14, p24, c},
                                          {v2, v3, p34, c}, {v2, p24, p34, c}, {v1, v3, p14, c}, {v3, p14, p34, c}}},
    Table2Row{"12h",  { 1,  1,  1, -1},  {{v1, v2, v3, c}, {p14, p24, p34, c}, {v1, v2, p14, c}, {v2, p14, p24, c},
                                          {v2, v3, p24, c}, {v3, p24, p34, c}, {v1, v3, p34, c}, {v1, p14, p34, c}}},
    Table2Row{"13",   { 1,  1,  1,  0},  {{v1, v2, v3, v4}}},
    Table2Row{"14",   { 1,  1,  1,  1},  {{v1, v2, v3, v4}}},
    Table2Row{"E8",   { 1,  1,  0,  0},  {{v1, v2, v3, v4}}},  // not printed (reading E8)
};
static_assert(table1.size() == 14 + 1 && table2.size() == 23 + 2 + 1, "14 cases in 23 printed rows, E2's two and E8's");

/// Table 3: new indicators for an edge that meets the surface in more points than its indicators need (reading D6).
enum class Points { any, even, odd };         ///< the number of intersection points on an edge
enum class Selected { none, closest_to_vi };  ///< the intersection point that becomes the cut
struct Table3Row {
  std::string_view name;
  std::int8_t vi, vj;          ///< initial indicators, vi <= vj
  Points intersections;        ///< between v_i and v_j
  std::int8_t new_vi, new_vj;
  Selected selected;
};

inline constexpr std::array table3{
    //        case  v_i  v_j  intersections   new: v_i  v_j  selected
    Table3Row{"1",  -1,  -1,  Points::any,         -1,  -1,  Selected::none},
    Table3Row{"2",  -1,   0,  Points::any,         -1,  -1,  Selected::none},
    Table3Row{"3a", -1,   1,  Points::even,        -1,  -1,  Selected::none},  // cannot occur (reading E6)
    Table3Row{"3b", -1,   1,  Points::odd,         -1,   1,  Selected::closest_to_vi},
    Table3Row{"4",   0,   0,  Points::any,          1,   1,  Selected::none},
    Table3Row{"5",   0,   1,  Points::any,          1,   1,  Selected::none},
    Table3Row{"6",   1,   1,  Points::any,          1,   1,  Selected::none},
};
static_assert(table3.size() == 7);

/// The row of Table 3 for an edge with these initial indicators, -1 if there is none. Row 3a is never the answer: a closed surface crosses an edge
/// between -1 and +1 an odd number of times (readings D6, E6).
constexpr int table3_row(int vi, int vj) {
  for (std::size_t r = 0; r < table3.size(); ++r)
    if (table3[r].vi == vi && table3[r].vj == vj && table3[r].intersections != Points::even) return static_cast<int>(r);
  return -1;
}

/// Where Table 4 puts the new point.
enum class Place : std::uint8_t {
  tetrahedron,  ///< the centroid of the tetrahedron
  face,         ///< the centroid of the unshared face
  edge,         ///< the midpoint of the edge that no other tetrahedron has
};

/// A row of Table 4. Its case depends on the number of surface points among the vertices and on the edges and faces that no other
/// tetrahedron shares.
struct Table4Row {
  std::string_view name;
  int surface_points;
  std::string_view configuration;
  Place place;
};

inline constexpr std::array table4{
    //        case  surface points   configuration
    Table4Row{"0",  0, "",                                                             Place::tetrahedron},  // not printed: the paper asks for no special care
    Table4Row{"1",  1, "",                                                             Place::tetrahedron},
    Table4Row{"2a", 2, "another tetrahedron shares the edge v1 v2",                    Place::tetrahedron},
    Table4Row{"2b", 2, "no other tetrahedron shares the edge v1 v2",                   Place::edge},
    Table4Row{"3a", 3, "another tetrahedron shares the face (v1, v2, v3)",             Place::tetrahedron},
    Table4Row{"3b", 3, "no other tetrahedron shares the face (v1, v2, v3)",            Place::face},
    Table4Row{"4a", 4, "all four faces are shared by other tetrahedra",                Place::tetrahedron},
    Table4Row{"4b", 4, "three faces are shared, (v2, v3, v4) is not",                  Place::face},
    Table4Row{"4c", 4, "two faces are shared, (v1, v3, v4) and (v2, v3, v4) are not",  Place::edge},         // printed as a first "4d" (reading E3)
    Table4Row{"4d", 4, "the face (v1, v2, v3) is shared, the other three are not",     Place::edge},
    Table4Row{"4e", 4, "no face is shared by another tetrahedron",                     Place::edge},
};
static_assert(table4.size() == 11);

/// The row of Table 4 with this name, -1 if there is none.
constexpr int table4_row(std::string_view name) {
  for (std::size_t r = 0; r < table4.size(); ++r)
    if (table4[r].name == name) return static_cast<int>(r);
  return -1;
}

}  // namespace tetproof::reference::tables
