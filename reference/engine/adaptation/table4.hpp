// SPDX-License-Identifier: GPL-3.0-or-later
// Table 4: where the new point of a split goes (reading D19).
#pragma once

#include "reference/engine/adaptation/triangulation.hpp"
#include "reference/tables.hpp"

namespace tetproof::reference {

namespace tables {

// clang-format off

/// Where Table 4 puts the new point.
enum class Place : std::uint8_t {
  tetrahedron,  ///< the centroid of the tetrahedron
  face,         ///< the centroid of the unshared face
  edge,         ///< the midpoint of the edge that no other tetrahedron has
};

/// Table 4: by the surface points among the vertices, the faces that no other tetrahedron shares, and whether there is an edge that
/// no other tetrahedron has.
struct Table4Row {
  std::string_view name;
  int surface_points;
  std::string_view configuration;
  Place place;
};

inline constexpr std::array table4{
    //        case  surface points   configuration
    Table4Row{"0",  0, "",                                                             Place::tetrahedron},  // not printed: no special care
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

// clang-format on

}  // namespace tables

/// One tetrahedron's split: each of the corners of the edge, face or tetrahedron that holds the new point is
/// replaced by it in turn, in the order of the tetrahedron's corners.
struct Split {
  int row;                        ///< in `tables::table4`
  int pieces;                     ///< 2, 3 or 4
  std::array<int, 4> replaced{};  ///< `pieces` corner positions, ascending
  Eigen::Vector3d point;          ///< the mean of these corners
  bool on_surface;  ///< the new point is a surface point: it lies on an unshared edge or face (reading D19)
};

/// The splits that Table 4 allows a tetrahedron: one, but where a row takes the longest of several edges, or
/// the largest of several faces. The first is the one prescribed: lengths and areas are compared in doubles,
/// ties by the sorted numbers of the points. The others follow if they are as large to `tie`, relative.
std::vector<Split> splits_by_table4(const Triangulation& grid, Index tet, double tie);

/// The split that Table 4 prescribes for a tetrahedron. Where a row asks for an edge that no other
/// tetrahedron has and there is none, the point is the centroid of the largest unshared face.
Split split_by_table4(const Triangulation& grid, Index tet);

/// The corners of the pieces, with `point` for the corners replaced, in order; the first `split.pieces`
/// count.
std::array<Corners, 4> pieces_of(const Corners& tet, const Split& split, Index point);

}  // namespace tetproof::reference
