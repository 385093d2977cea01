// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/mesh/quality.hpp"

#include <CGAL/Mpzf.h>
#include <CGAL/number_utils.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace tetproof::verify {
namespace {

constexpr std::array degrees{0.,  10.,  20.,  30.,  40.,  50.,  60.,  70.,  80.,
                             90., 100., 110., 120., 130., 140., 150., 160., 170.};
constexpr std::array parts{0.,   1e-6, 1e-5, 1e-4, 1e-3, 2e-3, 5e-3, 0.01,
                           0.02, 0.03, 0.04, 0.05, 0.06, 0.08, 0.1,  0.2};
constexpr std::array ratios{1., 1.5, 2., 2.5, 3., 4., 6., 10., 15., 40., 100., 1e3, 1e4, 1e6};

// Holds counts and extremes only, so that the order of addition does not matter.
template <std::size_t N>
struct Tally {
  double min = std::numeric_limits<double>::infinity(), max = -min;
  std::array<std::int64_t, N> counts{};

  void add(double value, const std::array<double, N>& edges) {
    min = std::min(min, value);
    max = std::max(max, value);
    std::size_t bin = 0;
    for (std::size_t i = 1; i < N; ++i) bin += value >= edges[i];
    ++counts[bin];
  }
  void join(const Tally& other) {
    min = std::min(min, other.min);
    max = std::max(max, other.max);
    for (std::size_t i = 0; i < N; ++i) counts[i] += other.counts[i];
  }
  Distribution distribution(const std::array<double, N>& edges) const {
    return {min, max, {edges.begin(), edges.end()}, {counts.begin(), counts.end()}};
  }
};

// A tetrahedron in units of some power of two, each number with a small relative error.
struct Lengths {
  double six_volumes = 0;
  std::array<double, 4> normal{};                      // of the face opposite to each vertex: twice its area
  std::array<std::array<double, 4>, 4> normals_dot{};  // of two outward normals of these lengths
  std::array<std::array<double, 4>, 4> edge{};         // from vertex to vertex
  std::array<std::array<double, 4>, 4> dot_at{};  // [v][i]: of the edges from v to the two that are not i
};

// The two of the numbers 0 to 3 that are not i and j, i < j.
std::array<int, 2> others(int i, int j) {
  const int k = i != 0 ? 0 : j != 1 ? 1 : 2;
  return {k, 6 - i - j - k};
}

template <class Number>
using Vector = std::array<Number, 3>;

template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Number>
Lengths measure_in(const std::array<Eigen::Vector3d, 4>& points) {
  const auto from_to = [&](int i, int j) {
    Vector<Number> way;
    for (int axis = 0; axis < 3; ++axis) way[axis] = Number(points[j][axis]) - Number(points[i][axis]);
    return way;
  };
  Lengths tet;
  std::array<Vector<Number>, 4> normal;
  for (int f = 0; f < 4; ++f) {
    const auto& [a, b, c] = tet_faces[f];
    normal[f] = cross(from_to(a, b), from_to(a, c));
    tet.normal[f] = std::sqrt(CGAL::to_double(dot(normal[f], normal[f])));
  }
  tet.six_volumes = CGAL::to_double(dot(normal[0], from_to(0, tet_faces[0][0])));
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const Vector<Number> edge = from_to(i, j);
      tet.edge[i][j] = tet.edge[j][i] = std::sqrt(CGAL::to_double(dot(edge, edge)));
      tet.normals_dot[i][j] = CGAL::to_double(dot(normal[i], normal[j]));
      const auto [k, l] = others(i, j);
      tet.dot_at[i][j] = CGAL::to_double(dot(from_to(i, k), from_to(i, l)));
      tet.dot_at[j][i] = CGAL::to_double(dot(from_to(j, k), from_to(j, l)));
    }
  return tet;
}

