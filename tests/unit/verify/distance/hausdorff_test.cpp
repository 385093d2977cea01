// SPDX-License-Identifier: GPL-3.0-or-later
// Directed Hausdorff distances against closed forms and against sampling with another formula; and changes
// that must not matter.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <map>
#include <random>

#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "tests/support/meshes.hpp"
#include "verify/hausdorff.hpp"

namespace tetproof::test {
namespace {

using Point = Eigen::Vector3d;
using verify::directed_hausdorff;
using verify::DirectedDistance;
using verify::HausdorffOptions;

DirectedDistance distance(const TriangleSurface& a, const TriangleSurface& b,
                          const HausdorffOptions& options) {
  return directed_hausdorff(a.vertices, a.triangles, b.vertices, b.triangles, options);
}

// The distance from a point to a triangle by another formula than verify's, in long double: by the region of
// the plane that the point lies over (Ericson, Real-Time Collision Detection, 5.1.5).
double point_to_triangle(const Point& at, const std::array<Point, 3>& corners) {
  using Vec = Eigen::Matrix<long double, 3, 1>;
  const Vec p = at.cast<long double>(), a = corners[0].cast<long double>(),
            b = corners[1].cast<long double>(), c = corners[2].cast<long double>();
  const Vec ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const auto to = [&](const Vec& q) { return static_cast<double>((p - q).norm()); };
  const long double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp),
                    d6 = ac.dot(cp);
  if (d1 <= 0 && d2 <= 0) return to(a);
  if (d3 >= 0 && d4 <= d3) return to(b);
  if (d6 >= 0 && d5 <= d6) return to(c);
  const long double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return to(a + d1 / (d1 - d3) * ab);
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return to(a + d2 / (d2 - d6) * ac);
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return to(b + (d4 - d3) / (d4 - d3 + d5 - d6) * (c - b));
  return to(a + vb / (va + vb + vc) * ab + vc / (va + vb + vc) * ac);
}

std::array<Point, 3> corners(const TriangleSurface& surface, std::size_t t) {
  const auto& v = surface.triangles[t];
  return {surface.vertices[v[0]], surface.vertices[v[1]], surface.vertices[v[2]]};
}

double to_surface(const Point& p, const TriangleSurface& surface) {
  double least = INFINITY;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    least = std::min(least, point_to_triangle(p, corners(surface, t)));
  return least;
}

// Expects that the interval contains `right`, is as narrow as asked, and that the given point attains its
// lower end.
void expect_distance(const TriangleSurface& a, const TriangleSurface& b, double right, double error) {
  const DirectedDistance d = distance(a, b, {.error = error});
  EXPECT_LE(d.lower, right * (1 + 1e-15));
  EXPECT_GE(d.upper, right * (1 - 1e-15));
  EXPECT_LE(d.upper - d.lower, error * (1 + 1e-12));
  ASSERT_GE(d.triangle, 0);
  EXPECT_NEAR(point_to_triangle(d.point, corners(a, static_cast<std::size_t>(d.triangle))), 0, 1e-13);
  EXPECT_GE(to_surface(d.point, b), d.lower - 1e-13);
  EXPECT_NEAR(point_to_triangle(d.point, corners(b, static_cast<std::size_t>(d.nearest))), d.lower, 1e-12);
}

TriangleSurface moved(TriangleSurface surface, const Point& by) {
  for (Point& p : surface.vertices) p += by;
  return surface;
}

TriangleSurface scaled(TriangleSurface surface, double by) {
  for (Point& p : surface.vertices) p *= by;
  return surface;
}

TEST(Hausdorff, OfEqualSurfacesIsExactlyZero) {
  for (const char* spec : {"sphere:r=1,n=2000", "torus:n=2000", "random:seed=7,n=2000"}) {
    const TriangleSurface surface = corpus::make_surface(spec);
    TriangleSurface other = surface;  // the same triangles in another order, beginning at other corners
    std::reverse(other.triangles.begin(), other.triangles.end());
    for (auto& t : other.triangles) t = {t[1], t[2], t[0]};
    const DirectedDistance d = distance(surface, other, {.error = 1e-3});
    EXPECT_EQ(d.lower, 0);
    EXPECT_EQ(d.upper, 0) << spec;
  }
}

TEST(Hausdorff, OfAFinerTriangulationOfTheSameFacesIsExactlyZero) {
  // The finer triangles lie exactly on the coarser ones. The coarser triangles are cut, so that is true up to
  // rounding.
  const TriangleSurface coarse = box_surface({0, 0, 0}, 4), fine = boundary_surface(lattice_mesh({4, 4, 4}));
  EXPECT_EQ(distance(fine, coarse, {.error = 1e-3}).upper, 0);
  const DirectedDistance back = distance(coarse, fine, {.error = 0});
  EXPECT_EQ(back.lower, 0);
  EXPECT_LE(back.upper, 7 * 4e-14);
}

TEST(Hausdorff, OfTheSameFacesCutOtherwiseIsRounding) {
  const TriangleSurface thirds = boundary_surface(lattice_mesh({3, 3, 3}, {}, {0, 0, 0}, 5)),
                        fifths = boundary_surface(lattice_mesh({5, 5, 5}, {}, {0, 0, 0}, 3));
  for (const auto& d : {distance(thirds, fifths, {.error = 0}), distance(fifths, thirds, {.error = 0})}) {
    EXPECT_GE(d.lower, 0);
    EXPECT_LE(d.upper, 26 * 4e-14);
  }
  // Far from the origin the coordinates themselves are coarse, but they are the same in both surfaces.
  const Point far(1e6, -3e6, 2e6);
  EXPECT_LE(distance(moved(thirds, far), moved(fifths, far), {.error = 0}).upper, 26 * 4e-14);
}

TEST(Hausdorff, OfATranslatedCube) {
  for (const double by : {0.3, 1e-3, 1e-7}) {
    const TriangleSurface cube = boundary_surface(lattice_mesh({2, 2, 2}, {}, {0, 0, 0}, 0.5)),
                          other = moved(cube, {by, 0, 0});
    const double right = other.vertices[0].x() - cube.vertices[0].x();
    expect_distance(cube, other, right, 1e-4);
    expect_distance(cube, other, right, 1e-10);
    expect_distance(other, cube, right, 1e-10);
  }
}

TEST(Hausdorff, OfACubeAroundACube) {
  const TriangleSurface inner = box_surface({-1, -1, -1}, 2), outer = box_surface({-1.25, -1.25, -1.25}, 2.5);
  for (const double error : {1e-2, 1e-6, 1e-12}) {
    expect_distance(outer, inner, 0.25 * std::sqrt(3), error);
    expect_distance(inner, outer, 0.25, error);
  }
}

TEST(Hausdorff, FarBelowTheErrorItIsStillRight) {
  const TriangleSurface sphere = corpus::make_surface("sphere:r=1,n=5000"), larger = scaled(sphere, 1 + 1e-7);
  for (const auto& d : {distance(sphere, larger, {.error = 1e-4, .relative = 0.1}),
                        distance(larger, sphere, {.error = 1e-4, .relative = 0.1})}) {
    EXPECT_GE(d.lower, 0.89e-7);
    EXPECT_LE(d.upper, 1.12e-7);
    EXPECT_GE(d.upper, 0.999e-7) << "the middle of a face is (1e-7 x its distance from the centre) away";
  }
}

// A square pyramid of height h on the middle of the top of a block 3 x 3 x 1, over a square of side 1.
TriangleSurface with_spike(double h) {
  TriangleSurface surface = boundary_surface(lattice_mesh({3, 3, 1}));
  const auto on_top = [&](const std::array<Index, 3>& t) {
    Point sum = Point::Zero();
    for (const Index v : t) sum += surface.vertices[v] / 3;
    return sum.z() == 1 && sum.x() > 1 && sum.x() < 2 && sum.y() > 1 && sum.y() < 2;
  };
  std::erase_if(surface.triangles, on_top);
  const auto tip = static_cast<Index>(surface.vertices.size());
  surface.vertices.emplace_back(1.5, 1.5, 1 + h);
  const auto at = [&](double x, double y) {
    return static_cast<Index>(std::find(surface.vertices.begin(), surface.vertices.end(), Point(x, y, 1)) -
                              surface.vertices.begin());
  };
  const std::array<Index, 4> ring{at(1, 1), at(2, 1), at(2, 2), at(1, 2)};
  for (int i = 0; i < 4; ++i) surface.triangles.push_back({ring[i], ring[(i + 1) % 4], tip});
  return surface;
}

TEST(Hausdorff, OfASpike) {
  const TriangleSurface block = boundary_surface(lattice_mesh({3, 3, 1}));
  for (const double h : {0.01, 0.3, 2.0}) {
    const TriangleSurface spiked = with_spike(h);
    const double tip = spiked.vertices.back().z() - 1;
    expect_distance(spiked, block, tip, 1e-9);
    // The point of the block's top under the tip has the same distance from all four sides.
    expect_distance(block, spiked, tip * 0.5 / std::hypot(tip, 0.5), 1e-9);
  }
}

TEST(Hausdorff, OfAFoldAndOfNestedShells) {
  // A strip that goes out to x = 2 and comes back half of the way, 0.1 above itself.
  const TriangleSurface strip{
      .vertices = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {1, 0, 0.1}, {1, 1, 0.1}},
      .triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}}};
  const TriangleSurface flat{.vertices = strip.vertices, .triangles = {{0, 1, 2}, {0, 2, 3}}};
  expect_distance(strip, flat, 0.1, 1e-9);
  EXPECT_EQ(distance(flat, strip, {.error = 1e-9}).upper, 0);

  const TriangleSurface outer = box_surface({-2, -2, -2}, 4), inner = box_surface({-1, -1, -1}, 2);
  expect_distance(together(outer, inner), outer, 1, 1e-9);
  expect_distance(together(outer, inner), inner, std::sqrt(3), 1e-9);
}

