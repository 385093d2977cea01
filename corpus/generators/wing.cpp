// SPDX-License-Identifier: GPL-3.0-or-later
// The generator of straight wings with a NACA four-digit section, closed by flat tips.
//
// The section has the thickness and the mean line of NACA Report 460 (Jacobs, Ward and Pinkerton 1933). The
// last coefficient of the thickness is -0.1036, so that the trailing edge has no thickness. The thickness is
// laid off normal to the mean line.
#include <algorithm>
#include <cmath>

#include "corpus/generators/generators.hpp"
#include "corpus/generators/quadrature.hpp"
#include "corpus/generators/turns.hpp"

namespace tetproof::corpus {
namespace {

struct Section {
  double m = 0, p = 0, t = 0;  // camber, its position, thickness: fractions of the chord

  // Half the thickness at x = s^2, 0 <= s <= 1: the polynomial 0.2969 s - 0.1260 s^2 - 0.3516 s^4 + 0.2843
  // s^6 - 0.1036 s^8, with the factors s and 1 - s of its zeros taken out. So it is exactly 0 at both edges,
  // and not negative between them.
  double half_thickness(double s) const {
    const double s2 = s * s, s3 = s2 * s;
    return 5 * t * s * (1 - s) *
           (0.2969 + 0.1709 * (s + s2) - 0.1807 * (s3 + s3 * s) + 0.1036 * (s3 * s2 + s3 * s3));
  }
  double mean_line(double x) const {
    if (m == 0) return 0;
    return x < p ? m / (p * p) * (2 * p * x - x * x)
                 : m / ((1 - p) * (1 - p)) * ((1 - 2 * p) + 2 * p * x - x * x);
  }
  double mean_slope(double x) const {
    if (m == 0) return 0;
    return 2 * m / (x < p ? p * p : (1 - p) * (1 - p)) * (p - x);
  }
  // Whether the thickness reaches the centre of curvature of the mean line anywhere.
  bool folds() const {
    if (m == 0) return false;
    for (int i = 1; i < 1000; ++i) {
      const double s = i / 1000.0, slope = mean_slope(s * s),
                   bend = 2 * m / (s * s < p ? p * p : (1 - p) * (1 - p));
      if (half_thickness(s) * bend >= std::pow(1 + slope * slope, 1.5)) return true;
    }
    return false;
  }
  // Area over chord^2: the integral of the thickness along the mean line. The curvature of the mean line
  // cancels, because the thickness is the same on both sides.
  double area() const {
    const GaussRule rule = gauss_legendre(64);
    const double kink = m == 0 ? 1 : std::sqrt(p);
    Sum sum;
    for (const auto& [from, to] : {std::pair{0.0, kink}, std::pair{kink, 1.0}})
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double s = from + (to - from) * rule.nodes[i], slope = mean_slope(s * s);
        sum.add((to - from) * rule.weights[i] * 4 * s * half_thickness(s) * std::sqrt(1 + slope * slope));
      }
    return sum.value();
  }
};

Section section(const Values& values) {
  const int digits = static_cast<int>(values["naca"]);
  const int m = digits / 1000, p = digits / 100 % 10, t = digits % 100;
  const Section section{.m = m / 100.0, .p = p / 10.0, .t = t / 100.0};
  if (section.t < 0.01 || section.t > 0.5)
    values.refuse("naca: expected a thickness (last two digits) of 01 to 50");
  if (section.m > 0 && section.p == 0)
    values.refuse(
        "naca: expected a position of the camber (second digit) of 1 to 9, because the first digit is not 0");
  if (section.folds()) values.refuse("naca: too thick for its camber, the section folds over itself");
  return section;
}

TriangleSurface make(const Values& values) {
  const Section section = corpus::section(values);
  const double chord = values["chord"], span = values["span"], aspect = span / chord;
  const Eigen::Vector3d corner = values.vector("x", "y", "z");
  if (aspect < 1e-3 || aspect > 1e3) values.refuse("span: expected 0.001 to 1000 chords");
  if (corner.cwiseAbs().maxCoeff() > 1e6 * std::min(chord, span))
    values.refuse("x, y, z: more than a million chords or spans from the origin");

  TriangleSurface surface;
  // u is -1 at the trailing edge on the lower side, 0 at the leading edge, 1 at the trailing edge on the
  // upper side. v goes from 0 to 1 along the span. The tips have v below 0 and above 1; there the thickness
  // shrinks to 0 at v = -1 and 2.
  surface.evaluate = [section, chord, span, corner](const Eigen::Vector2d& uv) {
    const double s = cos_sin_turns(std::abs(uv[0]) / 4).sin, x = s * s, slope = section.mean_slope(x);
    const double part = std::max(0.0, 1 - std::max({0.0, -uv[1], uv[1] - 1}));
    const double half = std::copysign(section.half_thickness(s) * part, uv[0]) / std::sqrt(1 + slope * slope);
    return Eigen::Vector3d(corner + Eigen::Vector3d(chord * (x - half * slope),
                                                    span * std::clamp(uv[1], 0.0, 1.0),
                                                    chord * (section.mean_line(x) + half)));
  };

  // k stations from the leading to the trailing edge, nv strips along the span: 4 k nv + 8 k - 8 triangles.
  const double n = values["n"];
  const double square = (std::sqrt(4 + n * aspect) - 2) / (2 * aspect);  // k for nv = k aspect
  const int k = std::max(2, static_cast<int>(std::lround(square * aspect < 1 ? (n + 8) / 12 : square)));
  const int nv = std::max(1, static_cast<int>(std::lround((n + 8 - 8.0 * k) / (4.0 * k))));
  const auto uv = [&](int i, int j) {  // -k <= i <= k
    return Eigen::Vector2d(static_cast<double>(i) / k, j < 0    ? -1.0
                                                       : j > nv ? 2.0
                                                                : static_cast<double>(j) / nv);
  };
  const auto vertex = [&](int i, int j) {
    if (j >= 0 && j <= nv) return static_cast<Index>(j * 2 * k + (i == -k ? k : i) + k - 1);
    const Index tip = 2 * k * (nv + 1) + (j < 0 ? 0 : k - 1);  // the mean line has no upper and lower side
    return tip + std::abs(i) - 1;
  };
  for (int j = 0; j <= nv; ++j)
    for (int i = 1 - k; i <= k; ++i) surface.vertices.push_back(surface.evaluate(uv(i, j)));
  for (const int j : {-1, nv + 1})
    for (int i = 1; i < k; ++i) surface.vertices.push_back(surface.evaluate(uv(i, j)));

  using Node = std::array<int, 2>;
  const auto add = [&](const Node& a, const Node& b, const Node& c) {
    surface.triangles.push_back({vertex(a[0], a[1]), vertex(b[0], b[1]), vertex(c[0], c[1])});
    surface.parameters.push_back({uv(a[0], a[1]), uv(b[0], b[1]), uv(c[0], c[1])});
  };
  for (int j = 0; j < nv; ++j)
    for (int i = -k; i < k; ++i) {
      add({i, j}, {i + 1, j}, {i + 1, j + 1});
      add({i, j}, {i + 1, j + 1}, {i, j + 1});
    }
  const std::size_t tips = surface.triangles.size();
  for (int i = -k; i < k; ++i) {
    // The part of the tip between stations i and i + 1, from the outline of the section to the mean line.
    // They meet at both edges.
    const bool sharp_first = i == -k || i == 0, sharp_last = i + 1 == 0 || i + 1 == k;
    if (!sharp_first) add({i, -1}, {i + 1, 0}, {i, 0});
    if (!sharp_last) add({i, sharp_first ? 0 : -1}, {i + 1, -1}, {i + 1, 0});
    if (!sharp_first) add({i, nv + 1}, {i, nv}, {i + 1, nv});
    if (!sharp_last) add({i, sharp_first ? nv : nv + 1}, {i + 1, nv}, {i + 1, nv + 1});
  }
  // With few stations, the triangulation may fold even if the section does not. The tips show that.
  for (std::size_t t = tips; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const Eigen::Vector3d p = surface.vertices[b] - surface.vertices[a],
                          q = surface.vertices[c] - surface.vertices[a];
    const bool first_tip = surface.vertices[a][1] == corner[1];
    if (!((p[2] * q[0] - p[0] * q[2]) * (first_tip ? -1 : 1) > 0))
      values.refuse("naca: this section, with so few triangles, folds over itself");
  }
  return surface;
}

std::optional<double> volume(const Values& values) {
  return section(values).area() * values["chord"] * values["chord"] * values["span"];
}

}  // namespace

Generator wing_generator() {
  return {
      .name = "wing",
      .meaning =
          "a straight wing, NACA four-digit section with a sharp trailing edge in the xz plane, span along "
          "y, flat tips",
      .parameters = {{"naca", 12, 0, 9999, "the section", Kind::four_digits},
                     {"chord", 1, 1e-9, 1e9, "length of the section"},
                     {"span", 3, 1e-9, 1e9, "from tip to tip"},
                     {"n", 5000, 20, most_triangles, "approximate number of triangles", Kind::integer},
                     {"x", 0, -1e12, 1e12, "leading edge of the first tip"},
                     {"y", 0, -1e12, 1e12, "leading edge of the first tip"},
                     {"z", 0, -1e12, 1e12, "leading edge of the first tip"}},
      .volume_text = "area of the section by quadrature, converged to 1e-12, times the span",
      .make = make,
      .volume = volume};
}

}  // namespace tetproof::corpus
