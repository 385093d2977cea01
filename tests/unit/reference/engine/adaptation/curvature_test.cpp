// SPDX-License-Identifier: GPL-3.0-or-later
// Absolute curvature against closed forms: it converges on structured triangulations and not on random ones
// (reading D15). Single vertices against rational arithmetic: the vectors of kind "curvature".
#include "reference/engine/adaptation/curvature.hpp"

#include <gtest/gtest.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>

#include "corpus/surfaces.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

// The closed form at a point of the surface. It is negative where the test claims nothing (the rim of a
// patch).
using ClosedForm = std::function<double(const Vector3d&)>;

struct Errors {
  double median, largest, largest_curvature, outlier_ratio;
};

// The relative errors at all vertices.
Errors errors_of(const TriangleSurface& surface, const ClosedForm& exact) {
  const std::vector<double> found = absolute_curvatures(surface);
  std::vector<double> errors;
  for (std::size_t v = 0; v < found.size(); ++v) {
    const double truth = exact(surface.vertices[v]);
    if (truth >= 0) errors.push_back(std::abs(found[v] - truth) / truth);
  }
  std::sort(errors.begin(), errors.end());
  return {errors[errors.size() / 2], errors.back(), *std::max_element(found.begin(), found.end()),
          outlier_ratio(found)};
}

// The graph of f over [-1, 1]^2, as n x n squares that are cut in two.
TriangleSurface patch(int n, const std::function<Vector3d(double, double)>& f) {
  TriangleSurface surface;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) surface.vertices.push_back(f(2.0 * i / n - 1, 2.0 * j / n - 1));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Index p = i + (n + 1) * j, q = p + n + 1;
      surface.triangles.push_back({p, p + 1, q + 1});
      surface.triangles.push_back({p, q + 1, q});
    }
  return surface;
}

TriangleSurface hull_of_random_points(int n, std::uint64_t seed) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::mt19937_64 random(seed);
  std::vector<Kernel::Point_3> points;
  while (static_cast<int>(points.size()) < n) {
    Vector3d p;
    for (int x = 0; x < 3; ++x) p[x] = static_cast<double>(random() >> 11) * 0x1p-52 - 1;
    if (p.norm() > 1 || p.norm() < 0.1) continue;
    p.normalize();
    points.emplace_back(p.x(), p.y(), p.z());
  }
  CGAL::Surface_mesh<Kernel::Point_3> hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  TriangleSurface surface;
  for (const auto v : hull.vertices()) {
    const auto& p = hull.point(v);
    surface.vertices.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : hull.faces()) {
    std::array<Index, 3> triangle;
    int k = 0;
    for (const auto v : CGAL::vertices_around_face(hull.halfedge(f), hull))
      triangle[k++] = static_cast<Index>(v.idx());
    surface.triangles.push_back(triangle);
  }
  return surface;
}

struct Shape {
  const char* name;
  std::vector<std::function<TriangleSurface()>> resolutions;  // each with half the edge length of the last
  ClosedForm exact;
  bool stars_are_symmetric = true;  // the neighbours of each vertex are nearly in opposite pairs
};

// |k1| + |k2| of the graph of f, from its derivatives.
double of_graph(double fx, double fy, double fxx, double fxy, double fyy) {
  const double g = 1 + fx * fx + fy * fy;
  const double H = ((1 + fx * fx) * fyy - 2 * fx * fy * fxy + (1 + fy * fy) * fxx) / (2 * g * std::sqrt(g));
  const double K = (fxx * fyy - fxy * fxy) / (g * g);
  return K < 0 ? 2 * std::sqrt(H * H - K) : 2 * std::abs(H);
}

