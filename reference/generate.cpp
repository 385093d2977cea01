// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/generate.hpp"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>

#include "io/error.hpp"
#include "reference/engine/first_grid/contacts.hpp"
#include "reference/engine/first_grid/exact.hpp"
#include "reference/engine/first_grid/inside.hpp"
#include "reference/engine/first_grid/intersections.hpp"
#include "reference/engine/first_grid/mend.hpp"
#include "reference/trace/trace_records.hpp"

namespace tetproof::reference {
namespace {

void check(const Options& options) {
  if (!(options.on_surface >= 0 && options.on_surface <= 0.15))
    throw InputError(
        fmt::format("the on-surface tolerance must be 0 to 0.15 of the shortest cell edge, found {}",
                    options.on_surface));
  if (options.adapt) check(*options.adapt);
  if (!options.follow.empty() && !options.adapt)
    throw InputError("a trace can only be followed with an adaptation, steps (v) and (vi)");
}

}  // namespace

Generation generate(const TriangleSurface& surface, const Options& options) {
  check(options);
  const double tolerance = options.literal ? 0 : options.on_surface;
  const auto phase = [&](std::string_view name) {
    if (options.listener.phase) options.listener.phase(name);
  };
  const Recorder& record = options.listener.record;

  phase("lattice");
  const Lattice lattice = make_lattice(surface, options.cells, options.box_scale);  // (i), eq. 2.1

  phase("contacts");
  const Contacts contacts = find_contacts(lattice, surface);
  SurfaceVertices settled;  // lattice vertices that stay on the surface, reading D4
  if (tolerance > 0)
    settled.add(
        find_near_vertices(lattice, surface, tolerance * lattice.shortest_edge, [](Vertex) { return true; }));
  const std::vector<std::int8_t> inside = inside_by_parity(lattice, surface);

  Generation result;
  std::vector<Vertex> mended;  // settled because rounding had inverted a tetrahedron
  result.moved_to_surface = static_cast<std::int64_t>(settled.vertices.size());
  std::unique_ptr<InsideTest> inside_test;
  std::once_flag once;  // most surfaces have no case 5 and need no test
  const auto keep_case_5 = [&](const Eigen::Vector3d& centroid) {
    if (options.literal) return true;
    std::call_once(once, [&] { inside_test = std::make_unique<InsideTest>(lattice, surface); });
    // A centroid exactly on the surface counts as outside, so that exactly one of the two grids has it.
    const bool inside_solid = (*inside_test)(centroid) > 0;
    return inside_solid == (options.region == Region::inside);
  };

  for (;;) {
    phase("intersections");
    const auto edge_counts = [&](Edge e) {
      return !settled.contains(lattice.low(e)) && !settled.contains(lattice.high(e));
    };
    const std::vector<EdgeIntersections> intersections =
        intersect_edges(lattice, surface, contacts, edge_counts);  // (ii)

    phase("indicators");
    const Indicators indicators =
        characterize(lattice, initial_indicators(inside, contacts.on_surface, settled, options.region),
                     intersections, settled);  // (iii), Table 3
    result.table3 = indicators.table3;
    result.dropped_intersections = indicators.dropped;

    phase("extraction");
    result.grid =
        extract(lattice, indicators, settled, options.diagonals, keep_case_5);  // (iv), Tables 1 and 2

    phase("positivity");
    const std::vector<Index> bad = not_positive(result.grid.mesh);
    result.not_positive = static_cast<std::int64_t>(bad.size());
    std::vector<NearVertex> to_mend;
    if (!bad.empty() && !options.literal)
      to_mend = vertices_to_mend(lattice, surface, indicators, settled, result.grid, bad);
    // No tetrahedron is bad, or none of the bad ones may or can be mended; then the verifier will name them.
    if (to_mend.empty()) {
      if (record) {
        record_lattice(lattice, record);
        record_characterization(lattice, indicators, settled, mended, record);
        record_rows(lattice, result.grid, record);
      }
      break;
    }
    for (const NearVertex& near : to_mend) mended.push_back(near.vertex);
    settled.add(to_mend);
  }
  result.mended = std::ssize(mended);
  result.lattice = lattice;

  std::unique_ptr<TrueSurface> true_surface;
  if (options.parametric && surface.evaluate && result.not_positive == 0) {
    phase("parametric surface");
    true_surface = std::make_unique<TrueSurface>(surface);
    const std::vector<MappedPoint> mapped = move_surface_points(result.grid, *true_surface);
    result.mapped = std::count_if(mapped.begin(), mapped.end(), [](const MappedPoint& m) { return m.moved; });
    result.not_mapped = std::ssize(mapped) - result.mapped;
    if (record) record_mapped(mapped, record);
  }
  if (options.adapt && !result.grid.mesh.tets.empty() && result.not_positive == 0) {  // (v), (vi)
    if (options.follow.empty())
      result.adaptation = adapt(result.grid, surface, *options.adapt, true_surface.get(), options.listener);
    else
      result.adaptation =
          follow(result.grid, surface, *options.adapt, true_surface.get(), settings_of(options, surface),
                 options.follow, options.listener, result.follow.emplace());
  }
  if (record) record(end_of(result));
  return result;
}

}  // namespace tetproof::reference
