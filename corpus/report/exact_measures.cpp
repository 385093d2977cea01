// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/report/exact_measures.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "corpus/exact/exact_integers.hpp"

namespace tetproof::corpus {
namespace {

using Big = boost::multiprecision::cpp_int;
using boost::multiprecision::denominator;
using boost::multiprecision::numerator;

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Rational product(const RationalPoint& a, const RationalPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
RationalPoint crossed(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational to_segment(const RationalPoint& p, const RationalPoint& a, const RationalPoint& b) {
  const RationalPoint ab = minus(b, a), ap = minus(p, a), bp = minus(p, b);
  const Rational along = product(ap, ab), length = product(ab, ab);
  if (along <= 0) return product(ap, ap);
  if (along >= length) return product(bp, bp);
  return product(ap, ap) - along * along / length;
}

Rational between_segments(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                          const RationalPoint& d) {
  const RationalPoint u = minus(b, a), v = minus(d, c), w = minus(c, a), n = crossed(u, v);
  const Rational nn = product(n, n);
  if (nn != 0) {
    const Rational s = product(crossed(w, v), n), t = product(crossed(w, u), n);
    if (s >= 0 && s <= nn && t >= 0 && t <= nn) {
      const Rational height = product(w, n);
      return height * height / nn;
    }
  }
  return std::min(std::min(to_segment(a, c, d), to_segment(b, c, d)),
                  std::min(to_segment(c, a, b), to_segment(d, a, b)));
}

// An integer in units of 2^unit as a rational.
Rational in_units(const Integer& n, int unit) {
  const Big big = Big(n.str());
  return unit >= 0 ? Rational(Big(big << unit)) : Rational(big, Big(Big(1) << -unit));
}

Eigen::Vector3d finite_or_zero(const Eigen::Vector3d& p) {
  return p.allFinite() ? p : Eigen::Vector3d::Zero();
}

}  // namespace

RationalPoint exact_point(const Eigen::Vector3d& p) {
  return {Rational(p[0]), Rational(p[1]), Rational(p[2])};
}

RationalTriangle exact_triangle(std::span<const Eigen::Vector3d> points,
                                const std::array<Index, 3>& triangle) {
  const auto at = [&](int k) {
    return exact_point(points[static_cast<std::size_t>(triangle[static_cast<std::size_t>(k)])]);
  };
  return {at(0), at(1), at(2)};
}

RationalPoint weighted(const RationalTriangle& triangle, const std::array<Rational, 3>& weights) {
  RationalPoint p;
  for (std::size_t k = 0; k < 3; ++k)
    p[k] = weights[0] * triangle[0][k] + weights[1] * triangle[1][k] + weights[2] * triangle[2][k];
  return p;
}

Rational exact_volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                      const Eigen::Vector3d& d) {
  const RationalPoint p = exact_point(a);
  return product(crossed(minus(exact_point(b), p), minus(exact_point(c), p)), minus(exact_point(d), p)) / 6;
}

Rational exact_volume(const TetMesh& mesh) {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& p : mesh.points) points.push_back(finite_or_zero(p));  // unused ones may be NaN
  const int unit = last_bit(points);
  std::vector<IntegerPoint> at;
  for (const Eigen::Vector3d& p : points) at.push_back(integers(p, unit));
  Integer sum = 0;
  for (const auto& [a, b, c, d] : mesh.tets) {
    const IntegerPoint& p = at[static_cast<std::size_t>(a)];
    sum += dot(cross(at[static_cast<std::size_t>(b)] - p, at[static_cast<std::size_t>(c)] - p),
               at[static_cast<std::size_t>(d)] - p);
  }
  return in_units(sum, 3 * unit) / 6;
}

Rational exact_volume(const TriangleSurface& surface) {
  const int unit = last_bit(surface.vertices);
  std::vector<IntegerPoint> at;
  for (const Eigen::Vector3d& p : surface.vertices) at.push_back(integers(p, unit));
  Integer sum = 0;
  for (const auto& [a, b, c] : surface.triangles)
    sum += dot(at[static_cast<std::size_t>(a)],
               cross(at[static_cast<std::size_t>(b)], at[static_cast<std::size_t>(c)]));
  return in_units(sum, 3 * unit) / 6;
}

Rational squared_distance(const RationalPoint& p, const RationalTriangle& t) {
  const RationalPoint n = crossed(minus(t[1], t[0]), minus(t[2], t[0]));
  const Rational nn = product(n, n);
  bool above = nn != 0;
  for (std::size_t i = 0; i < 3 && above; ++i) {
    const RationalPoint& a = t[i];
    above = product(crossed(n, minus(t[(i + 1) % 3], a)), minus(p, a)) >= 0;
  }
  if (above) {
    const Rational height = product(n, minus(p, t[0]));
    return height * height / nn;
  }
  return std::min(to_segment(p, t[0], t[1]), std::min(to_segment(p, t[1], t[2]), to_segment(p, t[2], t[0])));
}

Rational squared_distance(const RationalTriangle& s, const RationalTriangle& t) {
  Rational least = squared_distance(s[0], t);
  for (std::size_t i = 0; i < 3; ++i) {
    least = std::min({least, squared_distance(s[i], t), squared_distance(t[i], s)});
    for (std::size_t k = 0; k < 3; ++k)
      least = std::min(least, between_segments(s[i], s[(i + 1) % 3], t[k], t[(k + 1) % 3]));
  }
  return least;
}

Eigen::Vector3d nearest_weights(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& t) {
  const Eigen::Vector3d n = (t[1] - t[0]).cross(t[2] - t[0]);
  Eigen::Vector3d weights;
  for (int i = 0; i < 3; ++i) {
    const auto &a = t[static_cast<std::size_t>((i + 1) % 3)], &b = t[static_cast<std::size_t>((i + 2) % 3)];
    weights[i] = n.dot((b - a).cross(p - a));
  }
  if (weights.minCoeff() >= 0 && weights.sum() > 0) return weights / weights.sum();
  double least = HUGE_VAL;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Eigen::Vector3d &a = t[static_cast<std::size_t>(i)], side = t[static_cast<std::size_t>(j)] - a;
    const double length = side.squaredNorm(),
                 along = length > 0 ? std::clamp(side.dot(p - a) / length, 0.0, 1.0) : 0;
    const double distance = (a + along * side - p).squaredNorm();
    if (!(distance < least)) continue;
    least = distance;
    weights = Eigen::Vector3d::Zero();
    weights[i] = 1 - along;
    weights[j] = along;
  }
  return weights;
}

