// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/mesh/quality.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <Eigen/Geometry>
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

struct Tallies {
  std::int64_t tets = 0;
  Tally<degrees.size()> dihedral;
  Tally<parts.size()> solid;
  Tally<ratios.size()> aspect;

  void add(const std::array<Eigen::Vector3d, 4>& p) {
    const double det = (p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0]);  // six volumes
    if (!(det > 0) || !std::isfinite(det)) return;
    ++tets;
    std::array<Eigen::Vector3d, 4> normal;  // outward; their length is twice the face's area
    double normals = 0, longest = 0;
    for (int f = 0; f < 4; ++f) {
      const auto& [a, b, c] = tet_faces[f];
      normal[f] = (p[b] - p[a]).cross(p[c] - p[a]);
      normals += normal[f].norm();
    }
    // Faces i and j are opposite to vertices i and j. They share the edge between the other two vertices:
    // |n_i x n_j| = det |edge|.
    std::array<double, 4> around{};  // sums of the dihedral angles at each vertex
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) {
        const int k = i != 0 ? 0 : j != 1 ? 1 : 2, l = 6 - i - j - k;
        const double length = (p[k] - p[l]).norm();
        longest = std::max(longest, length);
        const double angle = std::atan2(det * length, -normal[i].dot(normal[j]));
        around[k] += angle;
        around[l] += angle;
        dihedral.add(angle * (180 / std::numbers::pi), degrees);
      }
    for (const double sum : around)
      solid.add(std::max(0.0, (sum - std::numbers::pi) / (4 * std::numbers::pi)), parts);
    // The inradius is 3 V / (sum of areas) = det / normals.
    aspect.add(longest * normals / (det * (2 * std::sqrt(6.0))), ratios);
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
