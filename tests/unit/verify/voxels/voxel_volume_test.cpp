// SPDX-License-Identifier: GPL-3.0-or-later
// The voxel account: its bound and its convergence, shapes on which a flood fill would fail, and changes that
// must not matter.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <random>

#include "corpus/random_surface.hpp"
#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "verify/voxel_volume.hpp"
#include "verify/voxels/surface_voxels.hpp"

namespace tetproof::verify {
namespace {

TriangleSurface surface_of(const std::string& name) {
  const bool file = name.find('.') != std::string::npos && name.find(':') == std::string::npos;
  return corpus::open_surface(file ? TETPROOF_SOURCE_DIR "/corpus/surfaces/" + name : name);
}

double polyhedron_volume(const TriangleSurface& surface) {
  long double sum = 0;
  for (const auto& [a, b, c] : surface.triangles)
    sum += surface.vertices[a]
               .cast<long double>()
               .cross(surface.vertices[b].cast<long double>())
               .dot(surface.vertices[c].cast<long double>());
  return static_cast<double>(std::abs(sum) / 6);
}

// Everything the account says, flags included.
std::vector<bool> flags(const VoxelVolume& volume) {
  std::vector<bool> all;
  for (int i = 0; i < volume.voxels[0]; ++i)
    for (int j = 0; j < volume.voxels[1]; ++j)
      for (int k = 0; k < volume.voxels[2]; ++k) {
        all.push_back(is_inside(volume, i, j, k));
        all.push_back(meets_surface(volume, i, j, k));
      }
  return all;
}

void expect_same(const VoxelVolume& a, const VoxelVolume& b) {
  EXPECT_EQ(a.inside, b.inside);
  EXPECT_EQ(a.error_bound, b.error_bound);
  EXPECT_EQ(a.voxel_size, b.voxel_size);
  EXPECT_EQ(a.origin, b.origin);
  ASSERT_EQ(a.voxels, b.voxels);
  EXPECT_EQ(flags(a), flags(b));
}

class VoxelBound : public testing::TestWithParam<const char*> {};

TEST_P(VoxelBound, HoldsForEverySize) {
  const TriangleSurface surface = surface_of(GetParam());
  const double exact = polyhedron_volume(surface);
  for (const int n : {2, 3, 7, 16, 50, 128}) {
    const VoxelVolume volume = voxel_volume(surface, n);
    EXPECT_LE(std::abs(volume.inside - exact), volume.error_bound) << n;
    // The numbers of voxels agree with the sets, and the voxels cover the box with at least one more layer.
    const std::vector<bool> all = flags(volume);
    std::int64_t inside = 0, met = 0;
    for (std::size_t i = 0; i < all.size(); i += 2) inside += all[i], met += all[i + 1];
    EXPECT_EQ(inside, volume.inside_count);
    EXPECT_EQ(met, volume.met_count);
    EXPECT_EQ(volume.inside, static_cast<double>(inside) * std::pow(volume.voxel_size, 3));
    Eigen::Vector3d low = surface.vertices[0], high = low;
    for (const Eigen::Vector3d& v : surface.vertices) low = low.cwiseMin(v), high = high.cwiseMax(v);
    EXPECT_LE(volume.voxel_size, (high - low).maxCoeff() / n * (1 + 1.0 / 2048));
    EXPECT_GE(volume.voxel_size, (high - low).maxCoeff() / n);
    EXPECT_TRUE(((low - volume.origin).array() >= volume.voxel_size).all());
    const Eigen::Vector3d top =
        volume.origin +
        volume.voxel_size * Eigen::Vector3d(volume.voxels[0], volume.voxels[1], volume.voxels[2]);
    EXPECT_TRUE(((top - high).array() > 0).all());
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, VoxelBound,
                         testing::Values("sphere", "torus", "wing:n=2000",
                                         "random:seed=7,roughness=0.9,waves=4", "shells:count=3",
                                         "shells:inner=0.99", "octahedron", "box:n=3", "groove",
                                         "terrain:m=9", "hollow:wall=0.01", "hollow:wall=1e-6",
                                         "bottle:neck=0.01", "pair:gap=0.01", "sphere:r=1e-6,x=1",
                                         "box:x1=1e-5,y1=0.01", "Cray_left.obj", "hull-body.obj",
                                         "plate_holes.STL", "spot.obj", "ct_skull.off"),
                         [](const auto& instance) {
                           std::string name = std::to_string(instance.index) + "_";
                           for (char c : std::string(instance.param))
                             name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
                           return name;
                         });

TEST(VoxelVolume, BoundHoldsOnRandomSurfaces) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const TriangleSurface surface = corpus::random_closed_surface(seed);
    if (corpus::describe_random_surface(seed).find("scaled") != std::string::npos)
      continue;  // one body in the other with equal orientation: the volume is not the signed sum
    const VoxelVolume volume = voxel_volume(surface, 5 + static_cast<int>(seed % 30));
    EXPECT_LE(std::abs(volume.inside - polyhedron_volume(surface)), volume.error_bound) << "seed " << seed;
  }
}

// Counting voxel centres converges with second order on a sphere, wherever it is. A torus is level along
// whole circles. The planes of centres meet it there like a square root, which costs half an order.
TEST(VoxelVolume, Converges) {
  const TriangleSurface sphere = surface_of("sphere:n=20000,x=0.1,y=0.2,z=0.3"),
                        torus = surface_of("torus:n=20000");
  const double of_sphere = polyhedron_volume(sphere), of_torus = polyhedron_volume(torus);
  for (const int n : {16, 32, 64, 128, 256}) {
    const VoxelVolume s = voxel_volume(sphere, n), t = voxel_volume(torus, n);
    EXPECT_LT(std::abs(s.inside / of_sphere - 1), 2.0 / (n * n)) << n;
    EXPECT_LT(std::abs(t.inside / of_torus - 1), 4.0 / std::pow(n, 1.5)) << n;
    // The bound is of first order. It counts the voxels that meet the surface: at most (|n_x| + |n_y| + |n_z|
    // + ...) for each area of one voxel face.
    EXPECT_LT(s.error_bound / of_sphere, 10.0 / n) << n;
    EXPECT_LT(t.error_bound / of_torus, 22.0 / n) << n;
  }
}

TEST(VoxelVolume, CavitiesAreNotFilled) {
  const TriangleSurface surface = surface_of("shells:count=3,inner=0.2,n=6000");  // radii 1, 0.6, 0.2
  const VoxelVolume volume = voxel_volume(surface, 64);
  EXPECT_NEAR(volume.inside / polyhedron_volume(surface), 1, 2e-3);
  for (int i = 0; i < volume.voxels[0]; ++i)
    for (int j = 0; j < volume.voxels[1]; ++j)
      for (int k = 0; k < volume.voxels[2]; ++k) {
        if (meets_surface(volume, i, j, k)) continue;
        const double r = voxel_centre(volume, i, j, k).norm();
        ASSERT_EQ(is_inside(volume, i, j, k), r < 0.2 || (r > 0.6 && r < 1)) << i << ' ' << j << ' ' << k;
      }
}

TEST(VoxelVolume, CavityOfAFile) {
  // Two concentric spheres: 6.58855e13 - 6.39286e13 by the file's published volumes.
  const VoxelVolume volume = voxel_volume(surface_of("Cray_left.obj"), 512);
  EXPECT_NEAR(volume.inside, 1.95686465e12, 0.02e12);
  const int middle[3] = {volume.voxels[0] / 2, volume.voxels[1] / 2, volume.voxels[2] / 2};
  EXPECT_FALSE(is_inside(volume, middle[0], middle[1], middle[2]));
}

TEST(VoxelVolume, ShellThinnerThanAVoxel) {
  const TriangleSurface surface = surface_of("hollow:m=6,wall=0.02");
  for (const int n : {10, 20, 40}) {  // voxels of 0.6, 0.3, 0.15
    const VoxelVolume volume = voxel_volume(surface, n);
    int wrong = 0;
    for (int i = 0; i < volume.voxels[0]; ++i)
      for (int j = 0; j < volume.voxels[1]; ++j)
        for (int k = 0; k < volume.voxels[2]; ++k) {
          const Eigen::Array3d c = voxel_centre(volume, i, j, k).array();
          const bool in_cube = (c > 0).all() && (c < 6).all(), in_void = (c > 0.02).all() && (c < 5.98).all();
          wrong += is_inside(volume, i, j, k) != (in_cube && !in_void);
        }
    EXPECT_EQ(wrong, 0) << n;
    EXPECT_LE(std::abs(volume.inside - polyhedron_volume(surface)), volume.error_bound) << n;
  }
}

TEST(VoxelVolume, BottleWithANeckOfHalfAVoxel) {
  const TriangleSurface surface =
      surface_of("bottle:m=6,wall=1,neck=0.25");         // the void: 4^3, and a neck of 0.25^2
  const VoxelVolume volume = voxel_volume(surface, 12);  // voxels of 0.5
  EXPECT_EQ(volume.voxel_size, 0.5);
  EXPECT_NEAR(volume.inside, 216 - 64 - 0.0625, 0.25 * 216);
  int wrong = 0;
  for (int i = 0; i < volume.voxels[0]; ++i)
    for (int j = 0; j < volume.voxels[1]; ++j)
      for (int k = 0; k < volume.voxels[2]; ++k) {
        const Eigen::Array3d c = voxel_centre(volume, i, j, k).array();
        const bool in_cube = (c > 0).all() && (c < 6).all(), in_void = (c > 1).all() && (c < 5).all();
        const bool in_neck = std::abs(c[0] - 3) < 0.125 && std::abs(c[1] - 3) < 0.125 && c[2] >= 5;
        wrong += is_inside(volume, i, j, k) != (in_cube && !in_void && !in_neck);
      }
  EXPECT_EQ(wrong, 0);
}

// A cube of 8 voxels along each edge. Its faces are in voxel planes, or pass through voxel centres, where
// every decision is a tie. Cut in several ways.
TEST(VoxelVolume, TiesAreCountedOnce) {
  const VoxelVolume any = voxel_volume(surface_of("box"), 8);
  ASSERT_EQ(any.voxel_size, 0.125);
  for (const double half : {0.0, 0.0625}) {
    const Eigen::Vector3d low = any.origin + Eigen::Vector3d::Constant(half);
    for (const int n : {1, 2, 3, 8}) {
      TriangleSurface cube = surface_of("box:n=" + std::to_string(n));
      for (Eigen::Vector3d& v : cube.vertices) v += low;
      const VoxelVolume volume = voxel_volume(cube, 8);
      ASSERT_EQ(volume.voxel_size, 0.125);
      EXPECT_EQ(volume.inside_count, 512) << half << ' ' << n;
      EXPECT_EQ(volume.inside, 1) << half << ' ' << n;
      // In voxel planes: the layers on both sides of each face, 10^3 - 6^3. Through centres: the layer of
      // these voxels, 9^3 - 7^3.
      EXPECT_EQ(volume.met_count, half == 0 ? 784 : 386) << half << ' ' << n;
    }
  }
}

TEST(VoxelVolume, SameForAnyNumberOfThreads) {
  for (const char* name : {"ct_skull.off", "terrain:m=20", "shells:n=20000"}) {
    const TriangleSurface surface = surface_of(name);
    std::vector<VoxelVolume> volumes;
    for (const int threads : {1, 2, 7}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      volumes.push_back(voxel_volume(surface, 100));
    }
    expect_same(volumes[0], volumes[1]);
    expect_same(volumes[0], volumes[2]);
  }
}

TEST(VoxelVolume, SameForAnyNumberingAndOrientation) {
  std::mt19937_64 random(20261122);
  for (const char* name : {"random:n=2000,roughness=0.9", "terrain:m=8", "hull-body.obj", "octahedron"}) {
    const TriangleSurface surface = surface_of(name);
    TriangleSurface other;
    std::vector<Index> place(surface.vertices.size());
    std::iota(place.begin(), place.end(), 0);
    std::shuffle(place.begin(), place.end(), random);
    other.vertices.resize(surface.vertices.size());
    for (std::size_t v = 0; v < place.size(); ++v) other.vertices[place[v]] = surface.vertices[v];
    for (auto [a, b, c] : surface.triangles) {
      switch (random() % 3) {  // cyclic
        case 1:
          std::swap(a, b), std::swap(b, c);
          break;
        case 2:
          std::swap(a, c), std::swap(b, c);
          break;
        default:
          break;
      }
      other.triangles.push_back({place[a], place[b], place[c]});
    }
    std::shuffle(other.triangles.begin(), other.triangles.end(), random);
    const VoxelVolume volume = voxel_volume(surface, 40);
    expect_same(volume, voxel_volume(other, 40));
    for (auto& [a, b, c] : other.triangles) std::swap(b, c);
    expect_same(volume, voxel_volume(other, 40));
  }
}

TEST(VoxelVolume, ScalesByPowersOfTwo) {
  TriangleSurface surface = surface_of("random:n=2000,roughness=0.8");
  const VoxelVolume volume = voxel_volume(surface, 50);
  for (Eigen::Vector3d& v : surface.vertices) v *= 1024;
  const VoxelVolume scaled = voxel_volume(surface, 50);
  EXPECT_EQ(scaled.inside, volume.inside * 1024 * 1024 * 1024);
  EXPECT_EQ(flags(scaled), flags(volume));
  for (const int exponent : {-300, 260, 310}) {
    TriangleSurface other = surface;  // is scaled by 2^10 already
    for (Eigen::Vector3d& v : other.vertices) v *= std::ldexp(1, exponent);
    const VoxelVolume there = voxel_volume(other, 50);
    EXPECT_EQ(there.inside, scaled.inside * std::ldexp(1, 3 * exponent)) << exponent;
    EXPECT_EQ(there.error_bound, scaled.error_bound * std::ldexp(1, 3 * exponent)) << exponent;
    EXPECT_EQ(flags(there), flags(volume)) << exponent;
  }
}

TEST(VoxelVolume, RefusesInOneLine) {
  const auto error_of = [](const TriangleSurface& surface, int n) -> std::string {
    try {
      voxel_volume(surface, n);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  const TriangleSurface sphere = surface_of("sphere:n=200");
  EXPECT_EQ(error_of(sphere, 1), "voxels along the longest side: expected 2 to 1024, found 1");
  EXPECT_EQ(error_of(sphere, 1025), "voxels along the longest side: expected 2 to 1024, found 1025");
  EXPECT_EQ(error_of({}, 8), "the surface has no triangles");
  TriangleSurface bad = sphere;
  bad.triangles[3][1] = 1000;
  EXPECT_EQ(error_of(bad, 8), "triangle 3 names vertex 1000, which the surface does not have");
  bad.triangles[3][1] = -1;
  EXPECT_EQ(error_of(bad, 8), "triangle 3 names vertex -1, which the surface does not have");
  bad = sphere;
  bad.vertices[5][2] = NAN;
  EXPECT_EQ(error_of(bad, 8), "vertex 5 of the surface is not finite");
  bad = sphere;
  for (Eigen::Vector3d& v : bad.vertices) v = {1, 2, 3};
  EXPECT_EQ(error_of(bad, 8), "the longest side of the surface's box is 0, expected 1e-98 to 1e98");
  bad = sphere;
  for (Eigen::Vector3d& v : bad.vertices) v[0] += 1e12;
  EXPECT_EQ(error_of(bad, 1024).substr(0, 70),
            "the surface is too far from the origin for 1024 voxels along its longe");
  bad = sphere;
  bad.triangles.pop_back();
  EXPECT_EQ(error_of(bad, 64).substr(0, 43), "the surface is open: a line along z at x = ");
}

TEST(VoxelVolume, KeptVoxelsAreMadeOnceAndTheSame) {
  const TriangleSurface surface = surface_of("torus:n=800");
  verify::KeptVoxels kept;
  const auto voxels = kept.of(surface, 40);
  EXPECT_EQ(kept.of(surface, 40), voxels);
  expect_same(voxels->volume, voxel_volume(surface, 40));
  EXPECT_EQ(voxels->error_estimate, std::abs(voxels->volume.inside - voxel_volume(surface, 20).inside));
  const auto fewer = kept.of(surface, 3);
  EXPECT_FALSE(fewer->error_estimate) << "half of three voxels are below the least number";
  expect_same(fewer->volume, voxel_volume(surface, 3));
  EXPECT_EQ(voxels->volume.inside, voxel_volume(surface, 40).inside) << "who still holds them has them";
}

TEST(VoxelVolume, OutsideTheLatticeIsNothing) {
  const VoxelVolume volume = voxel_volume(surface_of("box"), 8);
  for (const int far : {-1, -1000000, volume.voxels[0], 1 << 30}) {
    EXPECT_FALSE(is_inside(volume, far, 4, 4));
    EXPECT_FALSE(meets_surface(volume, 4, far, 4));
  }
  EXPECT_FALSE(is_inside({}, 0, 0, 0));
}

}  // namespace
}  // namespace tetproof::verify
