// SPDX-License-Identifier: GPL-3.0-or-later
// Sound meshes and closed surfaces to plant defects in, made here and by nothing under test.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <vector>

#include "io/tet_mesh.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::test {

using Cell = std::array<int, 3>;

/// Cells of a lattice, those that `keep` keeps, split into six tetrahedra each around the diagonal (Kuhn).
/// Only the points that are used, numbered lexicographically.
inline TetMesh lattice_mesh(Cell n, const std::function<bool(Cell)>& keep = {},
                            Eigen::Vector3d origin = {0, 0, 0}, double size = 1) {
  TetMesh mesh;
  std::map<Cell, Index> number;
  std::vector<std::array<Cell, 4>> tets;
  for (int i = 0; i < n[0]; ++i)
    for (int j = 0; j < n[1]; ++j)
      for (int k = 0; k < n[2]; ++k) {
        if (keep && !keep({i, j, k})) continue;
        std::array<int, 3> axes{0, 1, 2};
        do {
          std::array<Cell, 4> tet;
          tet[0] = {i, j, k};
          for (int s = 0; s < 3; ++s) tet[s + 1] = tet[s], ++tet[s + 1][axes[s]];
          const bool odd = (axes[0] > axes[1]) != ((axes[1] > axes[2]) != (axes[0] > axes[2]));
          if (odd) std::swap(tet[1], tet[2]);
          tets.push_back(tet);
          for (const Cell& corner : tet) number[corner];
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  for (auto& [corner, index] : number) {
    index = static_cast<Index>(mesh.points.size());
    mesh.points.push_back(origin + size * Eigen::Vector3d(corner[0], corner[1], corner[2]));
  }
  for (const auto& tet : tets)
    mesh.tets.push_back({number[tet[0]], number[tet[1]], number[tet[2]], number[tet[3]]});
  return mesh;
}

/// Adds the second mesh's points and tetrahedra; shares nothing.
inline TetMesh together(TetMesh mesh, const TetMesh& more) {
  const auto shift = static_cast<Index>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), more.points.begin(), more.points.end());
  for (auto tet : more.tets) {
    for (Index& v : tet) v += shift;
    mesh.tets.push_back(tet);
  }
  return mesh;
}

inline Index point_at(const TetMesh& mesh, const Eigen::Vector3d& place) {
  return static_cast<Index>(std::find(mesh.points.begin(), mesh.points.end(), place) - mesh.points.begin());
}

inline std::vector<Index> tets_at(const TetMesh& mesh, Index vertex) {
  std::vector<Index> found;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    if (std::count(mesh.tets[t].begin(), mesh.tets[t].end(), vertex)) found.push_back(static_cast<Index>(t));
  return found;
}

/// The faces of one tetrahedron, oriented outward, as a surface of the mesh's used points.
inline TriangleSurface boundary_surface(const TetMesh& mesh) {
  std::map<std::array<Index, 3>, std::vector<std::array<Index, 3>>> faces;
  for (const auto& tet : mesh.tets)
    for (const auto& [a, b, c] : {std::array{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}) {
      const std::array<Index, 3> face{tet[a], tet[b], tet[c]};
      std::array<Index, 3> key = face;
      std::sort(key.begin(), key.end());
      faces[key].push_back(face);
    }
  TriangleSurface surface;
  std::map<Index, Index> number;
  for (const auto& [key, sides] : faces) {
    if (sides.size() != 1) continue;
    std::array<Index, 3> triangle = sides[0];
    for (Index& v : triangle) {
      const auto [at, added] = number.try_emplace(v, static_cast<Index>(surface.vertices.size()));
      if (added) surface.vertices.push_back(mesh.points[v]);
      v = at->second;
    }
    surface.triangles.push_back(triangle);
  }
  return surface;
}

inline TriangleSurface together(TriangleSurface surface, const TriangleSurface& more) {
  const auto shift = static_cast<Index>(surface.vertices.size());
  surface.vertices.insert(surface.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (auto t : more.triangles) surface.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return surface;
}

inline TriangleSurface flipped(TriangleSurface surface) {
  for (auto& t : surface.triangles) std::swap(t[1], t[2]);
  return surface;
}

/// An axis-parallel box of 12 triangles.
inline TriangleSurface box_surface(Eigen::Vector3d low, double size) {
  return boundary_surface(lattice_mesh({1, 1, 1}, {}, low, size));
}

}  // namespace tetproof::test
