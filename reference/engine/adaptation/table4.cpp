// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/adaptation/table4.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace tetproof::reference {
namespace {

using tables::Place;

// An edge or face of a tetrahedron as a place for the new point.
struct Simplex {
  std::vector<int> corners;  // positions in the tetrahedron, ascending
  double size;               // squared length, or squared area times four
  std::vector<Index> names;  // the numbers of its points, ascending
};

Simplex simplex(const Triangulation& grid, Index tet, std::vector<int> corners) {
  const auto points = grid.corner_points(tet);
  const Eigen::Vector3d& a = points[corners[0]];
  const Eigen::Vector3d ab = points[corners[1]] - a;
  const double size = corners.size() == 2 ? ab.squaredNorm() : ab.cross(points[corners[2]] - a).squaredNorm();
  std::vector<Index> names;
  for (const int i : corners) names.push_back(grid.corners(tet)[i]);
  std::sort(names.begin(), names.end());
  return {std::move(corners), size, std::move(names)};
}

Split split_at(const Triangulation& grid, Index tet, int row, const std::vector<int>& corners) {
  Split split{.row = row,
              .pieces = static_cast<int>(corners.size()),
              .point = Eigen::Vector3d::Zero(),
              .on_surface = tables::table4[row].place != Place::tetrahedron};
  std::copy(corners.begin(), corners.end(), split.replaced.begin());
  for (const int i : corners) split.point += grid.point(grid.corners(tet)[i]);
  split.point /= split.pieces;
  return split;
}

constexpr int row_0 = tables::table4_row("0"), row_1 = tables::table4_row("1"),
              row_2a = tables::table4_row("2a"), row_2b = tables::table4_row("2b"),
              row_3a = tables::table4_row("3a"), row_3b = tables::table4_row("3b"),
              row_4a = tables::table4_row("4a");

}  // namespace

std::vector<Split> splits_by_table4(const Triangulation& grid, Index tet, double tie) {
  const std::vector<int> all{0, 1, 2, 3};
  std::vector<int> surface;  // v1, v2, ... of the row
  int other = -1;            // the last corner that is not a surface point
  for (int i = 0; i < 4; ++i)
    if (grid.on_surface(grid.corners(tet)[i]))
      surface.push_back(i);
    else
      other = i;

  switch (surface.size()) {
    case 0:
      return {split_at(grid, tet, row_0, all)};
    case 1:
      return {split_at(grid, tet, row_1, all)};
    case 2:
      if (grid.edge_is_shared(tet, surface[0], surface[1])) return {split_at(grid, tet, row_2a, all)};
      return {split_at(grid, tet, row_2b, surface)};
    case 3:
      if (grid.neighbour(tet, other) >= 0) return {split_at(grid, tet, row_3a, all)};
      return {split_at(grid, tet, row_3b, surface)};
    default:
      break;
  }

  std::vector<Simplex> faces, edges;  // that no other tetrahedron has
  for (int f = 0; f < 4; ++f) {
    if (grid.neighbour(tet, f) >= 0) continue;
    std::vector<int> corners = all;
    corners.erase(corners.begin() + f);
    faces.push_back(simplex(grid, tet, std::move(corners)));
  }
  const int row = row_4a + static_cast<int>(faces.size());  // 4a .. 4e by the number of unshared faces
  if (tables::table4[row].place == Place::tetrahedron) return {split_at(grid, tet, row, all)};
  if (tables::table4[row].place == Place::edge)
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        if (!grid.edge_is_shared(tet, i, j)) edges.push_back(simplex(grid, tet, {i, j}));
  std::vector<Simplex>& places = edges.empty() ? faces : edges;
  std::sort(places.begin(), places.end(), [](const Simplex& a, const Simplex& b) {
    return a.size != b.size ? a.size > b.size : a.names < b.names;
  });
  std::vector<Split> splits;
  for (const Simplex& place : places)  // sizes are squares, hence 2 * tie
    if (splits.empty() || place.size >= places.front().size * (1 - 2 * tie))
      splits.push_back(split_at(grid, tet, row, place.corners));
  return splits;
}

Split split_by_table4(const Triangulation& grid, Index tet) {
  return splits_by_table4(grid, tet, 0).front();
}

std::array<Corners, 4> pieces_of(const Corners& tet, const Split& split, Index point) {
  std::array<Corners, 4> pieces;
  for (int k = 0; k < split.pieces; ++k) {
    pieces[k] = tet;
    pieces[k][split.replaced[k]] = point;
  }
  return pieces;
}

}  // namespace tetproof::reference
