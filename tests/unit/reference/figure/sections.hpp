// SPDX-License-Identifier: GPL-3.0-or-later
// A grid of a cube; and the area of a grid's cross-section, computed differently from the code under test.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "io/tet_mesh.hpp"

namespace tetproof::test {

/// The unit cube, cut into n x n x n cells of six tetrahedra.
inline TetMesh block(int n) {
  TetMesh mesh;
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) mesh.points.push_back(Eigen::Vector3d(i, j, k) / n);
  const int step[] = {1, n + 1, (n + 1) * (n + 1)};
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        std::array<int, 3> axes{0, 1, 2};
        do {
          const int a = i + (n + 1) * (j + (n + 1) * k), b = a + step[axes[0]], c = b + step[axes[1]];
          mesh.tets.push_back({a, b, c, c + step[axes[2]]});
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  return mesh;
}

/// The area of the cross-section, computed from the boundary faces alone: the sum over the directed segments
/// in which the plane x_axis = value meets them. The plane must not contain a vertex.
inline double section_area(const TetMesh& mesh, int axis, double value) {
  std::map<std::array<Index, 3>, std::pair<int, std::array<Index, 3>>> faces;
  for (const auto& tet : mesh.tets)
    for (const auto& [a, b, c] : tet_faces) {
      const std::array<Index, 3> face{tet[a], tet[b], tet[c]};
      std::array<Index, 3> sorted = face;
      std::sort(sorted.begin(), sorted.end());
      auto& [count, directed] = faces[sorted];
      ++count, directed = face;
    }
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  double twice = 0;
  for (const auto& [sorted, entry] : faces) {
    if (entry.first != 1) continue;
    std::array<Eigen::Vector3d, 2> ends;  // where the face goes down through the plane, and up
    int met = 0;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d a = mesh.points[entry.second[i]], b = mesh.points[entry.second[(i + 1) % 3]];
      if ((a[axis] > value) == (b[axis] > value)) continue;
      ends[a[axis] > value ? 0 : 1] = a + (value - a[axis]) / (b[axis] - a[axis]) * (b - a);
      ++met;
    }
    if (met == 2) twice += ends[0][u] * ends[1][v] - ends[0][v] * ends[1][u];
  }
  return std::abs(twice) / 2;
}

}  // namespace tetproof::test