Rational squared_distance(const RationalPoint& p, std::span<const Eigen::Vector3d> points,
                          std::span<const std::array<Index, 3>> triangles) {
  const Eigen::Vector3d at(rounded(p[0]), rounded(p[1]), rounded(p[2]));
  std::vector<double> distances;
  double size = at.cwiseAbs().maxCoeff();
  for (const auto& t : triangles) {
    std::array<Eigen::Vector3d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = points[static_cast<std::size_t>(t[k])];
    for (const Eigen::Vector3d& corner : corners) size = std::max(size, corner.cwiseAbs().maxCoeff());
    const Eigen::Vector3d w = nearest_weights(at, corners);
    distances.push_back((w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2] - at).stableNorm());
  }
  const double most = *std::min_element(distances.begin(), distances.end()) * 1.001 + 1e-12 * size;
  std::optional<Rational> least;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (!(distances[i] > most)) {
      const Rational distance = squared_distance(p, exact_triangle(points, triangles[i]));
      if (!least || distance < *least) least = distance;
    }
  return *least;
}

double rounded(const Rational& x) {
  if (x == 0) return 0;
  Big n = abs(numerator(x)), d = denominator(x);
  const int shift = 62 - (static_cast<int>(boost::multiprecision::msb(n)) -
                          static_cast<int>(boost::multiprecision::msb(d)));
  if (shift >= 0)
    n <<= shift;
  else
    d <<= -shift;
  const auto digits = static_cast<std::uint64_t>(Big(n / d));
  const double value = std::ldexp(static_cast<double>(digits), -shift);
  return x < 0 ? -value : value;
}

std::string text_of(const Rational& x) {
  return x.str();
}

std::string short_text(const Rational& x) {
  const Big d = denominator(x);
  const auto twos = static_cast<int>(boost::multiprecision::lsb(d));
  const Big odd = d >> twos;
  if (twos < 14) return x.str();
  if (odd == 1) return fmt::format("{}/2^{}", numerator(x).str(), twos);
  return fmt::format("{}/({}*2^{})", numerator(x).str(), odd.str(), twos);
}

std::string value_text(const Rational& x) {
  const std::string digits = fmt::format("{:.6g}", rounded(x));
  const bool all_digits = denominator(x) < 16384 && Rational(std::stod(digits)) == x;
  return all_digits ? digits : fmt::format("{}, exactly {}", digits, short_text(x));
}

}  // namespace tetproof::corpus
