// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/adaptation/curvature.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <optional>

#include "reference/engine/first_grid/closest_point.hpp"

namespace tetproof::reference {
namespace {

using Points = std::vector<Eigen::Vector3d>;

// The triangles around each vertex.
std::vector<std::vector<Index>> stars_of(const TriangleSurface& surface) {
  std::vector<std::vector<Index>> stars(surface.vertices.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const Index v : surface.triangles[t]) stars[v].push_back(static_cast<Index>(t));
  return stars;
}

// The sum of vectors, added in an order that does not depend on the numbering of the vertices.
Eigen::Vector3d sum(Points vectors) {
  std::sort(vectors.begin(), vectors.end(), lexicographically_less);
  Eigen::Vector3d total = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : vectors) total += v;
  return total;
}

class Fit {
 public:
  explicit Fit(const TriangleSurface& surface) : surface_(surface), stars_(stars_of(surface)) {}

  double absolute_curvature(Index v) const {
    const Eigen::Vector3d normal = sum(normals(v)).normalized();
    if (!normal.allFinite() || normal.isZero()) return 0;
    std::vector<Index> ring = neighbours({v}, v);
    if (const auto first = fit(v, normal, ring)) return *first;
    const std::vector<Index> second = neighbours(ring, v);
    ring.insert(ring.end(), second.begin(), second.end());
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    return fit(v, normal, ring).value_or(0);
  }

 private:
  Points normals(Index v) const {
    Points found;
    for (const Index t : stars_[v]) {
      const auto& [a, b, c] = surface_.triangles[t];
      const auto& x = surface_.vertices;
      found.push_back((x[b] - x[a]).cross(x[c] - x[a]).normalized());
    }
    return found;
  }

  // The vertices that share a triangle with a vertex of `of`, except `v`.
  std::vector<Index> neighbours(const std::vector<Index>& of, Index v) const {
    std::vector<Index> found;
    for (const Index w : of)
      for (const Index t : stars_[w])
        for (const Index n : surface_.triangles[t])
          if (n != v && n != w) found.push_back(n);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  // |k1| + |k2|, fitted to the vertices of `ring`; nothing if they do not determine the fit.
  std::optional<double> fit(Index v, const Eigen::Vector3d& normal, const std::vector<Index>& ring) const {
    Points offsets;
    for (const Index n : ring) offsets.push_back(surface_.vertices[n] - surface_.vertices[v]);
    std::sort(offsets.begin(), offsets.end(), lexicographically_less);
    const Eigen::Vector3d u = normal.unitOrthogonal(), w = normal.cross(u);
    double scale = 0;  // makes the entries of the columns numbers around 1
    for (const Eigen::Vector3d& o : offsets) scale = std::max(scale, o.norm());
    Eigen::MatrixX3d columns(offsets.size(), 3);  // of c20, c11, c02
    Eigen::VectorXd heights(offsets.size());
    for (std::size_t i = 0; i < offsets.size(); ++i) {
      const Eigen::Vector3d o = offsets[i] / scale;
      const double ou = o.dot(u), ow = o.dot(w);
      columns.row(static_cast<Eigen::Index>(i)) << ou * ou / 2, ou * ow, ow * ow / 2;
      heights[static_cast<Eigen::Index>(i)] = o.dot(normal);
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixX3d> qr(columns);
    qr.setThreshold(1e-9);
    if (qr.rank() < 3) return std::nullopt;
    const Eigen::Vector3d c = qr.solve(heights) / scale;
    const Eigen::Matrix2d second = (Eigen::Matrix2d() << c[0], c[1], c[1], c[2]).finished();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(second, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .cwiseAbs()
        .sum();
  }

  const TriangleSurface& surface_;
  std::vector<std::vector<Index>> stars_;
};

}  // namespace

std::vector<double> absolute_curvatures(const TriangleSurface& surface) {
  const Fit fit(surface);
  std::vector<double> curvatures(surface.vertices.size());
  tbb::parallel_for(std::size_t{0}, curvatures.size(),
                    [&](std::size_t v) { curvatures[v] = fit.absolute_curvature(static_cast<Index>(v)); });
  return curvatures;
}

double outlier_ratio(std::vector<double> curvatures) {
  if (curvatures.empty()) return 1;
  const auto at = curvatures.begin() + static_cast<std::ptrdiff_t>((curvatures.size() - 1) * 99 / 100);
  std::nth_element(curvatures.begin(), at, curvatures.end());
  const double largest = *std::max_element(at, curvatures.end());
  if (largest == 0) return 1;
  return *at > 0 ? largest / *at : std::numeric_limits<double>::infinity();
}

}  // namespace tetproof::reference
