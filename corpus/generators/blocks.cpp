// SPDX-License-Identifier: GPL-3.0-or-later
// The generators of bodies with axis-parallel faces. They test surfaces that lie in lattice planes, are
// thinner than a cell, or have a narrow neck.
#include <algorithm>
#include <cmath>

#include "corpus/generators/cells.hpp"
#include "corpus/generators/generators.hpp"
#include "corpus/generators/random.hpp"

namespace tetproof::corpus {
namespace {

// The planes origin + h i. They are exact if h and the origin have few digits; the planes of a lattice then
// are, too.
std::vector<double> planes(const Values& values, const char* origin, std::vector<double> at) {
  for (double& x : at) x = values[origin] + values["h"] * x;
  for (std::size_t i = 1; i < at.size(); ++i)
    if (!(at[i - 1] < at[i])) values.refuse("h: so small beside the origin that planes coincide");
  return at;
}

std::vector<double> whole(int cells) {
  std::vector<double> at;
  for (int i = 0; i <= cells; ++i) at.push_back(i);
  return at;
}

CellBody block(const Values& values, const std::vector<double>& x, const std::vector<double>& y,
               const std::vector<double>& z, bool full) {
  return {planes(values, "x", x), planes(values, "y", y), planes(values, "z", z), full};
}

int integer(const Values& values, const char* key) {
  return static_cast<int>(values[key]);
}

CellBody box(const Values& values) {
  std::array<std::vector<double>, 3> at{
      {{values["x0"], values["x1"]}, {values["y0"], values["y1"]}, {values["z0"], values["z1"]}}};
  for (int axis = 0; axis < 3; ++axis) {
    const double a = at[axis][0], b = at[axis][1];
    // there must be room for n + 1 different planes in spite of rounding
    if (!(b - a > 4e-16 * values["n"] * std::max(std::abs(a), std::abs(b))))
      values.refuse(std::string("expected ") + "xyz"[axis] + "0 below " + "xyz"[axis] + "1");
  }
  return {at[0], at[1], at[2], true};
}

CellBody groove(const Values& values) {
  const int m = integer(values, "m"), width = integer(values, "width"), depth = integer(values, "depth");
  if (width > m - 2) values.refuse("width: expected at most m - 2");
  if (depth > m - 1) values.refuse("depth: expected at most m - 1");
  CellBody body = block(values, whole(m), whole(m), whole(m), true);
  for (int i = 0; i < width; ++i)
    for (int j = 0; j < m; ++j)
      for (int k = 0; k < depth; ++k) body.at((m - width) / 2 + i, j, m - 1 - k) = false;
  return body;
}

CellBody terrain(const Values& values) {
  const int m = integer(values, "m");
  Random random(static_cast<std::uint64_t>(values["seed"]));
  std::vector<int> height(static_cast<std::size_t>(m) * m);
  for (int& h : height) h = 1 + random.below(m);
  // Where two diagonally adjacent columns are both higher than their two common neighbours, they would meet
  // along an edge only, and the surface would not be a manifold. Then one of the neighbours is raised.
  const auto raise = [&](int& a, int& b, int c, int d) {
    if (std::max(a, b) >= std::min(c, d)) return false;
    (a > b ? a : b) = std::min(c, d);
    return true;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (int j = 0; j + 1 < m; ++j)
      for (int i = 0; i + 1 < m; ++i) {
        int &a = height[j * m + i], &b = height[j * m + i + 1], &c = height[(j + 1) * m + i],
            &d = height[(j + 1) * m + i + 1];
        if (raise(a, d, b, c) || raise(b, c, a, d)) changed = true;
      }
  }
  CellBody body = block(values, whole(m), whole(m), whole(m), false);
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < m; ++i)
      for (int k = 0; k < height[j * m + i]; ++k) body.at(i, j, k) = true;
  return body;
}

CellBody hollow(const Values& values) {
  const double m = values["m"], wall = values["wall"];
  if (!(2 * wall < m)) values.refuse("wall: expected less than m / 2");
  const std::vector<double> at{0, wall, m - wall, m};
  CellBody body = block(values, at, at, at, true);
  body.at(1, 1, 1) = false;
  return body;
}

CellBody bottle(const Values& values) {
  const double m = values["m"], wall = values["wall"], neck = values["neck"];
  if (!(2 * wall + neck < m)) values.refuse("neck: expected less than m - 2 wall");
  const std::vector<double> across{0, wall, (m - neck) / 2, (m + neck) / 2, m - wall, m};
  CellBody body = block(values, across, across, {0, wall, m - wall, m}, true);
  for (int i = 1; i <= 3; ++i)
    for (int j = 1; j <= 3; ++j) body.at(i, j, 1) = false;
  body.at(2, 2, 2) = false;
  return body;
}

CellBody pair(const Values& values) {
  const double m = values["m"], gap = values["gap"];
  CellBody body = block(values, {0, m, m + gap, 2 * m + gap}, {0, m}, {0, m}, true);
  body.at(1, 0, 0) = false;
  return body;
}

template <CellBody make_body(const Values&)>
TriangleSurface make(const Values& values) {
  const CellBody body = make_body(values);
  const double n = values["n"];
  const TriangleSurface plain = boundary(body);
  if (static_cast<double>(plain.triangles.size()) * n * n > most_triangles)
    values.refuse("n: more than 2e7 triangles");
  return n == 1 ? plain : boundary(body, static_cast<int>(n));
}

template <CellBody make_body(const Values&)>
std::optional<double> volume_of(const Values& values) {
  return volume(make_body(values));
}

std::vector<Parameter> in_lattice(std::vector<Parameter> own) {
  for (const char* key : {"x", "y", "z"})
    own.push_back({key, 0, -1e12, 1e12, "first corner; a vertex of the lattice"});
  own.push_back({"h", 1, 1e-9, 1e9, "the lattice's cell size"});
  own.push_back({"n", 1, 1, 1000,
                 "each square between neighbouring planes is cut into n x n squares of two triangles",
                 Kind::integer});
  return own;
}

template <CellBody make_body(const Values&)>
Generator generator(const char* name, const char* meaning, const std::vector<Parameter>& own,
                    const char* volume_text) {
  return {.name = name,
          .meaning = meaning,
          .parameters = own,
          .volume_text = volume_text,
          .make = make<make_body>,
          .volume = volume_of<make_body>};
}

}  // namespace