TriangleSurface soup(std::mt19937_64& random, int triangles, bool thin) {
  const auto coordinate = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  TriangleSurface surface;
  for (int t = 0; t < triangles; ++t) {
    const Point a(coordinate(), coordinate(), coordinate()), b(coordinate(), coordinate(), coordinate()),
        c(coordinate(), coordinate(), coordinate());
    const double share = coordinate(), width = std::pow(10, -17 * coordinate());
    surface.vertices.insert(surface.vertices.end(),
                            {a, b, thin ? Point(a + share * (b - a) + width * (c - a)) : c});
    surface.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  if (thin) surface.vertices[2] = surface.vertices[0];  // one segment, one point
  if (thin && triangles > 1) surface.vertices[3] = surface.vertices[4] = surface.vertices[5];
  return surface;
}

TEST(Hausdorff, SamplesOfRandomTrianglesAgree) {
  std::mt19937_64 random(20240801);
  for (int round = 0; round < 60; ++round) {
    const bool thin = round % 2 == 1;
    const TriangleSurface a = soup(random, 1 + round % 5, thin), b = soup(random, 1 + round % 7, thin);
    constexpr int n = 60;  // parts of each side
    double sampled = 0, spacing = 0;
    for (std::size_t t = 0; t < a.triangles.size(); ++t) {
      const auto [p, q, r] = corners(a, t);
      spacing = std::max({spacing, (q - p).norm() / n, (r - p).norm() / n, (r - q).norm() / n});
      for (int i = 0; i <= n; ++i)
        for (int j = 0; i + j <= n; ++j)
          sampled = std::max(sampled, to_surface(p + (q - p) * i / n + (r - p) * j / n, b));
    }
    const double error = round % 3 ? 1e-3 : 1e-7;
    const DirectedDistance d = distance(a, b, {.error = error});
    EXPECT_GE(d.upper, sampled - 1e-14) << "round " << round;
    EXPECT_LE(d.lower, sampled + spacing) << "round " << round;
    EXPECT_LE(d.upper - d.lower, error * (1 + 1e-9)) << "round " << round;
    EXPECT_GE(to_surface(d.point, b), d.lower - 1e-12) << "round " << round;
  }
}

TEST(Hausdorff, ScaleDoesNotMatter) {
  const TriangleSurface a = with_spike(0.3), b = boundary_surface(lattice_mesh({3, 3, 1}));
  const DirectedDistance d = distance(a, b, {.error = 1e-6});
  for (const int exponent : {-900, -30, 40, 900}) {
    const double by = std::ldexp(1, exponent);
    const DirectedDistance other = distance(scaled(a, by), scaled(b, by), {.error = 1e-6 * by});
    EXPECT_EQ(other.lower, d.lower * by);
    EXPECT_EQ(other.upper, d.upper * by);
    EXPECT_EQ(other.point, Point(d.point * by));
  }
}

TEST(Hausdorff, SameBytesForAnyNumberOfThreads) {
  const TriangleSurface a = corpus::make_surface("random:seed=3,n=3000"),
                        b = moved(scaled(a, 1.01), {0.02, 0, 0});
  for (const HausdorffOptions options :
       {HausdorffOptions{.error = 1e-3}, {.error = 1e-3, .relative = 1e-4}}) {
    std::array<DirectedDistance, 3> results;
    for (int i = 0; i < 3; ++i) {
      tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::array{1, 2, 7}[i]);
      results[i] = distance(a, b, options);
    }
    for (const DirectedDistance& other : {results[1], results[2]}) {
      EXPECT_EQ(other.lower, results[0].lower);
      EXPECT_EQ(other.upper, results[0].upper);
      EXPECT_EQ(other.point, results[0].point);
      EXPECT_EQ(other.triangle, results[0].triangle);
      EXPECT_EQ(other.nearest, results[0].nearest);
      EXPECT_EQ(other.pieces, results[0].pieces);
    }
  }
}

