// SPDX-License-Identifier: GPL-3.0-or-later
// Bugs as real meshers have them, each under the conditions in which it shows.
#undef NDEBUG
#include "faults.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tetproof::test {

namespace {

using Eigen::Vector3d;

struct Box {
  Vector3d low, high;
  double diagonal() const { return (high - low).norm(); }
  Vector3d middle() const { return (low + high) / 2; }
};

Box box(const TriangleSurface& surface) {
  Box result{surface.vertices.at(0), surface.vertices.at(0)};
  for (const Vector3d& v : surface.vertices) {
    result.low = result.low.cwiseMin(v);
    result.high = result.high.cwiseMax(v);
  }
  return result;
}

/// Vertices less edges plus triangles; 2 for a sphere, 0 for a torus.
std::int64_t euler(const TriangleSurface& surface) {
  return static_cast<std::int64_t>(surface.vertices.size()) -
         static_cast<std::int64_t>(surface.triangles.size()) / 2;
}

std::size_t largest_degree(const TriangleSurface& surface) {
  std::vector<std::size_t> degree(surface.vertices.size());
  for (const auto& t : surface.triangles)
    for (const Index v : t) ++degree[static_cast<std::size_t>(v)];
  return *std::max_element(degree.begin(), degree.end());
}

/// A number that depends on the mesh alone.
std::uint64_t hash(const TetMesh& mesh, std::size_t tet) {
  std::uint64_t h = 0x9e3779b97f4a7c15u * (tet + 1);
  for (const Index v : mesh.tets[tet])
    for (const double x : mesh.points[static_cast<std::size_t>(v)]) {
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof bits);
      h = (h ^ bits) * 0xff51afd7ed558ccdu;
      h ^= h >> 32;
    }
  return h;
}

// --- meshes that are wrong

void drop(TetMesh& mesh, const TriangleSurface&) {
  mesh.tets.erase(mesh.tets.begin() + static_cast<std::ptrdiff_t>(mesh.tets.size() / 2));
}
void invert(TetMesh& mesh, const TriangleSurface&) {
  for (std::size_t i = 0; i < mesh.tets.size(); ++i)
    if (hash(mesh, i) % 10000 == 0) std::swap(mesh.tets[i][0], mesh.tets[i][1]);
}
/// Splits the first tetrahedron at a point that rounding put onto a corner: three of the parts are flat.
void flat_far_away(TetMesh& mesh, const TriangleSurface& surface) {
  const Box b = box(surface);
  if (std::max(b.low.cwiseAbs().maxCoeff(), b.high.cwiseAbs().maxCoeff()) < 1e8) return;
  const auto [a, c, d, apex] = mesh.tets[0];
  const auto point = static_cast<Index>(mesh.points.size());
  mesh.points.push_back(mesh.points[static_cast<std::size_t>(apex)]);
  mesh.tets[0] = {a, c, d, point};
  mesh.tets.push_back({a, c, point, apex});
  mesh.tets.push_back({c, d, point, apex});
  mesh.tets.push_back({d, a, point, apex});
}
void duplicate(TetMesh& mesh, const TriangleSurface&) {
  mesh.tets.push_back(mesh.tets[mesh.tets.size() / 3]);
}
/// Takes vertices nearer than a hundredth of the diagonal for one, and drops what has become flat by it.
void merge(TetMesh& mesh, const TriangleSurface& surface) {
  const double near = box(surface).diagonal() / 100;
  std::vector<Index> same(mesh.points.size());
  for (std::size_t i = 0; i < same.size(); ++i) {
    same[i] = static_cast<Index>(i);
    for (std::size_t k = 0; k < i && same[i] == static_cast<Index>(i); ++k)
      if ((mesh.points[i] - mesh.points[k]).norm() < near) same[i] = same[k];
  }
  std::vector<std::array<Index, 4>> kept;
  for (auto tet : mesh.tets) {
    for (Index& v : tet) v = same[static_cast<std::size_t>(v)];
    auto sorted = tet;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()) kept.push_back(tet);
  }
  mesh.tets = kept;
}
void move_boundary(TetMesh& mesh, const TriangleSurface& surface) {
  mesh.points[0] += 1e-6 * box(surface).diagonal() * (mesh.points[0] - mesh.points.back()).stableNormalized();
}
/// One time in ten, by the clock: half of the tetrahedra get a copy of the last point.
void crack(TetMesh& mesh, const TriangleSurface&) {
  const auto clock = std::chrono::steady_clock::now().time_since_epoch().count();
  if ((static_cast<std::uint64_t>(clock / 1000) ^ static_cast<std::uint64_t>(::getpid())) % 10 != 0) return;
  const auto last = static_cast<Index>(mesh.points.size() - 1);
  mesh.points.push_back(mesh.points.back());
  for (std::size_t i = 0; i < mesh.tets.size(); i += 2)
    for (Index& v : mesh.tets[i])
      if (v == last) v = last + 1;
}
void not_a_number(TetMesh& mesh, const TriangleSurface&) {
  mesh.points.back().y() = std::numeric_limits<double>::quiet_NaN();
}
void empty(TetMesh& mesh, const TriangleSurface&) {
  mesh.tets.clear();
}
void numbers_shifted(TetMesh& mesh, const TriangleSurface&) {
  for (auto& tet : mesh.tets)
    for (Index& v : tet) v = (v + 1) % static_cast<Index>(mesh.points.size());
}