std::vector<Generator> block_generators() {
  return {
      generator<box>("box", "an axis-parallel box, 12 n^2 triangles",
                     {{"x0", 0, -1e12, 1e12, "lower corner"},
                      {"y0", 0, -1e12, 1e12, "lower corner"},
                      {"z0", 0, -1e12, 1e12, "lower corner"},
                      {"x1", 1, -1e12, 1e12, "upper corner"},
                      {"y1", 1, -1e12, 1e12, "upper corner"},
                      {"z1", 1, -1e12, 1e12, "upper corner"},
                      {"n", 1, 1, 1290, "squares along each side", Kind::integer}},
                     "(x1 - x0) (y1 - y0) (z1 - z0)"),
      generator<groove>("groove",
                        "a cube of m cells with a groove along y in its top; all vertices of the groove's "
                        "cells are on the surface",
                        in_lattice({{"m", 6, 3, 200, "cells along each side", Kind::integer},
                                    {"width", 1, 1, 198, "cells across the groove", Kind::integer},
                                    {"depth", 2, 1, 199, "cells down the groove", Kind::integer}}),
                        "h^3 (m^3 - width depth m)"),
      generator<terrain>(
          "terrain",
          "m x m columns of 1 to m cells, at random: steps, pits and coplanar faces in lattice planes",
          in_lattice({{"seed", 1, 0, 9007199254740992, "seed of the random numbers", Kind::integer},
                      {"m", 6, 1, 200, "columns along each side", Kind::integer}}),
          "h^3 times the number of cells"),
      generator<hollow>("hollow", "a cube with a cubic cavity: a shell that can be very thin",
                        in_lattice({{"m", 6, 1e-3, 1e3, "side of the cube, in cells"},
                                    {"wall", 0.1, 1e-6, 500, "thickness of the wall, in cells"}}),
                        "h^3 (m^3 - (m - 2 wall)^3)"),
      generator<bottle>("bottle",
                        "a cube with a cubic hollow that is open to the outside through a square neck",
                        in_lattice({{"m", 6, 1e-3, 1e3, "side of the cube, in cells"},
                                    {"wall", 1, 1e-6, 500, "thickness of the wall, in cells"},
                                    {"neck", 0.5, 1e-6, 1e3, "width of the neck, in cells"}}),
                        "h^3 (m^3 - (m - 2 wall)^3 - neck^2 wall)"),
      generator<pair>("pair", "two cubes side by side along x: two components",
                      in_lattice({{"m", 3, 1e-3, 1e3, "side of each cube, in cells"},
                                  {"gap", 0.5, 1e-6, 1e3, "between them, in cells"}}),
                      "2 h^3 m^3"),
  };
}

}  // namespace tetproof::corpus
