// SPDX-License-Identifier: GPL-3.0-or-later
// Every voxel's flags against exact rational arithmetic: a ray in general direction, and CGAL's box-triangle
// test.
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>

#include <optional>

#include "corpus/random_surface.hpp"
#include "corpus/surfaces.hpp"
#include "verify/voxel_volume.hpp"

namespace tetproof::verify {
namespace {

using Rational = CGAL::Gmpq;
using Kernel = CGAL::Simple_cartesian<Rational>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

Point exact(const Eigen::Vector3d& v) {
  return {Rational(v[0]), Rational(v[1]), Rational(v[2])};
}

int orientation(const Vector& a, const Vector& b, const Vector& c) {
  return CGAL::sign(CGAL::determinant(a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z()));
}

// Whether the surface encloses p an odd number of times; nothing if p is on the surface. The ray turns until
// it meets no edge and no vertex.
std::optional<bool> enclosed(const std::vector<std::array<Point, 3>>& triangles, const Point& p) {
  for (const auto& t : triangles)
    if (orientation(t[0] - p, t[1] - p, t[2] - p) == 0 && Kernel::Triangle_3(t[0], t[1], t[2]).has_on(p))
      return std::nullopt;
  for (int turn = 0; turn < 100; ++turn) {
    const Vector ray(1000 + 37 * turn, 313 - 91 * turn, 171 + 53 * turn);
    bool odd = false, general = true;
    for (const auto& t : triangles) {
      const Vector a = t[0] - p, b = t[1] - p, c = t[2] - p;
      const int ab = orientation(ray, a, b), bc = orientation(ray, b, c), ca = orientation(ray, c, a);
      const bool some_positive = ab > 0 || bc > 0 || ca > 0, some_negative = ab < 0 || bc < 0 || ca < 0;
      if (some_positive && some_negative) continue;  // the line misses the triangle
      if (ab == 0 || bc == 0 || ca == 0) {
        general = false;
        break;
      }
      // The line passes through the triangle. It does so in front of p if the tetrahedron p a b c has the
      // orientation in which the ray sees the triangle.
      if (orientation(a, b, c) == ab) odd = !odd;
    }
    if (general) return odd;
  }
  ADD_FAILURE() << "no ray in general position";
  return std::nullopt;
}

// Whether the boxes around the two separate them.
bool apart(const Kernel::Iso_cuboid_3& box, const std::array<Point, 3>& t) {
  for (int axis = 0; axis < 3; ++axis) {
    if (t[0][axis] < box.min()[axis] && t[1][axis] < box.min()[axis] && t[2][axis] < box.min()[axis])
      return true;
    if (t[0][axis] > box.max()[axis] && t[1][axis] > box.max()[axis] && t[2][axis] > box.max()[axis])
      return true;
  }
  return false;
}

void compare(const TriangleSurface& surface, int n, const std::string& name) {
  std::vector<std::array<Point, 3>> triangles;
  for (const auto& [a, b, c] : surface.triangles)
    triangles.push_back({exact(surface.vertices[a]), exact(surface.vertices[b]), exact(surface.vertices[c])});
  const VoxelVolume volume = voxel_volume(surface, n);
  const Rational h(volume.voxel_size), grown = h / 1000000000;
  int inside = 0;
  for (int i = 0; i < volume.voxels[0]; ++i)
    for (int j = 0; j < volume.voxels[1]; ++j)
      for (int k = 0; k < volume.voxels[2]; ++k) {
        const Point low = exact(volume.origin) + Vector(h * i, h * j, h * k), high = low + Vector(h, h, h);
        const Point centre = CGAL::midpoint(low, high);
        ASSERT_EQ(centre, exact(voxel_centre(volume, i, j, k)));
        const std::optional<bool> truth = enclosed(triangles, centre);
        if (truth) {
          ASSERT_EQ(is_inside(volume, i, j, k), *truth) << name << ": voxel " << i << ' ' << j << ' ' << k;
          inside += *truth;
        }
        const Kernel::Iso_cuboid_3 voxel(low, high),
            wider(low - Vector(grown, grown, grown), high + Vector(grown, grown, grown));
        bool met = false, nearly = false;
        for (const auto& t : triangles) {
          const Kernel::Triangle_3 triangle(t[0], t[1], t[2]);
          if (apart(wider, t) || !CGAL::do_intersect(wider, triangle)) continue;
          nearly = true;
          if (CGAL::do_intersect(voxel, triangle)) {
            met = true;
            break;
          }
        }
        const bool flag = meets_surface(volume, i, j, k);
        ASSERT_TRUE(flag || !met) << name << ": voxel " << i << ' ' << j << ' ' << k
                                  << " is met and not flagged";
        ASSERT_TRUE(!flag || nearly) << name << ": voxel " << i << ' ' << j << ' ' << k
                                     << " is flagged and far away";
      }
  EXPECT_GT(inside, 0) << name;
}

TEST(VoxelsExactly, OnRandomSurfaces) {
  int compared = 0;
  for (std::uint64_t seed = 0; compared < 8; ++seed) {
    const TriangleSurface surface = corpus::random_closed_surface(seed);
    if (surface.triangles.size() > 80) continue;
    compare(surface, 5, "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
    ++compared;
  }
}

// Faces, edges and vertices through centres and in voxel planes.
TEST(VoxelsExactly, WhereTheSurfaceFollowsTheVoxels) {
  const VoxelVolume any = voxel_volume(corpus::make_surface("box:x1=4,y1=4,z1=4"), 4);
  ASSERT_EQ(any.voxel_size, 1);
  for (const double shift : {0.0, 0.5})
    for (const char* spec : {"groove:m=4,h=1", "octahedron:rx=2,ry=2,rz=2", "terrain:m=4,seed=5",
                             "box:x1=4,y1=4,z1=4,n=3", "octahedron:rx=2,ry=1.5,rz=2"}) {
      TriangleSurface surface = corpus::make_surface(spec);
      for (Eigen::Vector3d& v : surface.vertices) v += any.origin + Eigen::Vector3d::Constant(shift);
      compare(surface, 4, spec);
      if (HasFatalFailure()) return;
    }
}

TEST(VoxelsExactly, OnSliversFarFromTheOrigin) {
  TriangleSurface surface = corpus::make_surface("wing:naca=2404,n=20,span=0.3");
  for (Eigen::Vector3d& v : surface.vertices)
    v += Eigen::Vector3d(1e6, -3e5, 7e4) + 1e-3 * Eigen::Vector3d(v[1], v[2], v[0]);
  compare(surface, 9, "wing");
}

}  // namespace
}  // namespace tetproof::verify
