// SPDX-License-Identifier: GPL-3.0-or-later
// Table 4: the place of the new point when a tetrahedron is split (reading D19).
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

// clang-format on

}  // namespace tables

/// The split of one tetrahedron. The new point lies on an edge, on a face or inside. There is one piece for
/// each corner of that edge, face or tetrahedron: the tetrahedron with this corner replaced by the new point.
/// The pieces are in the order of the corners.
struct Split {
  int row;                        ///< in `tables::table4`
  int pieces;                     ///< 2, 3 or 4
  std::array<int, 4> replaced{};  ///< the first `pieces`: positions of the replaced corners, ascending
  Eigen::Vector3d point;          ///< the mean of these corners
  /// Whether the new point is a surface point: it lies on an unshared edge or face (reading D19).
  bool on_surface;
};

/// The splits of a tetrahedron that Table 4 allows. There is more than one only if a row takes the longest of
/// several edges, or the largest of several faces. The first split is the prescribed one: lengths and areas
/// are compared in doubles, and equal ones by the sorted numbers of their points. The other splits are those
/// whose edge or face is as large within a relative difference of `tie`.
std::vector<Split> splits_by_table4(const Triangulation& grid, Index tet, double tie);

/// The split of a tetrahedron that Table 4 prescribes. If the row asks for an edge that no other tetrahedron
/// has, and there is none, the point is the centroid of the largest unshared face.
Split split_by_table4(const Triangulation& grid, Index tet);

/// The corners of the pieces, in order, where `point` is the number of the new point. The first
/// `split.pieces` are set.
std::array<Corners, 4> pieces_of(const Corners& tet, const Split& split, Index point);

}  // namespace tetproof::reference
