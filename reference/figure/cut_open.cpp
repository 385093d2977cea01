// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/figure/cut_open.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace tetproof::reference {

CutOpen cut_open(const TetMesh& mesh, const Plane& plane) {
  const PlaneSides sides(mesh.points, plane);
  CutOpen open;
  std::vector<bool> is_left(mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    is_left[t] = std::all_of(mesh.tets[t].begin(), mesh.tets[t].end(),
                             [&](Index i) { return sides[i] <= 0 && mesh.points[i].allFinite(); });
    if (is_left[t]) open.tets.push_back(static_cast<Index>(t));
  }

  // Each face of the mesh, by its points in ascending order; its tetrahedra then stand side by side.
  struct Face {
    std::array<Index, 3> names;
    Index tet;
    int number;
  };
  std::vector<Face> faces;
  faces.reserve(4 * mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      const auto& [a, b, c] = tet_faces[f];
      Face face{{mesh.tets[t][a], mesh.tets[t][b], mesh.tets[t][c]}, static_cast<Index>(t), f};
      std::sort(face.names.begin(), face.names.end());
      faces.push_back(face);
    }
  std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
    return a.names != b.names ? a.names < b.names : std::pair(a.tet, a.number) < std::pair(b.tet, b.number);
  });
  std::vector<std::pair<Face, bool>> seen;  // with is_cut
  for (std::size_t i = 0, end = 0; i < faces.size(); i = end) {
    std::size_t left = 0, one = i;
    for (end = i; end < faces.size() && faces[end].names == faces[i].names; ++end)
      if (is_left[faces[end].tet]) ++left, one = end;
    if (left == 1) seen.emplace_back(faces[one], end - i > 1);
  }
  std::sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first.tet, a.first.number) < std::pair(b.first.tet, b.first.number);
  });
  for (const auto& [face, is_cut] : seen) {
    const auto& tet = mesh.tets[face.tet];
    std::array<Index, 3> corners;
    for (int k = 0; k < 3; ++k) corners[k] = tet[tet_faces[face.number][k]];
    const auto& [a, b, c, d] = tet;
    const Eigen::Vector3d& from = mesh.points[a];
    if ((mesh.points[b] - from).cross(mesh.points[c] - from).dot(mesh.points[d] - from) < 0)
      std::swap(corners[1], corners[2]);
    open.faces.push_back({face.tet, corners, is_cut});
  }
  return open;
}

}  // namespace tetproof::reference
