// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/first_grid/lattice.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "io/error.hpp"
#include "reference/equations.hpp"

namespace tetproof::reference {

int Lattice::cell_of(int axis, double x) const {
  const std::vector<double>& plane = planes[axis];
  const int last = cells[axis];
  const double guess = (x - plane.front()) / (plane.back() - plane.front()) * last;
  int i = guess > 0 ? static_cast<int>(std::min<double>(guess, last)) : 0;
  while (i > 0 && plane[i] > x) --i;
  while (i < last && plane[i + 1] <= x) ++i;
  return i;
}

Lattice make_lattice(const TriangleSurface& surface, std::array<int, 3> cells, double box_scale) {
  if (!(box_scale > 1) || !(box_scale < 1e6))
    throw InputError(fmt::format("the box scale must be more than 1 and below 1e6, found {}", box_scale));
  Eigen::AlignedBox3d box;
  for (const auto& triangle : surface.triangles)
    for (const Index v : triangle) box.extend(surface.vertices[v]);
  if (box.isEmpty()) throw InputError("the surface has no triangles");
  const double longest = (box.max() - box.min()).maxCoeff();
  if (!(longest >= 1e-90 &&
        longest <= 1e90))  // so that volumes and squared areas neither over- nor underflow
    throw InputError(
        fmt::format("the longest side of the surface's box is {:.7g}, expected 1e-90 to 1e90", longest));
  const Eigen::Vector3d centre = 0.5 * (box.min() + box.max());
  const Eigen::Vector3d sides = box.max() - box.min();
  const Eigen::Vector3d half = 0.5 * sides * box_scale;

  if (cells[0] > 0 && cells[1] == 0 && cells[2] == 0) {
    const int along_longest = cells[0];
    for (int axis = 0; axis < 3; ++axis)
      cells[axis] = std::max(std::min(4, along_longest),
                             static_cast<int>(std::lround(along_longest * sides[axis] / longest)));
  }
  double vertices = 1;
  for (const int n : cells) {
    if (n < 1)
      throw InputError(fmt::format("the number of cells must be 1 or more in each direction, found {}", n));
    vertices *= n + 1.0;
  }
  if (vertices > 4e8)
    throw InputError(fmt::format("a lattice of {} x {} x {} cells is too large: more than 4e8 vertices",
                                 cells[0], cells[1], cells[2]));

  Lattice lattice{cells, {}, HUGE_VAL};
  for (int axis = 0; axis < 3; ++axis) {
    const double x0 = centre[axis] - half[axis], x1 = centre[axis] + half[axis];
    std::vector<double>& plane = lattice.planes[axis];
    plane.resize(cells[axis] + 1);
    for (int i = 0; i <= cells[axis]; ++i) plane[i] = eq_2_1(x0, x1, static_cast<double>(i) / cells[axis]);
    if (!(x0 < box.min()[axis] && box.max()[axis] < x1) ||
        std::adjacent_find(plane.begin(), plane.end(), std::greater_equal<>()) != plane.end() ||
        !std::isfinite(x1 - x0))
      throw InputError(
          fmt::format("the surface's box, {:.17g} .. {:.17g} along {}, cannot be told apart into {} cells in "
                      "double precision",
                      box.min()[axis], box.max()[axis], "xyz"[axis], cells[axis]));
    lattice.shortest_edge = std::min(lattice.shortest_edge, (x1 - x0) / cells[axis]);
  }
  return lattice;
}

}  // namespace tetproof::reference
