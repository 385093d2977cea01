// SPDX-License-Identifier: GPL-3.0-or-later
// A slow, independent look at a mesh for the reference's tests: rational arithmetic and ordered maps, no code
// shared with reference/ or verify/.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <map>
#include <string>
#include <vector>

#include "io/tet_mesh.hpp"

namespace exact_mesh {

using Rational = boost::multiprecision::cpp_rational;
using Point = std::array<Rational, 3>;
using tetproof::Index;

inline Point exact(const Eigen::Vector3d& p) {
  return {Rational(p.x()), Rational(p.y()), Rational(p.z())};
}

/// Six times the signed volume.
inline Rational volume6(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<Point, 3> m{b, c, d};
  for (Point& row : m)
    for (int x = 0; x < 3; ++x) row[x] -= a[x];
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

inline Rational volume6(const tetproof::TetMesh& mesh) {
  Rational sum = 0;
  for (const auto& [a, b, c, d] : mesh.tets)
    sum +=
        volume6(exact(mesh.points[a]), exact(mesh.points[b]), exact(mesh.points[c]), exact(mesh.points[d]));
  return sum;
}

/// What is wrong with a mesh that should be positive and conforming; empty if nothing. `boundary` gets the
/// faces of one tetrahedron, oriented outwards.
inline std::string fault(const tetproof::TetMesh& mesh,
                         std::vector<std::array<Index, 3>>* boundary = nullptr) {
  std::map<std::array<Index, 3>, int> faces;  // oriented, smallest vertex first
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& tet = mesh.tets[t];
    if (volume6(exact(mesh.points[tet[0]]), exact(mesh.points[tet[1]]), exact(mesh.points[tet[2]]),
                exact(mesh.points[tet[3]])) <= 0)
      return "tetrahedron " + std::to_string(t) + " is not positive";
    for (const auto& corners : {std::array{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}) {
      std::array<Index, 3> face{tet[corners[0]], tet[corners[1]], tet[corners[2]]};
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      if (++faces[face] > 1)
        return "a face is induced twice with the same orientation, by tetrahedron " + std::to_string(t);
    }
  }
  if (boundary)
    for (const auto& [face, count] : faces)
      if (!faces.contains({face[0], face[2], face[1]})) boundary->push_back(face);
  return "";
}

}  // namespace exact_mesh
