// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/generate.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>

#include "io/surface/used_vertices.hpp"
#include "reference/by_page/generate_by_page.hpp"
#include "reference/engine/first_grid/contacts.hpp"
#include "reference/engine/first_grid/exact.hpp"
#include "reference/engine/first_grid/first_grid_records.hpp"
#include "reference/engine/first_grid/inside.hpp"
#include "reference/engine/first_grid/intersections.hpp"
#include "reference/engine/first_grid/mend.hpp"

namespace tetproof::reference {
namespace {

// The last record of the trace.
trace::End end_of(const Generation& made) {
  trace::End end{
      .stopped = "not-asked", .points = std::ssize(made.mesh().points), .tets = std::ssize(made.mesh().tets)};
  if (made.adaptation) {
    end.stopped = name_of(made.adaptation->stopped);
    end.insertions = made.adaptation->insertions;
    end.flips = made.adaptation->flips;
    end.refused = made.adaptation->refused;
    end.e_avg = made.adaptation->e_avg_last;
  }
  return end;
}

// The options for a grid that is not empty, for the page: the fast engine tells how many cells that takes.
Options with_enough_cells(const TriangleSurface& surface, Options options) {
  Options first_grid = options;
  first_grid.engine = Engine::fast;
  first_grid.adapt.reset();
  first_grid.listener = {};
  const Generation made = generate(surface, first_grid);
  options.cells[0] = *std::max_element(made.lattice.cells.begin(), made.lattice.cells.end());
  options.raise_cells = false;
  return options;
}

}  // namespace

Generation generate(const TriangleSurface& given, const Options& options) {
  check(options);
  const std::optional<TriangleSurface> used = io::without_unused_vertices(given);
  const TriangleSurface& surface = used ? *used : given;
  if (options.engine == Engine::paper)
    return generate_by_page(surface, options.raise_cells ? with_enough_cells(surface, options) : options);
  const double tolerance = options.literal ? 0 : options.on_surface;
  const auto phase = [&](std::string_view name) {
    if (options.listener.phase) options.listener.phase(name);
  };
  std::vector<trace::Record> own_steps;  // of steps (i) to (iv), to check a trace with
  Recorder record = options.listener.record;
  if (!options.follow.empty())
    record = [&](const trace::Record& made) {
      own_steps.push_back(made);
      if (options.listener.record) options.listener.record(made);
    };

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
      if (options.raise_cells && result.grid.mesh.tets.empty() &&
          2 * options.cells[0] <= Options::most_cells) {
        Options finer = options;
        finer.cells[0] *= 2;
        return generate(surface, finer);
      }
      if (record) record_first_steps(first_steps(lattice, indicators, settled, mended, result.grid), record);
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
    for (const MappedPoint& point : mapped)
      if (record) record(trace::Mapped{point.from, point.moved ? point.to : point.from});
  }
  std::optional<AdaptOptions> adapt_options;  // (v), (vi)
  if (options.adapt && !result.grid.mesh.tets.empty() && result.not_positive == 0) {
    adapt_options = options.adapt;
    adapt_options->literal = options.literal;
  }
  if (!options.follow.empty())
    result.adaptation = follow({.grid = result.grid,
                                .surface = surface,
                                .true_surface = true_surface.get(),
                                .settings = settings_of(options, static_cast<bool>(surface.evaluate)),
                                .first_steps = std::move(own_steps)},
                               adapt_options ? &*adapt_options : nullptr, options.follow, options.listener,
                               result.follow.emplace());
  else if (adapt_options)
    result.adaptation = adapt(result.grid, surface, *adapt_options, true_surface.get(), options.listener);
  if (record) record(end_of(result));
  return result;
}

}  // namespace tetproof::reference