// Whether rounding leaves the volume and the normals a relative error below 1e-11. With u = 2^-53, each
// coordinate of an edge is off by u of itself, so the volume by 8 u of the sum of the sizes of the products,
// and a normal by 7 u of the product of its edges.
bool is_accurate(const std::array<Eigen::Vector3d, 4>& p, const Lengths& tet) {
  const auto& [a, b, c] = tet_faces[0];
  const Eigen::Vector3d x = (p[a] - p[0]).cwiseAbs(), y = (p[b] - p[a]).cwiseAbs(),
                        z = (p[c] - p[a]).cwiseAbs();
  const double products = x[0] * (y[1] * z[2] + y[2] * z[1]) + x[1] * (y[2] * z[0] + y[0] * z[2]) +
                          x[2] * (y[0] * z[1] + y[1] * z[0]);
  if (!(tet.six_volumes > 0x1p-13 * products)) return false;
  for (int f = 0; f < 4; ++f) {
    const auto& [i, j, k] = tet_faces[f];
    if (!(tet.normal[f] > 0x1p-13 * tet.edge[i][j] * tet.edge[i][k])) return false;
  }
  return true;
}

// Exact where doubles lose too much.
Lengths measure(std::array<Eigen::Vector3d, 4> p) {
  double largest = 0;
  for (int i = 1; i < 4; ++i) largest = std::max(largest, (p[i] / 2 - p[0] / 2).lpNorm<Eigen::Infinity>());
  if (!(largest > 0) || !std::isfinite(largest)) return {};
  // Products of up to four lengths must be in the range of doubles. A power of two changes no digit.
  if (const int exponent = std::ilogb(largest); std::abs(exponent) > 200)
    for (Eigen::Vector3d& v : p)
      for (double& x : v) x = std::scalbn(x, -exponent);
  const Lengths tet = measure_in<double>(p);
  if (is_accurate(p, tet)) return tet;
  for (const Eigen::Vector3d& v : p)
    if (!v.allFinite()) return {};
  return measure_in<CGAL::Mpzf>(p);
}

struct Tallies {
  std::int64_t tets = 0;
  Tally<degrees.size()> dihedral;
  Tally<parts.size()> solid;
  Tally<ratios.size()> aspect;

  void add(const std::array<Eigen::Vector3d, 4>& p) {
    const Lengths tet = measure(p);
    if (!(tet.six_volumes > 0)) return;
    ++tets;
    double normals = 0, longest = 0;
    for (const double normal : tet.normal) normals += normal;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) {
        const auto [k, l] = others(i, j);
        longest = std::max(longest, tet.edge[k][l]);
        // Faces i and j are opposite to vertices i and j and share the edge k l: |n_i x n_j| = 6 V |edge|.
        const double angle = std::atan2(tet.six_volumes * tet.edge[k][l], -tet.normals_dot[i][j]);
        dihedral.add(angle * (180 / std::numbers::pi), degrees);
      }
    // Oosterom and Strackee, The solid angle of a plane triangle, IEEE Trans. Biomed. Eng. 30 (1983) 125-126:
    // tan(angle / 2) = 6 V / (a b c + (a . b) c + (a . c) b + (b . c) a). The numerator is what makes a small
    // angle small, and it has not cancelled.
    for (int v = 0; v < 4; ++v) {
      const int i = (v + 1) % 4, j = (v + 2) % 4, k = (v + 3) % 4;
      const double a = tet.edge[v][i], b = tet.edge[v][j], c = tet.edge[v][k];
      const double below = a * b * c + tet.dot_at[v][k] * c + tet.dot_at[v][j] * b + tet.dot_at[v][i] * a;
      solid.add(2 * std::atan2(tet.six_volumes, below) / (4 * std::numbers::pi), parts);
    }
    // The inradius is 3 V / (sum of areas) = 6 V / normals.
    aspect.add(longest * normals / (tet.six_volumes * (2 * std::sqrt(6.0))), ratios);
  }
  void join(const Tallies& other) {
    tets += other.tets;
    dihedral.join(other.dihedral);
    solid.join(other.solid);
    aspect.join(other.aspect);
  }
};

}  // namespace

Quality measure_quality(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded) {
  const Tallies all = tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, mesh.tets.size(), 8192), Tallies{},
      [&](const tbb::blocked_range<std::size_t>& range, Tallies tallies) {
        for (std::size_t t = range.begin(); t < range.end(); ++t) {
          if (!excluded.empty() && excluded[t]) continue;
          const auto& [a, b, c, d] = mesh.tets[t];
          tallies.add({mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]});
        }
        return tallies;
      },
      [](Tallies x, const Tallies& y) {
        x.join(y);
        return x;
      });
  return {all.tets, all.dihedral.distribution(degrees), all.solid.distribution(parts),
          all.aspect.distribution(ratios)};
}

}  // namespace tetproof::verify
