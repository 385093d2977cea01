// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/first_grid/intersections.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <optional>

#include "io/bytes/large_pages.hpp"
#include "reference/engine/first_grid/rasterise.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;
using Rational = boost::multiprecision::cpp_rational;
using RationalVector = std::array<Rational, 3>;

RationalVector exact(const Vector3d& a) {
  return {Rational(a.x()), Rational(a.y()), Rational(a.z())};
}
RationalVector operator-(const RationalVector& a, const RationalVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Rational determinant(const RationalVector& a, const RationalVector& b, const RationalVector& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

struct Segment {
  Vector3d a, b;  // the edge, from its lower-numbered end
};

// A place on an edge: t goes from 0 at the low end to 1 at the high end. `error` bounds the error of t.
struct Place {
  double t, error;
  double from_high;  // 1 - t, computed without cancellation
};

constexpr double largest_error = 1e-12;  // of t; beyond it rational arithmetic is used

// The place where the plane of the triangle cuts the edge, in double precision. The ends of the edge lie on
// different sides of the plane. t = D(a) / (D(a) - D(b)) with D(x) = (x-p) . (q-p) x (r-p). The error of D is
// at most 8 rounding errors of the sum of the magnitudes of its terms.
Place place_in_doubles(const Segment& s, const Triangle& sorted) {
  const auto& [p, q, r] = sorted;
  const Vector3d u = q - p, v = r - p;
  const Vector3d normal = u.cross(v);
  const Vector3d magnitude(std::abs(u.y() * v.z()) + std::abs(u.z() * v.y()),
                           std::abs(u.z() * v.x()) + std::abs(u.x() * v.z()),
                           std::abs(u.x() * v.y()) + std::abs(u.y() * v.x()));
  const Vector3d pa = s.a - p, pb = s.b - p;
  const double da = std::abs(pa.dot(normal)), db = std::abs(pb.dot(normal));
  const double error = 1e-15 * (pa.cwiseAbs().dot(magnitude) + pb.cwiseAbs().dot(magnitude));
  const double sum = da + db;
  if (!(sum > 1e-290)) return {0.5, 1, 0.5};
  return {da / sum, error / sum + 1e-15, db / sum};
}

Rational exact_place(const Segment& s, const Triangle& t) {
  const RationalVector p = exact(t[0]), u = exact(t[1]) - p, v = exact(t[2]) - p;
  const Rational da = determinant(exact(s.a) - p, u, v), db = determinant(exact(s.b) - p, u, v);
  return da / (da - db);
}

Place rounded(const Rational& t) {
  return {t.convert_to<double>(), 0, Rational(1 - t).convert_to<double>()};
}

Place place(const Segment& s, const Triangle& sorted) {
  const Place quick = place_in_doubles(s, sorted);
  return quick.error <= largest_error ? quick : rounded(exact_place(s, sorted));
}

// The point is computed from the nearer end, so that the distance of a cut to a vertex beside it is accurate.
Vector3d point_at(const Segment& s, const Place& at) {
  const Vector3d d = s.b - s.a;
  return at.t <= at.from_high ? Vector3d(s.a + at.t * d) : Vector3d(s.b - at.from_high * d);
}

// The point where one triangle crosses the edge.
struct Crossing {
  Triangle sorted;
  Place at;
  Rational exactly;  // t, computed only when two crossings are too close together for doubles
  bool known = false;

  const Rational& exact_t(const Segment& s) {
    if (!known) exactly = exact_place(s, sorted);
    known = true;
    return exactly;
  }
};

int compare(Crossing& a, Crossing& b, const Segment& s) {
  if (std::abs(a.at.t - b.at.t) > a.at.error + b.at.error) return a.at.t < b.at.t ? -1 : 1;
  return a.exact_t(s).compare(b.exact_t(s));
}

// The overlap of the edge with a coplanar triangle, as an interval of t; nothing if they do not meet.
std::optional<std::array<Rational, 2>> overlap(const Segment& s, const Triangle& t) {
  const RationalVector a = exact(s.a), d = exact(s.b) - a;
  const RationalVector corner[3] = {exact(t[0]), exact(t[1]), exact(t[2])};
  // In a projection in which the triangle has an area, it is the intersection of three half-planes,
  // side(x) * area >= 0.
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto cross = [&](const RationalVector& x, const RationalVector& y) {
      return Rational(x[u] * y[v] - x[v] * y[u]);
    };
    const int area = cross(corner[1] - corner[0], corner[2] - corner[0]).sign();
    if (area == 0) continue;
    Rational lo = 0, hi = 1;
    for (int c = 0; c < 3; ++c) {
      const RationalVector side = corner[(c + 1) % 3] - corner[c];
      const Rational at_low = area * cross(side, a - corner[c]),
                     slope = area * cross(side, d);  // at_low + t slope >= 0
      if (slope == 0) {
        if (at_low < 0) return std::nullopt;
      } else if (slope > 0) {
        lo = std::max(lo, Rational(-at_low / slope));
      } else {
        hi = std::min(hi, Rational(-at_low / slope));
      }
    }
    if (lo > hi) return std::nullopt;
    return std::array{lo, hi};
  }
  return std::nullopt;
}

using Hits = std::vector<EdgeHit>::const_iterator;

// Whether a coplanar triangle has a part of the open edge.
bool lies_along(const Segment& s, const TriangleSurface& surface, const EdgeHit& hit) {
  if (!hit.along) return false;
  const auto common = overlap(s, corners(surface, hit.triangle));
  return common && (*common)[0] < 1 && (*common)[1] > 0;
}

// The general case. Points and overlaps are closed intervals; they are united, and the ends of the united
// intervals that lie inside (0,1) are counted.
EdgeIntersections unite(const Segment& s, const TriangleSurface& surface, Hits first, Hits last) {
  std::vector<std::array<Rational, 2>> intervals;
  for (Hits hit = first; hit != last; ++hit) {
    const Triangle t = corners(surface, hit->triangle);
    if (!hit->along) {
      const Rational at = exact_place(s, t);
      intervals.push_back({at, at});
    } else if (const auto common = overlap(s, t)) {
      intervals.push_back(*common);
    }
  }
  std::sort(intervals.begin(), intervals.end());
  std::vector<std::array<Rational, 2>> united;
  for (const auto& interval : intervals) {
    if (!united.empty() && interval[0] <= united.back()[1])
      united.back()[1] = std::max(united.back()[1], interval[1]);
    else
      united.push_back(interval);
  }
  std::vector<Rational> points;
  for (const auto& [lo, hi] : united) {
    if (lo > 0 && lo < 1) points.push_back(lo);
    if (hi != lo && hi > 0 && hi < 1) points.push_back(hi);
  }
  if (points.empty()) return {first->edge, 0, {}, {}};
  return {first->edge, static_cast<int>(points.size()), point_at(s, rounded(points.front())),
          point_at(s, rounded(points.back()))};
}

// The case without overlaps. If several triangles cross the edge in one point, the coordinates of this point
// are computed from the triangle whose sorted coordinates are smallest.
EdgeIntersections order(const Segment& s, const TriangleSurface& surface, Hits first, Hits last) {
  std::vector<Crossing> crossings;
  for (Hits hit = first; hit != last; ++hit) {
    if (hit->along) continue;
    const Triangle sorted = sorted_corners(corners(surface, hit->triangle));
    crossings.push_back({sorted, place(s, sorted), {}, false});
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return std::lexicographical_compare(a.sorted.begin(), a.sorted.end(), b.sorted.begin(), b.sorted.end(),
                                        lexicographically_less);
  });
  std::vector<Crossing*> distinct;  // ascending along the edge
  for (Crossing& crossing : crossings) {
    const auto at = std::lower_bound(distinct.begin(), distinct.end(), &crossing,
                                     [&](Crossing* a, Crossing* b) { return compare(*a, *b, s) < 0; });
    if (at == distinct.end() || compare(crossing, **at, s) != 0) distinct.insert(at, &crossing);
  }
  if (distinct.empty()) return {first->edge, 0, {}, {}};
  return {first->edge, static_cast<int>(distinct.size()), point_at(s, distinct.front()->at),
          point_at(s, distinct.back()->at)};
}

}  // namespace

std::vector<EdgeIntersections> intersect_edges(const Lattice& lattice, const TriangleSurface& surface,
                                               const Contacts& contacts,
                                               const std::function<bool(Edge)>& wanted) {
  std::vector<std::array<std::size_t, 2>> runs;  // the hits of each edge
  const std::vector<EdgeHit>& hits = contacts.hits;
  for (std::size_t first = 0, last; first < hits.size(); first = last) {
    for (last = first; last < hits.size() && hits[last].edge == hits[first].edge;) ++last;
    if (wanted(hits[first].edge)) runs.push_back({first, last});
  }
  std::vector<EdgeIntersections> all;
  io::resize_in_large_pages(all, runs.size());
  tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t n) {
    const Hits first = hits.begin() + runs[n][0], last = hits.begin() + runs[n][1];
    const Segment s{lattice.point(lattice.low(first->edge)), lattice.point(lattice.high(first->edge))};
    const bool along =
        std::any_of(first, last, [&](const EdgeHit& hit) { return lies_along(s, surface, hit); });
    all[n] = along ? unite(s, surface, first, last) : order(s, surface, first, last);
  });
  std::erase_if(all, [](const EdgeIntersections& e) { return e.count == 0; });
  return all;
}

}  // namespace tetproof::reference
