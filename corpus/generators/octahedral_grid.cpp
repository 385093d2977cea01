// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/generators/octahedral_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetproof::corpus {

Eigen::Vector3d octahedral_direction(const Eigen::Vector2d& uv) {
  double x = uv[0], y = uv[1];
  const double z = 1 - std::abs(x) - std::abs(y);
  if (z < 0) {
    x = std::copysign(1 - std::abs(uv[1]), uv[0]);
    y = std::copysign(1 - std::abs(uv[0]), uv[1]);
  }
  const double length = std::sqrt(x * x + y * y + z * z);
  // Adding 0.0 turns -0 into 0, so that the two sides of a seam are equal.
  return {x / length + 0.0, y / length + 0.0, z / length + 0.0};
}

int octahedral_frequency(double n) {
  const int f = std::max(1, static_cast<int>(std::sqrt(n / 8)));
  return 8.0 * (f + 1) * (f + 1) - n < n - 8.0 * f * f ? f + 1 : f;
}

TriangleSurface octahedral_surface(int f, std::function<Eigen::Vector3d(const Eigen::Vector3d&)> place,
                                   double shift) {
  TriangleSurface surface;
  surface.evaluate = [place = std::move(place), shift](const Eigen::Vector2d& uv) {
    return place(octahedral_direction({uv[0] - shift, uv[1]}));
  };

  // Grid node (a,b), -f <= a,b <= f, has u = a/f, v = b/f. On the border of the square two nodes are the same
  // vertex, at its corners four.
  const int width = 2 * f + 1;
  std::vector<Index> number(static_cast<std::size_t>(width) * width, -1);
  const auto coordinate = [f, shift](int a) {
    const double x = static_cast<double>(std::abs(a)) / f;
    return std::copysign(shift == 0 ? x : (x + 32) - 32, a);
  };
  const auto uv = [&](int a, int b) { return Eigen::Vector2d(coordinate(a) + shift, coordinate(b)); };
  const auto vertex = [&](int a, int b) -> Index& {
    if (std::abs(a) == f) b = std::abs(b);
    if (std::abs(b) == f) a = std::abs(a);
    return number[static_cast<std::size_t>(b + f) * width + (a + f)];
  };
  surface.vertices.reserve(4 * static_cast<std::size_t>(f) * f + 2);
  for (int b = -f; b <= f; ++b)
    for (int a = -f; a <= f; ++a)
      if (Index& v = vertex(a, b); v < 0) {
        v = static_cast<Index>(surface.vertices.size());
        surface.vertices.push_back(surface.evaluate(uv(a, b)));
      }

  const auto add = [&](std::array<std::array<int, 2>, 3> nodes) {
    std::array<Index, 3> triangle;
    std::array<Eigen::Vector2d, 3> parameters;
    for (int k = 0; k < 3; ++k) {
      triangle[k] = vertex(nodes[k][0], nodes[k][1]);
      parameters[k] = uv(nodes[k][0], nodes[k][1]);
    }
    surface.triangles.push_back(triangle);
    surface.parameters.push_back(parameters);
  };
  surface.triangles.reserve(8 * static_cast<std::size_t>(f) * f);
  surface.parameters.reserve(8 * static_cast<std::size_t>(f) * f);
  for (int b = -f; b < f; ++b)
    for (int a = -f; a < f; ++a) {
      if ((a >= 0) == (b >= 0)) {  // the diagonal runs along |u|+|v| = const, like the equator
        add({{{a, b}, {a + 1, b}, {a, b + 1}}});
        add({{{a + 1, b}, {a + 1, b + 1}, {a, b + 1}}});
      } else {
        add({{{a, b}, {a + 1, b}, {a + 1, b + 1}}});
        add({{{a, b}, {a + 1, b + 1}, {a, b + 1}}});
      }
    }
  return surface;
}

}  // namespace tetproof::corpus
