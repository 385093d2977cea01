// SPDX-License-Identifier: GPL-3.0-or-later
// Where edges meet a surface, in rational numbers.
#pragma once

#include <CGAL/Exact_rational.h>

#include <utility>
#include <vector>

#include "tests/second/geometry.hpp"

namespace tetproof::second {

using Rational = CGAL::Exact_rational;

/// What of the closed edge p + t (q - p) lies on the surface, as disjoint intervals of t in ascending order;
/// a single point is an interval of no length (reading D6).
std::vector<std::pair<Rational, Rational>> meets(const TriangleSurface& surface, const Point& p,
                                                 const Point& q);

/// p + t (q - p), calculated exactly and rounded once a coordinate.
Point along(const Point& p, const Point& q, const Rational& t);

}  // namespace tetproof::second
