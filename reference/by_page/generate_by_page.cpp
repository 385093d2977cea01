// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/by_page/generate_by_page.hpp"

#include <algorithm>

#include "reference/engine/adaptation/curvature.hpp"
#include "reference/engine/adaptation/improve.hpp"
#include "reference/paper/page.hpp"

namespace tetproof::reference {
namespace {

Stop stop_named(const std::string& name) {
  for (const Stop stop : {Stop::no_gain, Stop::dilution, Stop::stalled, Stop::points})
    if (name == name_of(stop)) return stop;
  return Stop::e_avg;
}

std::vector<std::uint8_t> marks(const std::set<int>& surface_points, std::size_t points) {
  std::vector<std::uint8_t> on_surface(points, 0);
  for (const int p : surface_points) on_surface[p] = 1;
  return on_surface;
}

Adaptation adaptation_of(const paper::Page& page) {
  Adaptation made{.law = page.law_,
                  .mean_volume = page.mean_volume_,
                  .with_curvature = !page.kappas_.empty(),
                  .kappa_min = page.kappa_min_,
                  .kappa_max = page.kappa_max_,
                  .kappa_outlier_ratio = outlier_ratio(page.kappas_),
                  .e_avg_first = page.e_avg_first_,
                  .e_avg_last = page.e_avg(),
                  .insertions = page.insertions_,
                  .refused = page.refused_,
                  .flips = page.flips_,
                  .left = page.left_,
                  .rows = page.table4_,
                  .stopped = stop_named(page.stopped_)};
  made.mesh.points = page.points_;
  for (const auto& [number, tet] : page.tets_) made.mesh.tets.push_back(tet.v);
  made.on_surface = marks(page.surface_points_, page.points_.size());
  find_worst(made);
  return made;
}

}  // namespace

Generation generate_by_page(const TriangleSurface& surface, const Options& options) {
  const auto phase = [&](std::string_view name) {
    if (options.listener.phase) options.listener.phase(name);
  };
  phase("lattice");
  Generation made;
  made.lattice = make_lattice(surface, options.cells, options.box_scale);  // refuses what cannot be cut
  phase("insertion");
  paper::Page page(surface, options);
  page.run();

  made.grid.mesh = page.first_grid_.mesh;
  made.grid.on_surface = marks(page.first_grid_.surface_points, page.first_grid_.mesh.points.size());
  for (const std::string& name : page.rows_) {
    const auto row = std::find_if(tables::table2.begin(), tables::table2.end(),
                                  [&](const tables::Table2Row& r) { return r.name == name; });
    const bool dropped = row == tables::table2.end();  // "5-"
    made.grid.lattice_rows.push_back(dropped ? Grid::case_5_dropped
                                             : static_cast<std::uint8_t>(row - tables::table2.begin()));
    if (!dropped) ++made.grid.rows[row - tables::table2.begin()];
  }
  made.grid.collapsed = page.collapsed_;
  made.table3 = page.table3_;
  made.dropped_intersections = page.dropped_;
  made.mended = std::ssize(page.mended_);
  made.moved_to_surface = std::ssize(page.settled_) - made.mended;
  made.mapped = page.mapped_;
  made.not_mapped = page.not_mapped_;
  made.not_positive = page.not_positive_;
  if (page.adapted_) made.adaptation = adaptation_of(page);
  return made;
}

}  // namespace tetproof::reference
