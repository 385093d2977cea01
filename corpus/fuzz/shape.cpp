// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/fuzz/shape.hpp"

#include <cmath>

#include "corpus/exact/exact_integers.hpp"

namespace tetproof::corpus {
namespace {

// The double nearest to x / 6 * 2^exponent, ties to even. The result must not be subnormal.
double sixth(Integer x, int exponent) {
  if (x == 0) return 0;
  const bool negative = x < 0;
  if (negative) x = -x;
  const int room = 64;  // bits below the result's last one; a remainder of the division sets the lowest
  const int shift = std::max(0, 64 + room - static_cast<int>(msb(x)));
  x <<= shift;
  const Integer quotient = x / 6;
  bool below = quotient * 6 != x;
  const int drop = static_cast<int>(msb(quotient)) - 53;
  const auto bits = static_cast<std::uint64_t>(quotient >> drop);  // 54 of them
  below = below || (Integer(bits) << drop) != quotient;
  std::uint64_t rounded = bits >> 1;
  if (bits % 2 == 1 && (below || rounded % 2 == 1)) ++rounded;
  const double value = std::ldexp(static_cast<double>(rounded), exponent + drop + 1 - shift);
  return negative ? -value : value;
}

}  // namespace

void append(TriangleSurface& surface, const TriangleSurface& part, const Eigen::Vector3d& shift,
            bool inward) {
  const Index first = static_cast<Index>(surface.vertices.size());
  for (const Eigen::Vector3d& v : part.vertices) surface.vertices.push_back(v + shift);
  for (auto [a, b, c] : part.triangles) {
    if (inward) std::swap(b, c);
    surface.triangles.push_back({first + a, first + b, first + c});
  }
}

TriangleSurface box_surface(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  TriangleSurface box;
  for (int corner = 0; corner < 8; ++corner)
    box.vertices.emplace_back(corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1],
                              corner & 4 ? high[2] : low[2]);
  for (const auto& [a, b, c, d] : {std::array<Index, 4>{0, 2, 3, 1},
                                   {4, 5, 7, 6},
                                   {0, 1, 5, 4},
                                   {2, 6, 7, 3},
                                   {0, 4, 6, 2},
                                   {1, 3, 7, 5}}) {
    box.triangles.push_back({a, b, c});
    box.triangles.push_back({a, c, d});
  }
  return box;
}

Box bounding_box(const TriangleSurface& surface) {
  Box box{surface.vertices.at(0), surface.vertices.at(0)};
  for (const Eigen::Vector3d& v : surface.vertices) {
    box.low = box.low.cwiseMin(v);
    box.high = box.high.cwiseMax(v);
  }
  return box;
}

double enclosed_volume(const TriangleSurface& surface) {
  const int unit = last_bit(surface.vertices);
  std::vector<IntegerPoint> points;
  points.reserve(surface.vertices.size());
  for (const Eigen::Vector3d& v : surface.vertices) points.push_back(integers(v, unit));
  Integer six_times = 0;
  for (const auto& [a, b, c] : surface.triangles)
    six_times += dot(points[a] - points[0], cross(points[b] - points[0], points[c] - points[0]));
  return sixth(six_times, 3 * unit);
}

Index Collector::vertex(const Eigen::Vector3d& p) {
  // Adding 0 makes a negative zero positive.
  const std::array<double, 3> key{p[0] + 0.0, p[1] + 0.0, p[2] + 0.0};
  const auto [entry, fresh] = numbers_.try_emplace(key, static_cast<Index>(surface_.vertices.size()));
  if (fresh) surface_.vertices.emplace_back(key[0], key[1], key[2]);
  return entry->second;
}

}  // namespace tetproof::corpus
