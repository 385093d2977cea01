// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare/compare_flips.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tetproof::verify {
namespace {

using namespace trace;

constexpr double rounding = 1e-12;  // of tan(Omega/2), and of D/A times a length

// The smallest solid angle of a tetrahedron, divided by 4 pi (van Oosterom and Strackee).
double smallest_solid_angle(const Tet& tet) {
  double smallest = 1;
  for (int i = 0; i < 4; ++i) {
    const Point a = tet[(i + 1) % 4] - tet[i], b = tet[(i + 2) % 4] - tet[i], c = tet[(i + 3) % 4] - tet[i];
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double omega = 2 * std::atan2(std::abs(a.cross(b).dot(c)),
                                        la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    smallest = std::min(smallest, omega / (4 * std::numbers::pi));
  }
  return smallest;
}

// D/A: three volumes over the square of the largest area.
double aspect_ratio(const Tet& tet) {
  double area = 0;
  for (int i = 0; i < 4; ++i)
    area = std::max(area, (tet[(i + 1) % 4] - tet[i]).cross(tet[(i + 2) % 4] - tet[i]).norm() / 2);
  return std::abs((tet[1] - tet[0]).cross(tet[2] - tet[0]).dot(tet[3] - tet[0])) / 2 / area / area;
}

std::vector<Tet> around_edge(const Flip& flip) {
  std::vector<Tet> tets;
  for (int i = 0; i < 3; ++i)
    tets.push_back({flip.face[i], flip.face[(i + 1) % 3], flip.edge[0], flip.edge[1]});
  return tets;
}

std::vector<Tet> beside_face(const Flip& flip) {
  return {{flip.face[0], flip.face[1], flip.face[2], flip.edge[0]},
          {flip.face[0], flip.face[1], flip.face[2], flip.edge[1]}};
}

std::vector<TetKey> around_edge(const FlipKey& f) {
  return {sorted({f[0], f[1], f[3], f[4]}), sorted({f[0], f[2], f[3], f[4]}),
          sorted({f[1], f[2], f[3], f[4]})};
}

std::vector<TetKey> beside_face(const FlipKey& f) {
  return {sorted({f[0], f[1], f[2], f[3]}), sorted({f[0], f[1], f[2], f[4]})};
}

}  // namespace

std::string says(const Flip& flip) {
  return fmt::format("{} flip of the face {} {} {} and the edge {} {}", flip.two_to_three ? "2-3" : "3-2",
                     short_text(flip.face[0]), short_text(flip.face[1]), short_text(flip.face[2]),
                     short_text(flip.edge[0]), short_text(flip.edge[1]));
}

std::vector<TetKey> old_tets(const FlipKey& flip) {
  return flip[5] ? beside_face(flip) : around_edge(flip);
}

std::vector<TetKey> new_tets(const FlipKey& flip) {
  return flip[5] ? around_edge(flip) : beside_face(flip);
}

std::string wrong_quality(const Flip& flip, const std::string& improve, const Tolerance& tolerance) {
  const bool by_ratio = improve == "aspect-ratio";
  const auto smallest = [&](const std::vector<Tet>& tets) {
    double least = std::numeric_limits<double>::infinity();
    for (const Tet& tet : tets)
      least = std::min(least, by_ratio ? aspect_ratio(tet) : smallest_solid_angle(tet));
    return least;
  };
  double size = 1;  // of good qualities
  if (by_ratio) {
    double longest = 0;
    for (const Point& a : flip.face)
      for (const Point& b : flip.edge) longest = std::max(longest, (a - b).norm());
    size = 1 / longest;
  }
  const auto beside = smallest(beside_face(flip)), around = smallest(around_edge(flip));
  for (const auto& [when, stated, computed] :
       {std::tuple("before", flip.quality_before, flip.two_to_three ? beside : around),
        std::tuple("after", flip.quality_after, flip.two_to_three ? around : beside)})
    if (!(std::abs(stated - computed) <=
          std::max(tolerance.relative, rounding) * std::abs(computed) + rounding * size)) {
      const auto [one, two] = apart(computed, stated);
      return fmt::format("the smallest quality {} it is {}, not {}", when, one, two);
    }
  return "";
}

FlipDifference flip_difference(std::int64_t n, std::size_t at, const Split& a, const Split& b) {
  const Flipped* const one = at < a.flips.size() ? &a.flips[at] : nullptr;
  const Flipped* const two = at < b.flips.size() ? &b.flips[at] : nullptr;
  const auto side = [](const Flipped* flipped, std::int64_t line) {
    return flipped ? Says{flipped->line,
                          fmt::format("{}; smallest quality {:.6g} to {:.6g}", says(flipped->flip),
                                      flipped->flip.quality_before, flipped->flip.quality_after),
                          to_line(flipped->flip)}
                   : Says{line, "no further flip"};
  };
  const auto short_name = [](const Flipped& flipped) {
    const Flip& flip = flipped.flip;
    const Point c = (flip.face[0] + flip.face[1] + flip.face[2] + flip.edge[0] + flip.edge[1]) / 5;
    return fmt::format("makes the {} flip at ({:.4g}, {:.4g}, {:.4g})", flip.two_to_three ? "2-3" : "3-2",
                       c.x(), c.y(), c.z());
  };
  const std::string which = fmt::format("insertion {}, flip {}: ", n, at + 1);
  const std::string what =
      one && two ? fmt::format("{}reference {}, other {}", which, short_name(*one), short_name(*two))
      : one      ? fmt::format("{}reference {}, other makes no further flip", which, short_name(*one))
                 : fmt::format("{}other {}, reference makes no further flip", which, short_name(*two));
  return {what, side(one, a.line), side(two, b.line)};
}

}  // namespace tetproof::verify
