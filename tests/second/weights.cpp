// SPDX-License-Identifier: GPL-3.0-or-later
// Step (v): eqs (3.1) to (3.3) and (3.6), curvature, and section 4's measures of quality.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/second/section3.hpp"

namespace tetproof::second {
namespace {

std::set<int> neighbours(const TriangleSurface& surface, const std::set<int>& of) {
  std::set<int> found;
  for (const auto& t : surface.triangles)
    if (of.count(t[0]) || of.count(t[1]) || of.count(t[2])) found.insert(t.begin(), t.end());
  return found;
}

// D15: the quadratic form over the plane normal to n that fits the heights of some vertices best; nothing if
// they do not determine it.
std::optional<Eigen::Matrix2d> fit(const TriangleSurface& surface, int centre, const std::set<int>& around,
                                   const Point& n) {
  const Point x = n.unitOrthogonal(), y = n.cross(x);
  Eigen::MatrixXd forms(around.size(), 3);
  Eigen::VectorXd heights(around.size());
  int row = 0;
  for (const int v : around) {
    const Point r = surface.vertices[v] - surface.vertices[centre];
    const double u = r.dot(x), w = r.dot(y);
    forms.row(row) << u * u / 2, u * w, w * w / 2;
    heights[row++] = r.dot(n);
  }
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(forms, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(1e-10);
  if (around.size() < 3 || svd.rank() < 3) return std::nullopt;
  const Eigen::Vector3d c = svd.solve(heights);
  return Eigen::Matrix2d{{c[0], c[1]}, {c[1], c[2]}};
}

// The solid angle at the first corner, as van Oosterom and Strackee have it: tan(Omega/2) = numerator /
// denominator.
std::pair<double, double> tangent_at(const Corners& t, int corner) {
  const Point a = t[(corner + 1) % 4] - t[corner], b = t[(corner + 2) % 4] - t[corner],
              c = t[(corner + 3) % 4] - t[corner];
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return {std::abs(a.dot(b.cross(c))), la * lb * lc + a.dot(b) * lc + a.dot(c) * lb + b.dot(c) * la};
}

}  // namespace

std::vector<double> absolute_curvatures(const TriangleSurface& surface, Mistake mistake) {
  std::vector<double> kappas;
  for (int v = 0; v < static_cast<int>(surface.vertices.size()); ++v) {
    Point normal(0, 0, 0);
    for (const auto& [a, b, c] : surface.triangles)
      if (a == v || b == v || c == v) {
        const Point n =
            (surface.vertices[b] - surface.vertices[a]).cross(surface.vertices[c] - surface.vertices[a]);
        normal += n.normalized();
      }
    normal.normalize();
    std::set<int> ring = neighbours(surface, {v});
    std::set<int> rings = neighbours(surface, ring);
    ring.erase(v);
    rings.erase(v);
    auto form = fit(surface, v, ring, normal);
    if (!form) form = fit(surface, v, rings, normal);
    double kappa = 0;
    if (form) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(*form);
      const auto& k = solver.eigenvalues();
      kappa = mistake == Mistake::signed_curvature ? std::abs(k[0] + k[1]) : std::abs(k[0]) + std::abs(k[1]);
    }
    kappas.push_back(kappa);
  }
  return kappas;
}

double signed_volume(const Corners& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]).dot(t[3] - t[0]) / 6;
}

std::pair<double, std::size_t> distance(const TriangleSurface& surface, const Corners& t, Mistake mistake) {
  const Point centroid = (t[0] + t[1] + t[2] + t[3]) / 4;
  double least = std::numeric_limits<double>::infinity();
  for (const Point& x : surface.vertices) least = std::min(least, (centroid - x).norm());
  std::size_t closest = surface.vertices.size();  // of those that are closest but for rounding (D15)
  for (std::size_t k = 0; k < surface.vertices.size(); ++k)
    if ((centroid - surface.vertices[k]).norm() <= least * (1 + 1e-12) &&
        (closest == surface.vertices.size() ||
         lexicographically_less(surface.vertices[k], surface.vertices[closest])))
      closest = k;
  if (mistake == Mistake::distance_to_triangles)
    for (const auto& [a, b, c] : surface.triangles) {
      const Point at =
          closest_on_triangle(centroid, surface.vertices[a], surface.vertices[b], surface.vertices[c]);
      least = std::min(least, (centroid - at).norm());
    }
  return {least, closest};
}

double desired_volume(double d, const Law& law, Mistake mistake) {
  double v0 = law.v0, v1 = law.v1;
  if (mistake == Mistake::volumes_exchanged) std::swap(v0, v1);
  const double bent = std::pow(d / law.d1, law.p);
  return std::max((1 - bent) * v0 + bent * v1, std::min(v0, v1));
}

double curvature_weight(double kappa, const Law& law, Mistake mistake) {
  if (law.kappa_min == law.kappa_max) return 1;
  const double part = (kappa - law.kappa_min) / (law.kappa_max - law.kappa_min);
  if (mistake == Mistake::inverted_curvature_weight) return part + (1 - part) / 10;
  return (law.kappa_max - kappa) / (law.kappa_max - law.kappa_min) + part / 10;
}

Weight weigh(const TriangleSurface& surface, const Corners& corners, const Law& law, Mistake mistake) {
  Weight w;
  const auto [d, closest] = distance(surface, corners, mistake);
  w.d = d;
  if (!law.kappas.empty()) {
    w.kappa = law.kappas[closest];
    w.omega = curvature_weight(w.kappa, law, mistake);
  }
  w.volume = signed_volume(corners);
  w.desired = desired_volume(w.omega * w.d, law, mistake);
  w.error = mistake == Mistake::signed_error ? w.volume - w.desired : std::abs(w.volume - w.desired);
  return w;
}

double quality(const Corners& t, Quality kind) {
  if (kind == Quality::aspect_ratio) {
    double largest = 0;
    for (const auto& [a, b, c] : tet_faces)
      largest = std::max(largest, (t[b] - t[a]).cross(t[c] - t[a]).norm() / 2);
    return 3 * std::abs(signed_volume(t)) / (largest * largest);
  }
  double least = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 4; ++corner) {
    const auto [numerator, denominator] = tangent_at(t, corner);
    if (denominator > 0) least = std::min(least, numerator / denominator);  // otherwise Omega is at least pi
  }
  return least;
}

double smallest_solid_angle(const Corners& t) {
  return 2 * std::atan(quality(t, Quality::solid_angle)) / (4 * std::numbers::pi);
}

}  // namespace tetproof::second
