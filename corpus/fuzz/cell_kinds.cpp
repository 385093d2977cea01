// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of random surfaces that are the boundary of axis-parallel cells: voxels, sponges, plates with holes,
// combs, spirals.
//
// The boundary of cells between distinct planes is embedded wherever it is a manifold: around each corner of
// the cells, the solid ones are connected through common sides, and so are the empty ones.
#include <algorithm>

#include "corpus/fuzz/cell_topology.hpp"
#include "corpus/fuzz/kind.hpp"

namespace tetproof::corpus {
namespace {

std::vector<double> planes(int cells, double width) {
  std::vector<double> at;
  for (int i = 0; i <= cells; ++i) at.push_back(i * width);
  return at;
}

// Planes with the distances odd, even, odd, even, ...
std::vector<double> alternating(int cells, double odd, double even) {
  std::vector<double> at{0};
  for (int i = 0; i < cells; ++i) at.push_back(at.back() + (i % 2 == 0 ? odd : even));
  return at;
}

Shape voxels(const Numbers& values) {
  const int n = values.integer("n");
  CellBody body(planes(n, 1), planes(n, 1), planes(n, values["h"]), false);
  Random random = values.random();
  for (char& cell : body.solid) cell = random.unit() < values["p"];
  body.at(0, 0, 0) = true;
  fill_to_manifold(body);
  return cell_shape(body);
}

Shape menger(const Numbers& values) {
  const int level = values.integer("level");
  int n = 1;
  for (int k = 0; k < level; ++k) n *= 3;
  CellBody body(planes(n, 1), planes(n, 1), planes(n, 1), true);
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        for (int size = 1; size < n; size *= 3) {
          const auto middle = [size](int index) { return index / size % 3 == 1; };
          if (middle(i) + middle(j) + middle(k) >= 2) body.at(i, j, k) = false;
        }
  return cell_shape(body);
}

Shape holes(const Numbers& values) {
  const int n = values.integer("n"), m = values.integer("m");
  CellBody body(alternating(2 * n + 1, values["wall"], 1), alternating(2 * m + 1, values["wall"], 1),
                {0, values["h"]}, true);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) body.at(2 * i + 1, 2 * j + 1, 0) = false;
  return cell_shape(body);
}

Shape comb(const Numbers& values) {
  const int teeth = values.integer("teeth");
  CellBody body(alternating(2 * teeth - 1, 1, values["gap"]), {0, 1}, {0, 1, 1 + values["h"]}, true);
  for (int i = 0; i + 1 < teeth; ++i) body.at(2 * i + 1, 0, 1) = false;
  return cell_shape(body);
}

Shape spiral(const Numbers& values) {
  const int n = 2 * values.integer("n") + 1;
  CellBody body(alternating(n, 1, values["gap"]), alternating(n, 1, values["gap"]), {0, values["h"]}, false);
  const int step[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  int x = 0, y = 0, length = n - 1;
  body.at(0, 0, 0) = true;
  for (int arm = 0; length > 0; ++arm) {
    for (int k = 0; k < length; ++k) {
      x += step[arm % 4][0], y += step[arm % 4][1];
      body.at(x, y, 0) = true;
    }
    if (arm >= 2 && arm % 2 == 0) length -= 2;  // after the first three arms each length comes twice
  }
  return cell_shape(body);
}

std::vector<FuzzParameter> voxel_parameters(double low, double high, const FuzzParameter& h) {
  return {seed_parameter(),
          {"n", Draw::integer, 1, 40, low, high, 1, "cells along each axis"},
          {"p", Draw::share, 0, 1, 0.2, 0.8, 0.5, "share of solid cells, before some are filled"},
          h};
}

}  // namespace

std::vector<FuzzKind> cell_kinds() {
  const FuzzParameter height{"h", Draw::length, 1e-9, 1e6, 1e-3, 10, 1, "height"};
  return {
      {"thin-voxel", "voxels, squashed along z", "many thin walls, coplanar and cospherical points",
       voxel_parameters(2, 4,
                        {"h", Draw::length, 1e-9, 1, 1e-6, 0.5, 0.5, "height of a cell; its width is 1"}),
       voxels},
      {"big-voxel", "many voxels", "coplanar and cospherical points, cavities, handles",
       voxel_parameters(4, 7, {"h", Draw::length, 1e-9, 1e6, 1, 1, 1, "height of a cell; its width is 1"}),
       voxels},
      {"menger",
       "a Menger sponge",
       "many handles",
       {{"level", Draw::integer, 0, 3, 1, 2, 0, "how often it is refined: 1: 144 triangles, genus 5"}},
       menger},
      {"holes",
       "a plate with n x m square holes",
       "handles, thin bridges, coplanar faces",
       {{"n", Draw::integer, 0, 50, 1, 4, 0, "holes along x"},
        {"m", Draw::integer, 0, 50, 1, 3, 0, "holes along y"},
        {"wall", Draw::length, 1e-9, 1e3, 1e-6, 1, 1, "between two holes, which are 1 wide"},
        height},
       holes},
      {"comb",
       "a bar with teeth",
       "slits that are far narrower than the faces beside them",
       {{"teeth", Draw::integer, 1, 1000, 2, 12, 1, "teeth, 1 wide"},
        {"gap", Draw::length, 1e-9, 1e3, 1e-7, 1, 1, "between two teeth"},
        {"h", Draw::length, 1e-9, 1e6, 1e-3, 100, 1, "length of the teeth"}},
       comb},
      {"spiral",
       "an angular spiral of walls",
       "a long slit that winds; the two sides of it belong to one body",
       {{"n", Draw::integer, 1, 30, 1, 5, 1, "walls from the middle to the outside"},
        {"gap", Draw::length, 1e-9, 1e3, 1e-6, 1, 1, "between two walls, which are 1 thick"},
        height},
       spiral},
  };
}

}  // namespace tetproof::corpus
