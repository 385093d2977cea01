// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/trace/trace_records.hpp"

#include <algorithm>
#include <stdexcept>

namespace tetproof::reference {
namespace {

char letter(std::int8_t indicator) {
  return indicator < 0 ? '-' : indicator > 0 ? '+' : '0';
}

std::string_view name_of(Criterion criterion) {
  switch (criterion) {
    case Criterion::none:
      return "none";
    case Criterion::solid_angle:
      return "solid-angle";
    case Criterion::aspect_ratio:
      return "aspect-ratio";
  }
  throw std::logic_error("a criterion without a name");
}

// The place of the cut on an edge between -1 and +1 (readings D6, D7).
Eigen::Vector3d cut_point(const Lattice& lattice, const Indicators& indicators, Edge e) {
  const std::int64_t own = indicators.cuts.find(e);
  if (own >= 0) return indicators.cuts.points[own];
  const Vertex low = lattice.low(e), high = lattice.high(e);
  const Vertex exterior = indicators.sign[low] < 0 ? low : high;
  return lattice.point(indicators.initial[exterior] == 0 ? exterior : low + high - exterior);
}

}  // namespace

trace::Settings settings_of(const Options& options, const TriangleSurface& surface) {
  trace::Settings settings{.region = options.region == Region::inside ? "inside" : "outside",
                           .box_scale = options.box_scale,
                           .on_surface = options.literal ? 0 : options.on_surface,
                           .diagonals = options.diagonals == Diagonals::lowest ? "lowest" : "shortest",
                           .literal = options.literal,
                           .points = "0"};
  if (options.adapt) {
    settings.p = options.adapt->p;
    settings.curvature = options.adapt->curvature;
    settings.improve = name_of(options.adapt->improve);
    settings.improve_below = options.adapt->improve_below;
    settings.points =
        options.adapt->points == AdaptOptions::automatic ? "auto" : std::to_string(options.adapt->points);
    settings.past_dilution = options.adapt->past_dilution;
  }
  settings.parametric = options.parametric && surface.evaluate;
  return settings;
}

void record_lattice(const Lattice& lattice, const Recorder& record) {
  const auto& [x, y, z] = lattice.planes;
  record(trace::Lattice{
      {Eigen::Vector3d(x.front(), y.front(), z.front()), Eigen::Vector3d(x.back(), y.back(), z.back())},
      lattice.cells});
}

void record_characterization(const Lattice& lattice, const Indicators& indicators,
                             const SurfaceVertices& settled, const std::vector<Vertex>& mended,
                             const Recorder& record) {
  const auto [nx, ny, nz] = lattice.cells;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j) {
      trace::Indicators row{j, k, {}, {}};
      for (int i = 0; i <= nx; ++i) {
        row.initial += letter(indicators.initial[lattice.vertex(i, j, k)]);
        row.after += letter(indicators.sign[lattice.vertex(i, j, k)]);
      }
      record(row);
    }
  for (std::size_t s = 0; s < settled.vertices.size(); ++s) {
    const Vertex v = settled.vertices[s];
    record(trace::Moved{lattice.position(v), settled.points[s],
                        std::find(mended.begin(), mended.end(), v) != mended.end()});
  }
  for (Vertex low = 0; low < lattice.vertices(); ++low) {
    const auto [i, j, k] = lattice.position(low);
    for (int bits = 1; bits < 8; ++bits) {
      if ((bits & 1 && i == nx) || (bits & 2 && j == ny) || (bits & 4 && k == nz)) continue;
      const Edge e = Edge{low} * 8 + bits;
      if (indicators.sign[low] * indicators.sign[lattice.high(e)] < 0)
        record(trace::Cut{{lattice.position(low), lattice.position(lattice.high(e))},
                          cut_point(lattice, indicators, e)});
    }
  }
}

void record_rows(const Lattice& lattice, const Grid& grid, const Recorder& record) {
  const auto [nx, ny, nz] = lattice.cells;
  for (std::size_t cell = 0; 6 * cell < grid.lattice_rows.size(); ++cell) {
    const auto column = static_cast<int>(cell % nx), row = static_cast<int>(cell / nx % ny);
    trace::Rows rows{{column, row, static_cast<int>(cell / nx / ny)}, {}};
    for (std::size_t t = 0; t < 6; ++t) {
      const std::uint8_t of = grid.lattice_rows[6 * cell + t];
      rows.rows[t] = of == Grid::case_5_dropped ? "5-" : std::string(tables::table2[of].name);
    }
    record(rows);
  }
}

void record_mapped(const std::vector<MappedPoint>& mapped, const Recorder& record) {
  for (const MappedPoint& point : mapped)
    record(trace::Mapped{point.from, point.moved ? point.to : point.from});
}

trace::Record end_of(const Generation& made) {
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

}  // namespace tetproof::reference
