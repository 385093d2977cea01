// SPDX-License-Identifier: GPL-3.0-or-later
// Properties that hold at every step of the adaptation of a random first grid.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <map>

#include "corpus/random_surface.hpp"
#include "corpus/surfaces.hpp"
#include "reference/generate.hpp"
#include "verify/verify.hpp"

namespace {

using namespace tetproof;
using reference::AdaptOptions;
using reference::Criterion;
using reference::generate;
using reference::Generation;
using reference::Region;

struct Case {
  std::uint64_t seed;
  reference::Options options;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  const auto& [nx, ny, nz] = c.options.cells;
  const AdaptOptions& a = *c.options.adapt;
  return out << "surface seed " << c.seed << ", cells " << nx << ',' << ny << ',' << nz << ", region "
             << (c.options.region == Region::inside ? "inside" : "outside") << ", on-surface "
             << c.options.on_surface << ", points " << a.points << ", v0 " << a.v0.value << ", v1 "
             << a.v1.value << ", p " << a.p << ", curvature " << a.curvature << ", criterion "
             << static_cast<int>(a.improve) << ", improve below " << a.improve_below << ", past dilution "
             << a.past_dilution;
}

rc::Gen<Case> any_case() {
  const auto lattice =
      rc::gen::tuple(rc::gen::inRange<std::uint64_t>(0, 1u << 20), rc::gen::inRange(2, 7),
                     rc::gen::inRange(2, 7), rc::gen::inRange(2, 7),
                     rc::gen::element(Region::inside, Region::outside), rc::gen::element(1e-6, 0.0, 0.1));
  const auto law =
      rc::gen::tuple(rc::gen::inRange<std::int64_t>(0, 120), rc::gen::element(0.001, 0.05, 0.2, 3.0),
                     rc::gen::element(0.3, 1.0, 2.0), rc::gen::element(1.0, 0.25, 0.5, 3.0));
  const auto ways =
      rc::gen::tuple(rc::gen::arbitrary<bool>(), rc::gen::arbitrary<bool>(),
                     rc::gen::element(Criterion::none, Criterion::solid_angle, Criterion::aspect_ratio),
                     rc::gen::element(0.002, 0.02, 1.0));
  return rc::gen::map(rc::gen::tuple(lattice, law, ways), [](const auto& drawn) {
    const auto& [seed, nx, ny, nz, region, on_surface] = std::get<0>(drawn);
    const auto& [points, v0, v1, p] = std::get<1>(drawn);
    const auto& [curvature, past_dilution, improve, improve_below] = std::get<2>(drawn);
    return Case{seed,
                {.region = region,
                 .cells = {nx, ny, nz},
                 .on_surface = on_surface,
                 .adapt = AdaptOptions{.points = points,
                                       .v0 = {v0},
                                       .v1 = {v1},
                                       .p = p,
                                       .past_dilution = past_dilution,
                                       .curvature = curvature,
                                       .improve = improve,
                                       .improve_below = improve_below,
                                       .check_every_step = true}}};
  });
}

double volume_of(const TetMesh& mesh) {
  long double sum = 0;
  for (const auto& [a, b, c, d] : mesh.tets)
    sum += reference::volume(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]);
  return static_cast<double>(sum);
}