TEST(Hausdorff, BoundedWorkLeavesAWiderInterval) {
  const TriangleSurface a = corpus::make_surface("sphere:r=1,n=500"),
                        b = corpus::make_surface("sphere:r=1,n=700");
  const DirectedDistance narrow = distance(a, b, {.error = 1e-9}),
                         wide = distance(a, b, {.error = 1e-9, .most_pieces = 600});
  EXPECT_LE(narrow.upper - narrow.lower, 1e-9);
  EXPECT_GT(wide.upper - wide.lower, 1e-9);
  EXPECT_LE(wide.lower, narrow.upper);
  EXPECT_GE(wide.upper, narrow.lower);
}

// A sphere of 20 4^levels triangles: an icosahedron whose triangles are divided in four.
TriangleSurface icosphere(int levels, double radius, const Point& centre) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  TriangleSurface sphere{
      .vertices = {{-1, g, 0},
                   {1, g, 0},
                   {-1, -g, 0},
                   {1, -g, 0},
                   {0, -1, g},
                   {0, 1, g},
                   {0, -1, -g},
                   {0, 1, -g},
                   {g, 0, -1},
                   {g, 0, 1},
                   {-g, 0, -1},
                   {-g, 0, 1}},
      .triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<Index, Index>, Index> middle;
    const auto between = [&](Index a, Index b) {
      const auto [at, is_new] = middle.try_emplace(std::minmax(a, b), sphere.vertices.size());
      if (is_new) sphere.vertices.push_back(sphere.vertices[a] + sphere.vertices[b]);
      if (is_new) sphere.vertices.back() *= sphere.vertices[0].norm() / sphere.vertices.back().norm();
      return at->second;
    };
    std::vector<std::array<Index, 3>> finer;
    for (const auto& [a, b, c] : sphere.triangles) {
      const Index ab = between(a, b), bc = between(b, c), ca = between(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    sphere.triangles = std::move(finer);
  }
  for (Point& p : sphere.vertices) p = centre + radius / p.norm() * p;
  return sphere;
}

TEST(Hausdorff, OfConcentricSpheresIsFoundWithoutLookingAtAllPairs) {
  // Of smooth spheres the distance is larger - smaller + offset, both ways. The triangles of a sphere of
  // radius R lie inside it, by at most R / 200 for 1,280 triangles and R / 800 for 5,120.
  for (const double ratio : {2.0, 100.0, 1e4})
    for (const double offset : {0.0, 0.01, 0.3}) {
      const TriangleSurface inner = icosphere(3, 1, offset * Point(0.6, 0, -0.8)),
                            outer = icosphere(4, ratio, {0, 0, 0});
      const double error = 1e-3 * std::sqrt(12) * ratio, right = ratio - 1 + offset;
      for (const auto& d :
           {distance(inner, outer, {.error = error}), distance(outer, inner, {.error = error})}) {
        EXPECT_GE(d.upper, right - ratio / 800) << ratio << " " << offset;
        EXPECT_LE(d.lower, right + 1.0 / 200) << ratio << " " << offset;
        EXPECT_LE(d.upper - d.lower, error);
        EXPECT_LE(d.pieces, 3 * 5120) << ratio << " " << offset;
      }
      const DirectedDistance narrow = distance(inner, outer, {.error = error / 1000});
      EXPECT_LE(narrow.upper - narrow.lower, error / 1000);
      EXPECT_NEAR(to_surface(narrow.point, outer), narrow.lower, 1e-13 * ratio) << "attained, by brute force";
      EXPECT_NEAR(point_to_triangle(narrow.point, corners(outer, static_cast<std::size_t>(narrow.nearest))),
                  narrow.lower, 1e-13 * ratio);
      double sampled = 0;  // no vertex or middle of a triangle is farther than the upper end
      for (std::size_t t = 0; t < inner.triangles.size(); t += 7) {
        const auto [p, q, r] = corners(inner, t);
        sampled = std::max({sampled, to_surface(p, outer), to_surface((p + q + r) / 3, outer)});
      }
      EXPECT_GE(narrow.upper, sampled - 1e-13 * ratio);
    }
}

TEST(Hausdorff, LargeFacesUnderManySmallOnesTakeLittleWork) {
  // A thin plate, turned and moved far away, with two triangles a side and with many, whose vertices are
  // rounded. Such distances are rounding alone, and an interval that is narrow in proportion may not exist.
  std::int64_t most = 0;
  for (const double thickness : {1.0, 1e-2, 1e-5})
    for (const double away : {0.0, 1e3, 1e6})
      for (const double turn : {0.0, 0.1, 0.7}) {
        const auto placed = [&](TriangleSurface plate, const Eigen::Vector2d& cell) {
          const Eigen::Matrix3d rotation(Eigen::AngleAxisd(turn, Point(1, 2, 3).normalized()));
          for (Point& p : plate.vertices)
            p = rotation * Point(p.x() * cell.x(), p.y() * cell.y(), p.z() * thickness) +
                away * Point(1, -0.7, 0.3);
          return plate;
        };
        const TriangleSurface few = placed(boundary_surface(lattice_mesh({1, 1, 1})), {1, 0.75}),
                              many =
                                  placed(boundary_surface(lattice_mesh({17, 13, 1})), {1 / 17.0, 0.75 / 13});
        for (const auto& d : {distance(few, many, {.error = 1e-4, .relative = 0.2}),
                              distance(many, few, {.error = 1e-4, .relative = 0.2})}) {
          most = std::max(most, d.pieces);
          EXPECT_LE(d.upper - d.lower, std::max(0.2 * d.upper, 1e-12))
              << thickness << " " << away << " " << turn;
        }
      }
  EXPECT_LE(most, 100'000) << "it was millions";
}

TEST(Hausdorff, EmptySetsAndBadInput) {
  const TriangleSurface cube = box_surface({0, 0, 0}, 1), none;
  EXPECT_EQ(distance(none, cube, {}).upper, 0);
  EXPECT_EQ(distance(cube, none, {}).lower, INFINITY);
  TriangleSurface bad = cube;
  bad.triangles[3][1] = 8;
  EXPECT_THROW(distance(bad, cube, {}), InputError);
  EXPECT_THROW(distance(cube, bad, {}), InputError);
  bad = cube;
  bad.vertices[2].y() = NAN;
  EXPECT_THROW(distance(bad, cube, {}), InputError);
  EXPECT_THROW(distance(cube, cube, {.error = NAN}), InputError);
  EXPECT_THROW(distance(cube, scaled(cube, 1e308), {}), InputError);
}

}  // namespace
}  // namespace tetproof::test