std::vector<Shape> shapes() {
  const auto generated = [](const std::string& spec) { return [=] { return corpus::make_surface(spec); }; };
  const auto inner = [](const Vector3d& p) { return std::abs(p.x()) < 0.99 && std::abs(p.y()) < 0.99; };
  std::vector<Shape> all;
  all.push_back({"sphere", {}, [](const Vector3d&) { return 1.0; }, false});
  all.push_back({"torus", {}, [](const Vector3d& p) {
                   const double ring = std::hypot(p.x(), p.y());
                   return 1 / 0.4 + std::abs(ring - 1) / 0.4 / ring;
                 }});
  for (const int n : {500, 2000, 8000, 32000}) {
    all[0].resolutions.push_back(generated("sphere:r=2,n=" + std::to_string(2 * n)));
    all[1].resolutions.push_back(generated("torus:R=1,r=0.4,n=" + std::to_string(2 * n)));
  }
  // A quarter of a cylinder of radius 2 and a saddle of changing curvature, as patches.
  all.push_back({"cylinder", {}, [=](const Vector3d& p) { return inner(p) ? 0.5 : -1; }});
  all.push_back({"saddle", {}, [=](const Vector3d& p) {
                   return inner(p) ? of_graph(p.x() + p.y() / 2, p.x() / 2 - p.y(), 1, 0.5, -1) : -1;
                 }});
  for (const int n : {16, 32, 64, 128}) {
    all[2].resolutions.push_back([=] {
      return patch(n, [](double x, double y) {
        return Vector3d(2 * std::sin(x * pi / 4), y, 2 * std::cos(x * pi / 4));
      });
    });
    all[3].resolutions.push_back([=] {
      return patch(n, [](double x, double y) { return Vector3d(x, y, (x * x + x * y - y * y) / 2); });
    });
  }
  return all;
}

// The table is printed: it is the evidence for reading D15.
TEST(Curvature, ConvergesOnStructuredTriangulations) {
  for (const Shape& shape : shapes()) {
    Errors before{};
    for (const auto& make : shape.resolutions) {
      const TriangleSurface surface = make();
      const Errors e = errors_of(surface, shape.exact);
      std::printf("  %-9s %6zu vertices: median error %.2e, largest %.2e", shape.name,
                  surface.vertices.size(), e.median, e.largest);
      if (before.median > 0) {
        const double median = std::log2(before.median / e.median),
                     largest = std::log2(before.largest / e.largest);
        std::printf("; order %.2f, %.2f", median, largest);
        EXPECT_GT(median, 1.7) << shape.name;
        if (shape.stars_are_symmetric) {
          EXPECT_GT(largest, 1.9) << shape.name;
        }
      }
      std::printf("\n");
      before = e;
    }
    EXPECT_LT(before.median, 5e-4) << shape.name;
    if (!shape.stars_are_symmetric) {  // a vertex without opposite pairs keeps its error
      EXPECT_GT(before.largest, 0.05) << shape.name;
      EXPECT_LT(before.largest, 0.2) << shape.name;
    }
  }
}

TEST(Curvature, DoesNotConvergeOnRandomTriangulations) {
  double largest = 0;
  for (const int n : {500, 2000, 8000, 32000}) {
    const Errors e = errors_of(hull_of_random_points(n, 1994), [](const Vector3d&) { return 2.0; });
    std::printf(
        "  sphere of %5d random points: median error %.3f, largest curvature %.1f in place of 2, %.1f times "
        "the 99th percentile\n",
        n, e.median, e.largest_curvature, e.outlier_ratio);
    EXPECT_NEAR(e.median, 0.16, 0.02) << n;
    EXPECT_GT(e.largest_curvature, largest) << "the worst vertex gets worse";
    EXPECT_GT(e.outlier_ratio, 1.5);
    largest = e.largest_curvature;
  }
  EXPECT_GT(largest, 50);
}

TEST(Curvature, ScalesByTwoExactly) {
  const TriangleSurface once = corpus::make_surface("random:seed=3,n=2000");
  TriangleSurface twice = once;
  for (Vector3d& p : twice.vertices) p *= 2;
  const auto a = absolute_curvatures(once), b = absolute_curvatures(twice);
  for (std::size_t v = 0; v < a.size(); ++v) EXPECT_EQ(a[v], 2 * b[v]) << v;
}

TEST(Curvature, QuarterTurnsKeepIt) {
  const TriangleSurface before = corpus::make_surface("random:seed=3,n=2000");
  const auto expected = absolute_curvatures(before);
  const std::vector<std::function<Vector3d(const Vector3d&)>> turns{
      [](const Vector3d& p) { return Vector3d(-p.y(), p.x(), p.z()); },
      [](const Vector3d& p) { return Vector3d(p.x(), -p.z(), p.y()); },
      [](const Vector3d& p) { return Vector3d(p.z(), p.y(), -p.x()); }};
  for (const auto& turn : turns) {
    TriangleSurface turned = before;
    for (Vector3d& p : turned.vertices) p = turn(p);
    const auto found = absolute_curvatures(turned);
    for (std::size_t v = 0; v < found.size(); ++v)
      EXPECT_NEAR(found[v], expected[v], 1e-9 * expected[v]) << v;
  }
}

