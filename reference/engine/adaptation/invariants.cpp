// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/adaptation/invariants.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "reference/engine/first_grid/exact.hpp"

namespace tetproof::reference {
namespace {

using Face = std::array<Index, 3>;

// A face in its own orientation, starting at its lowest vertex.
Face face_of(const Corners& tet, int f) {
  const auto& [i, j, k] = tet_faces[f];
  Face face{tet[i], tet[j], tet[k]};
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

Face reversed(const Face& face) {
  return {face[0], face[2], face[1]};
}

void check_tetrahedron(const Triangulation& grid, Index t) {
  const auto [a, b, c, d] = grid.corner_points(t);
  if (orientation(a, b, c, d) <= 0) throw std::logic_error(fmt::format("tetrahedron {} is not positive", t));
  for (int f = 0; f < 4; ++f) {
    const Index n = grid.neighbour(t, f);
    if (n < 0) continue;
    bool met = false;
    for (int g = 0; g < 4; ++g)
      met |= grid.alive(n) && grid.neighbour(n, g) == t &&
             face_of(grid.corners(n), g) == reversed(face_of(grid.corners(t), f));
    if (!met) throw std::logic_error(fmt::format("tetrahedra {} and {} do not meet face to face", t, n));
  }
}

void check_faces(const Triangulation& grid) {
  std::map<Face, int> uses;
  for (Index t = 0; t < grid.numbers(); ++t)
    for (int f = 0; f < 4 && grid.alive(t); ++f) {
      const Face face = face_of(grid.corners(t), f);
      if (++uses[face] > 1 || (grid.neighbour(t, f) < 0 && uses.contains(reversed(face))))
        throw std::logic_error(fmt::format("face {} {} {} belongs to more tetrahedra than the neighbours say",
                                           face[0], face[1], face[2]));
    }
}

}  // namespace

void check_invariants(const WeightedGrid& weighted, Index first) {
  const Triangulation& grid = weighted.grid();
  CompensatedSum sum;
  std::int64_t tets = 0;
  for (Index t = 0; t < grid.numbers(); ++t) {
    if (!grid.alive(t)) continue;
    ++tets;
    const Weight& weight = weighted.weight(t);
    sum.add(weight.error);
    if (t < first) continue;
    check_tetrahedron(grid, t);
    const auto [a, b, c, d] = grid.corner_points(t);
    if (weight.error != volume_error(volume(a, b, c, d), weight.desired))
      throw std::logic_error(fmt::format("the error kept for tetrahedron {} is not that of its volume", t));
  }
  if (first == 0) check_faces(grid);
  const double e_avg = average_error(sum.value(), tets);
  if (tets != grid.tets() || !(std::abs(e_avg - weighted.e_avg()) <= 1e-12 * e_avg))
    throw std::logic_error(fmt::format("E_avg is kept as {} of {} tetrahedra, and is {} of {}",
                                       weighted.e_avg(), grid.tets(), e_avg, tets));
}

}  // namespace tetproof::reference
