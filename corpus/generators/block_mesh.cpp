// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/block_mesh.hpp"

#include <utility>

#include "corpus/generators/random.hpp"

namespace tetproof::corpus {

TetMesh moved(TetMesh mesh, double scale, const Eigen::Vector3d& shift) {
  for (Eigen::Vector3d& p : mesh.points) p = p * scale + shift;
  return mesh;
}

TetMesh block_mesh(std::array<int, 3> cells, double jitter, std::uint64_t seed) {
  Random random(seed);
  TetMesh mesh;
  const auto number = [&](const std::array<int, 3>& c) {
    return static_cast<Index>((c[2] * (cells[1] + 1) + c[1]) * (cells[0] + 1) + c[0]);
  };
  for (int k = 0; k <= cells[2]; ++k)
    for (int j = 0; j <= cells[1]; ++j)
      for (int i = 0; i <= cells[0]; ++i) {
        Eigen::Vector3d p(i, j, k);
        if (jitter > 0)
          for (int c = 0; c < 3; ++c) p[c] += random.between(-jitter, jitter);
        mesh.points.push_back(p);
      }
  // The six ways along the axes from the lowest corner of a cell to the highest. The last three are odd
  // permutations, so their tetrahedra are turned.
  constexpr std::array<std::array<int, 3>, 6> ways{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (int k = 0; k < cells[2]; ++k)
    for (int j = 0; j < cells[1]; ++j)
      for (int i = 0; i < cells[0]; ++i)
        for (std::size_t w = 0; w < ways.size(); ++w) {
          std::array<int, 3> corner{i, j, k};
          std::array<Index, 4> tet{number(corner), 0, 0, 0};
          for (std::size_t step = 0; step < 3; ++step)
            ++corner[static_cast<std::size_t>(ways[w][step])], tet[step + 1] = number(corner);
          if (w >= 3) std::swap(tet[2], tet[3]);
          mesh.tets.push_back(tet);
        }
  return mesh;
}

TetMesh ball_mesh(int layers, double jitter, std::uint64_t seed) {
  Random random(seed);
  TetMesh mesh;
  const auto add = [&](Eigen::Vector3d p) {
    for (int c = 0; c < 3 && jitter > 0; ++c) p[c] += random.between(-jitter, jitter);
    mesh.points.push_back(p);
  };
  add({0, 0, 0});
  for (int layer = 1; layer <= layers; ++layer)
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {1.0, -1.0}) add(sign * layer * Eigen::Vector3d::Unit(axis));
  for (int octant = 0; octant < 8; ++octant) {
    // The three half axes around the octant form a left-handed system in every second octant.
    const bool odd = ((octant & 1) + (octant >> 1 & 1) + (octant >> 2 & 1)) % 2 != 0;
    const auto corner = [&](int axis, int layer) {
      return static_cast<Index>(6 * layer - 5 + 2 * axis + (octant >> axis & 1));
    };
    const auto add_tet = [&](std::array<Index, 4> tet) {
      if (odd) std::swap(tet[1], tet[2]);
      mesh.tets.push_back(tet);
    };
    add_tet({0, corner(0, 1), corner(1, 1), corner(2, 1)});
    // A prism between two layers. Each side is cut from the inner corner on the lower axis to the outer
    // corner on the higher axis.
    for (int layer = 1; layer < layers; ++layer) {
      const std::array<Index, 3> in{corner(0, layer), corner(1, layer), corner(2, layer)},
          out{corner(0, layer + 1), corner(1, layer + 1), corner(2, layer + 1)};
      add_tet({in[0], out[0], out[1], out[2]});
      add_tet({in[0], in[1], out[2], out[1]});
      add_tet({in[0], in[1], in[2], out[2]});
    }
  }
  return mesh;
}

}  // namespace tetproof::corpus
