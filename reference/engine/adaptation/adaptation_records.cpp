// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/adaptation/adaptation_records.hpp"

namespace tetproof::reference {

void record_first_grid(const WeightedGrid& grid, const Weighting& weighting, double mean_volume,
                       double e_avg_goal, const std::function<void(const trace::Record&)>& record) {
  const VolumeLaw& law = weighting.law();
  trace::FirstGrid first{.points = grid.grid().points(),
                         .tets = grid.grid().tets(),
                         .mean_volume = mean_volume,
                         .v0 = law.v0,
                         .v1 = law.v1,
                         .d1 = law.d1,
                         .e_avg = grid.e_avg()};
  if (weighting.with_curvature()) {
    first.kappa_min = weighting.kappa_min();
    first.kappa_max = weighting.kappa_max();
  }
  if (e_avg_goal > 0) first.e_avg_goal = e_avg_goal;
  record(first);
  for (Index t = 0; t < grid.grid().numbers(); ++t) {
    const Weight& w = grid.weight(t);
    trace::Weight weight{.tet = grid.grid().corner_points(t),
                         .d = w.d,
                         .omega = w.omega,
                         .volume = w.volume,
                         .desired = w.desired,
                         .error = w.error};
    if (weighting.with_curvature()) weight.kappa = w.kappa;
    record(weight);
  }
}

trace::Record record_of(const Candidate& chosen, const std::array<Eigen::Vector3d, 4>& corners,
                        std::int64_t n, double e_avg) {
  const Split& split = chosen.split;
  return trace::Insertion{.n = n,
                          .tet = corners,
                          .row = std::string(tables::table4[split.row].name),
                          .replaced = {split.replaced.begin(), split.replaced.begin() + split.pieces},
                          .point = split.point,
                          .e_avg = e_avg};
}

trace::Record record_of(const Flip& flip, const WeightedGrid& grid, Criterion criterion) {
  const auto quality = [&](double q) { return criterion == Criterion::solid_angle ? solid_angle_of(q) : q; };
  trace::Flip record{.two_to_three = flip.two_to_three(),
                     .face = {},
                     .edge = {},
                     .quality_before = quality(flip.before),
                     .quality_after = quality(flip.after),
                     .e_avg = grid.e_avg()};
  for (int i = 0; i < 3; ++i) record.face[i] = grid.grid().point(flip.face[i]);
  for (int i = 0; i < 2; ++i) record.edge[i] = grid.grid().point(flip.edge[i]);
  return record;
}

}  // namespace tetproof::reference