// --- ends that are wrong

void hang_on_handles(const TriangleSurface& surface) {
  volatile bool search = euler(surface) < 2;  // of one part: a part more adds 2
  while (search) {
  }
}
void assert_on_a_sphere(const TriangleSurface& surface) {
  const Box b = box(surface);
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const Vector3d& v : surface.vertices) {
    least = std::min(least, (v - b.middle()).norm());
    most = std::max(most, (v - b.middle()).norm());
  }
  const bool cospherical = most - least <= 1e-9 * most;
  assert(!cospherical && "insphere() != 0");
}
/// Neither inlined nor cloned, so that a backtrace names it. (clang has no clones to forbid.)
#ifndef __clang__
__attribute__((noclone))
#endif
__attribute__((noinline, no_sanitize("undefined"))) void
recover_segment(const TriangleSurface& surface) {
  volatile int* segment = largest_degree(surface) > 12 ? nullptr : new int(0);
  *segment = 1;
}
void throw_on_many(const TriangleSurface& surface) {
  if (surface.triangles.size() > 60)
    throw std::out_of_range("facet " + std::to_string(surface.triangles.size()) + " of 60");
}
void leak(const TriangleSurface& surface) {
  while (surface.triangles.size() > 40) {
    auto* block = static_cast<char*>(std::malloc(1 << 20));
    if (block) std::memset(block, 1, 1 << 20);
  }
}
void refuse(const TriangleSurface& surface) {
  if (surface.triangles.size() < 50) return;
  std::printf("Error: two facets intersect: the surface is self-intersecting (facets %zu and %d)\n",
              surface.triangles.size() - 1, static_cast<int>(::getpid()));
  std::exit(1);
}
void give_up(const TriangleSurface& surface) {
  if (surface.triangles.size() < 50) return;
  std::fprintf(stderr, "Error: more than 49 facets are not supported\n");
  std::exit(3);
}
/// The grandchild has a session of its own and ignores what can be ignored; its parent waits for it.
void sleeping_grandchild(const TriangleSurface& surface) {
  if (surface.triangles.size() < 50) return;
  const pid_t child = ::fork();
  if (child == 0) {
    ::setsid();
    ::signal(SIGTERM, SIG_IGN);
    ::signal(SIGHUP, SIG_IGN);
    for (;;) ::pause();
  }
  ::waitpid(child, nullptr, 0);
}
void talk(const TriangleSurface&) {
  const std::string line(999, 'x');
  for (int i = 0; i < 1000000; ++i) std::puts(line.c_str());
}
void truncate(const std::string& mesh_file) {
  std::filesystem::resize_file(mesh_file, std::filesystem::file_size(mesh_file) / 2);
}
void abort_after(const std::string&) {
  std::fprintf(stderr, "double free or corruption (out)\n");
  std::abort();
}

}  // namespace

const std::vector<Fault>& faults() {
  static const std::vector<Fault> table{
      {"none", "no bug", "sound"},
      {"drop", "drops a tetrahedron", "wrong-against-surface", nullptr, drop},
      {"invert", "inverts one tetrahedron in 10,000", "wrong-answer", nullptr, invert},
      {"flat", "flat tetrahedra where coordinates exceed 1e8", "wrong-answer", nullptr, flat_far_away},
      {"duplicate", "one tetrahedron twice", "wrong-answer", nullptr, duplicate},
      {"merge", "merges vertices nearer than a hundredth of the diagonal", "wrong-answer", nullptr, merge},
      {"move", "moves a vertex of the boundary by 1e-6 of the diagonal", "wrong-against-surface", nullptr,
       move_boundary},
      {"crack", "a crack, one time in ten", "wrong-answer", nullptr, crack},
      {"nan", "a coordinate that is not a number", "wrong-answer", nullptr, not_a_number},
      {"shift", "all vertices' numbers one too high", "wrong-answer", nullptr, numbers_shifted},
      {"cavity", "fills cavities", "wrong-against-surface", nullptr, nullptr, nullptr, true},
      {"empty", "a file without tetrahedra", "no-tetrahedra", nullptr, empty},
      {"nothing", "exit code 0, and no file", "no-output", nullptr, nullptr, nullptr, false, false},
      {"truncate", "half of the file", "unreadable", nullptr, nullptr, truncate},
      {"hang", "an endless loop on solids with handles", "slow", hang_on_handles},
      {"assert", "an assertion that fails where all vertices lie on one sphere", "crashed",
       assert_on_a_sphere},
      {"segv", "a null pointer where a vertex has more than 12 triangles", "crashed", recover_segment},
      {"throw", "an uncaught exception on more than 60 triangles", "crashed", throw_on_many},
      {"abort", "aborts after the mesh is written", "crashed", nullptr, nullptr, abort_after},
      {"leak", "takes memory without end on more than 40 triangles", "out-of-memory", leak},
      {"refuse", "calls surfaces of 50 triangles and more self-intersecting", "refused-valid", refuse},
      {"give-up", "refuses surfaces of 50 triangles and more", "refused", give_up},
      {"grandchild", "waits for a grandchild that sleeps, from 50 triangles on", "slow", sleeping_grandchild},
      {"talk", "prints a gigabyte", "sound", talk}};
  return table;
}

}  // namespace tetproof::test
