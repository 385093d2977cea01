// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/generate.hpp"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>

#include "io/error.hpp"
#include "reference/contacts.hpp"
#include "reference/exact.hpp"
#include "reference/inside.hpp"
#include "reference/intersections.hpp"
#include "reference/mend.hpp"

namespace tetproof::reference {
namespace {

void check(const Options& options) {
  if (!(options.on_surface >= 0 && options.on_surface <= 0.15))
    throw InputError(
        fmt::format("the on-surface tolerance must be 0 to 0.15 of the shortest cell edge, found {}",
                    options.on_surface));
}

}  // namespace

Generation generate(const TriangleSurface& surface, const Options& options) {
  check(options);
  const double tolerance = options.literal ? 0 : options.on_surface;
  const auto phase = [&](std::string_view name) {
    if (options.phase) options.phase(name);
  };

  phase("lattice");
  const Lattice lattice = make_lattice(surface, options.cells, options.box_scale);  // (i), eq. 2.1

  phase("contacts");
  const Contacts contacts = find_contacts(lattice, surface);
  SurfaceVertices settled;  // for good, reading D4
  if (tolerance > 0)
    settled.add(
        find_near_vertices(lattice, surface, tolerance * lattice.shortest_edge, [](Vertex) { return true; }));
  const std::vector<std::int8_t> inside = inside_by_parity(lattice, surface);

  Generation result;
  result.moved_to_surface = static_cast<std::int64_t>(settled.vertices.size());
  std::unique_ptr<InsideTest> inside_test;
  std::once_flag once;  // few surfaces have a case 5
  const auto keep_case_5 = [&](const Eigen::Vector3d& centroid) {
    if (options.literal) return true;
    std::call_once(once, [&] { inside_test = std::make_unique<InsideTest>(lattice, surface); });
    const bool inside_solid =
        (*inside_test)(centroid) > 0;  // on the surface: outside, so that one of the two grids has it
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
    if (bad.empty() || options.literal) break;
    const std::vector<NearVertex> mended =
        vertices_to_mend(lattice, surface, indicators, settled, result.grid, bad);
    if (mended.empty()) break;  // nothing is cut beside it: the verdict will name it
    result.mended += static_cast<std::int64_t>(mended.size());
    settled.add(mended);
  }
  result.lattice = lattice;
  return result;
}

}  // namespace tetproof::reference