TEST(Curvature, NumberingDoesNotMatter) {
  const TriangleSurface before = corpus::make_surface("random:seed=4,n=1000");
  const auto expected = absolute_curvatures(before);
  const auto n = static_cast<Index>(before.vertices.size());
  TriangleSurface renumbered = before;
  for (Index v = 0; v < n; ++v) renumbered.vertices[n - 1 - v] = before.vertices[v];
  for (auto& t : renumbered.triangles)
    for (Index& v : t) v = n - 1 - v;
  std::reverse(renumbered.triangles.begin(), renumbered.triangles.end());
  const auto found = absolute_curvatures(renumbered);
  for (Index v = 0; v < n; ++v) EXPECT_EQ(found[n - 1 - v], expected[v]) << v;
}

// The vertex has three neighbours, and two of them are opposite to each other as seen along the normal. They
// do not determine c11, so the second ring is used, too. The heights are those of a quadric, which two rings
// reproduce.
TEST(Curvature, SecondRingAtAVertexOfThreeTriangles) {
  const double c20 = 2 * std::sqrt(2.0), c11 = 0.5, c02 = 2;
  const auto on_quadric = [&](double x, double y) {
    return Vector3d(x, y, (c20 * x * x + 2 * c11 * x * y + c02 * y * y) / 2);
  };
  TriangleSurface surface;
  surface.vertices = {{0, 0, 0},        on_quadric(1, 0),  on_quadric(0, 1), on_quadric(-1, 0),
                      on_quadric(2, 2), on_quadric(-2, 2), on_quadric(0, -3)};
  surface.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 4, 2}, {2, 5, 3}, {3, 6, 1}};
  const double expected = c20 + c02;  // both curvatures are positive: c20 c02 > c11^2
  EXPECT_NEAR(absolute_curvatures(surface)[0], expected, 1e-7);
  // Without the second ring nothing determines c11.
  surface.triangles.resize(3);
  EXPECT_EQ(absolute_curvatures(surface)[0], 0);
}

TEST(Curvature, FlatAndUnusedVerticesHaveNone) {
  const TriangleSurface box = corpus::make_surface("box:x1=3,y1=3,z1=3,n=3");
  const auto found = absolute_curvatures(box);
  int flat = 0;
  for (std::size_t v = 0; v < found.size(); ++v) {
    const Vector3d& p = box.vertices[v];
    int inner = 0;
    for (int x = 0; x < 3; ++x) inner += p[x] > 0 && p[x] < 3;
    if (inner == 2) {
      EXPECT_NEAR(found[v], 0, 1e-14);
      ++flat;
    } else {
      EXPECT_GT(found[v], 0.1);
    }
  }
  EXPECT_EQ(flat, 6 * 4);

  TriangleSurface unused = box;
  unused.vertices.push_back({9, 9, 9});
  EXPECT_EQ(absolute_curvatures(unused).back(), 0);
}

TEST(OutlierRatio, LargestOverThe99thPercentile) {
  std::vector<double> values;
  for (int i = 1; i <= 101; ++i) values.push_back(i);  // the 99th percentile of 101 values is the 100th
  EXPECT_EQ(outlier_ratio(values), 101.0 / 100);
  values.back() = 5000;
  EXPECT_EQ(outlier_ratio(values), 50);
  std::reverse(values.begin(), values.end());
  EXPECT_EQ(outlier_ratio(values), 50);
  EXPECT_EQ(outlier_ratio(std::vector<double>(10, 3.0)), 1);
  EXPECT_EQ(outlier_ratio({}), 1);
  std::vector<double> flat(1000, 0.0);
  EXPECT_EQ(outlier_ratio(flat), 1);
  flat[7] = 3;
  EXPECT_EQ(outlier_ratio(flat), HUGE_VAL) << "a few spikes on a flat body";
}

}  // namespace
}  // namespace tetproof::reference