// Whether each point is on the boundary, that is, on a face of only one tetrahedron.
std::vector<bool> boundary_points(const TetMesh& mesh) {
  std::map<std::array<Index, 3>, int> faces;
  for (const auto& tet : mesh.tets)
    for (const auto& [i, j, k] : tet_faces) {
      std::array face{tet[i], tet[j], tet[k]};
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
  std::vector<bool> on_boundary(mesh.points.size(), false);
  for (const auto& [face, tets] : faces)
    if (tets == 1)
      for (const Index p : face) on_boundary[p] = true;
  return on_boundary;
}

RC_GTEST_PROP(Adaptation, EveryStepKeepsWhatMustHold, ()) {
  Case c = *any_case();
  double volume = 0, scale = 0;
  std::int64_t steps = -1;
  c.options.listener.after_step = [&](const reference::WeightedGrid& grid) {
    const TetMesh mesh = grid.grid().mesh();
    const double now = volume_of(mesh);
    if (steps++ < 0) volume = scale = now;
    RC_ASSERT(std::abs(now - volume) <= 1e-12 * scale);
    const std::vector<bool> on_boundary = boundary_points(mesh);
    for (Index p = 0; p < grid.grid().points(); ++p) {
      if (!on_boundary[p] || grid.grid().on_surface(p)) continue;
      // Then it is on the outer box, because the points on the surface are known.
      RC_ASSERT(c.options.region == Region::outside);
    }
  };
  const Generation made =
      generate(corpus::random_closed_surface(c.seed), c.options);  // check_every_step throws
  if (!made.adaptation) return;
  RC_ASSERT(steps == made.adaptation->insertions);
  const verify::Report report = verify::verify(made.mesh(), {.quality = false});
  RC_ASSERT(report.certificate.has_value() && *report.certificate);
  RC_CLASSIFY(made.adaptation->flips > 0, "flips");
  RC_CLASSIFY(made.adaptation->refused > 0, "refused");
  RC_TAG(std::string(name_of(made.adaptation->stopped)));
}

RC_GTEST_PROP(Adaptation, WithoutFlipsTheAverageFallsAtEachInsertion, ()) {
  Case c = *any_case();
  c.options.adapt->improve = Criterion::none;
  c.options.adapt->check_every_step = false;
  double last = HUGE_VAL;
  c.options.listener.after_step = [&](const reference::WeightedGrid& grid) {
    RC_ASSERT(grid.e_avg() < last);
    last = grid.e_avg();
  };
  generate(corpus::random_closed_surface(c.seed), c.options);
}

RC_GTEST_PROP(Adaptation, ScalesByTwoExactly, ()) {
  Case c = *any_case();
  c.options.adapt->check_every_step = false;
  TriangleSurface surface = corpus::random_closed_surface(c.seed);
  const Generation a = generate(surface, c.options);
  for (auto& v : surface.vertices) v *= 2;
  const Generation b = generate(surface, c.options);
  RC_ASSERT(a.mesh().tets == b.mesh().tets);
  for (std::size_t p = 0; p < a.mesh().points.size(); ++p)
    RC_ASSERT(Eigen::Vector3d(2 * a.mesh().points[p]) == b.mesh().points[p]);
  if (a.adaptation) RC_ASSERT(8 * a.adaptation->e_avg_last == b.adaptation->e_avg_last);
}

RC_GTEST_PROP(Adaptation, SameForAnyNumberOfThreadsAndAnyNumberingOfTheSurface, ()) {
  Case c = *any_case();
  c.options.adapt->check_every_step = false;
  TriangleSurface surface = corpus::random_closed_surface(c.seed), other = surface;
  const auto n = static_cast<Index>(surface.vertices.size());
  std::reverse(other.vertices.begin(), other.vertices.end());
  std::reverse(other.triangles.begin(), other.triangles.end());
  for (auto& t : other.triangles)
    for (Index& v : t) v = n - 1 - v;
  const auto with_threads = [&](const TriangleSurface& s, std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return generate(s, c.options);
  };
  const Generation one = with_threads(surface, 1), many = with_threads(other, 5);
  RC_ASSERT(one.mesh().points == many.mesh().points);
  RC_ASSERT(one.mesh().tets == many.mesh().tets);
}

RC_GTEST_PROP(Adaptation, OfAParametricSurfaceStaysPositiveAndOnIt, ()) {
  const auto n = *rc::gen::inRange(50, 600);
  const auto cells = *rc::gen::inRange(3, 9);
  const auto region = *rc::gen::element(Region::inside, Region::outside);
  const Generation made = generate(corpus::make_surface("torus:R=1,r=0.4,n=" + std::to_string(n)),
                                   {.region = region,
                                    .cells = {cells, 0, 0},
                                    .adapt = AdaptOptions{.points = 200, .v0 = {0.1}, .v1 = {1}}});
  if (!made.adaptation) return;
  const verify::Report report = verify::verify(made.mesh(), {.quality = false});
  RC_ASSERT(report[verify::Check::inverted].verdict == verify::Verdict::pass);
  RC_ASSERT(report[verify::Check::flat].verdict == verify::Verdict::pass);
  RC_ASSERT(report[verify::Check::face_shared_thrice].verdict == verify::Verdict::pass);
  RC_ASSERT(report[verify::Check::face_orientation].verdict == verify::Verdict::pass);
  // Every surface point of the first grid is on the true torus, or is counted as one that had to stay in
  // place.
  std::int64_t off = 0;
  for (std::size_t p = 0; p < made.grid.mesh.points.size(); ++p) {
    const Eigen::Vector3d& x = made.grid.mesh.points[p];
    off += made.grid.on_surface[p] && std::abs(std::hypot(std::hypot(x.x(), x.y()) - 1, x.z()) - 0.4) > 1e-13;
  }
  RC_CLASSIFY(off > 0, "some had to stay");
  RC_ASSERT(off <= made.not_mapped);
  RC_ASSERT(off >= made.not_mapped / 2);
}

}  // namespace
