// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/adaptation/insertion.hpp"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/error.hpp"
#include "reference/engine/adaptation/adaptation_records.hpp"
#include "reference/engine/adaptation/curvature.hpp"
#include "reference/engine/adaptation/invariants.hpp"

namespace tetproof::reference {
namespace {

constexpr double most_tets = 2e8;

double absolute(const VolumeSetting& setting, double mean_volume) {
  return setting.absolute ? setting.value : setting.value * mean_volume;
}

// Eq. (3.2) for every tetrahedron.
std::vector<double> distances_of(const Triangulation& grid, const Weighting& weighting) {
  std::vector<double> distances(grid.numbers());
  tbb::parallel_for(Index{0}, grid.numbers(),
                    [&](Index t) { distances[t] = weighting.distance(grid.corner_points(t)); });
  return distances;
}

// The law of eq. (3.1). Settings that depend on the first grid become absolute (reading D13).
VolumeLaw law_of(const AdaptOptions& options, double mean_volume, const std::vector<double>& distances) {
  const double d1 = options.d1 != 0 ? options.d1 : *std::max_element(distances.begin(), distances.end());
  if (d1 == 0) throw InputError("every tetrahedron of the first grid is at distance 0: give d1");
  return {absolute(options.v0, mean_volume), absolute(options.v1, mean_volume), d1, options.p};
}

double mean_volume_of(const TetMesh& mesh) {
  CompensatedSum sum;
  for (const auto& [a, b, c, d] : mesh.tets)
    sum.add(volume(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]));
  return sum.value() / static_cast<double>(mesh.tets.size());
}

// Refuses a law that asks for more tetrahedra than memory can hold.
void check_demand(const WeightedGrid& grid, const AdaptOptions& options) {
  double tets = 0;
  for (Index t = 0; t < grid.grid().numbers(); ++t)
    tets += std::max(1.0, grid.weight(t).volume / grid.weight(t).desired);
  if (options.points != AdaptOptions::automatic)
    tets =
        std::min(tets, static_cast<double>(grid.grid().tets()) + 3.0 * static_cast<double>(options.points));
  if (!(tets <= most_tets))
    throw InputError(
        fmt::format("v0 and v1 ask for about {:.1e} tetrahedra, more than {:.0e}", tets, most_tets));
}

}  // namespace

Insertion::Insertion(const Grid& first_grid, const TriangleSurface& surface, const AdaptOptions& options,
                     const TrueSurface* true_surface, const Listener& listener)
    : options_(options), listener_(listener), weighting_(surface, options.curvature) {
  if (listener_.phase) listener_.phase("weights");
  const double mean_volume = mean_volume_of(first_grid.mesh);
  Triangulation triangulation(first_grid.mesh, first_grid.on_surface);
  const std::vector<double> distances = distances_of(triangulation, weighting_);
  weighting_.set_law(law_of(options, mean_volume, distances));
  MapToSurface to_surface;
  if (true_surface) to_surface = [true_surface](const Eigen::Vector3d& p) { return (*true_surface)(p); };
  grid_.emplace(std::move(triangulation), weighting_, distances, to_surface, options.literal);
  check_demand(*grid_, options);

  e_avg_goal_ = absolute(options.e_avg, mean_volume);
  least_e_avg_ = grid_->e_avg();
  result_ = {.law = weighting_.law(),
             .mean_volume = mean_volume,
             .with_curvature = options.curvature,
             .kappa_min = weighting_.kappa_min(),
             .kappa_max = weighting_.kappa_max(),
             .kappa_outlier_ratio = outlier_ratio(weighting_.kappas()),
             .e_avg_first = grid_->e_avg()};
  if (listener_.record) record_first_grid(*grid_, weighting_, mean_volume, e_avg_goal_, listener_.record);
  if (listener_.after_step) listener_.after_step(*grid_);
  if (listener_.phase) listener_.phase("insertion");
}

std::optional<Stop> Insertion::stop_by_progress() const {
  if (options_.points != AdaptOptions::automatic && result_.insertions >= options_.points)
    return Stop::points;
  if (e_avg_goal_ > 0 && grid_->e_avg() <= e_avg_goal_) return Stop::e_avg;
  if (result_.insertions - least_at_ >= std::max<std::int64_t>(1000, grid_->grid().tets() / 10))
    return Stop::stalled;
  return std::nullopt;
}

Choice Insertion::choose() {
  if (const auto stop = stop_by_progress()) return {.stop = stop};
  std::optional<Candidate> chosen = grid_->best();  // eq. (3.5)
  for (; chosen && grid_->e_avg_after(*chosen) < grid_->e_avg(); chosen = grid_->best()) {
    if (!grid_->is_positive(*chosen)) {
      grid_->refuse(chosen->tet);  // reading D18
      ++result_.refused;
    } else if (grid_->crosses_boundary(*chosen)) {
      grid_->leave_point(chosen->tet);  // reading D12
    } else {
      break;
    }
  }
  Choice choice{.best = chosen};
  if (!chosen || !(grid_->e_avg_after(*chosen) < grid_->e_avg())) {
    choice.stop = Stop::no_gain;
  } else if (const Weight& weight = grid_->weight(chosen->tet);
             !options_.past_dilution && weight.volume <= weight.desired) {
    choice.stop = Stop::dilution;  // reading D17
  }
  return choice;
}

std::vector<Index> Insertion::insert(const Candidate& chosen) {
  const Triangulation& grid = grid_->grid();
  std::vector<Index> neighbours;
  for (int f = 0; f < 4; ++f)
    if (grid.neighbour(chosen.tet, f) >= 0) neighbours.push_back(grid.neighbour(chosen.tet, f));
  const auto corners = grid.corner_points(chosen.tet);
  const Index first = first_of_step_ = grid_->apply(chosen);  // Table 4
  ++result_.insertions;
  result_.left += chosen.split.on_surface && grid_->is_parametric() && !chosen.moved;
  ++result_.rows[chosen.split.row];
  if (listener_.record) listener_.record(record_of(chosen, corners, result_.insertions, grid_->e_avg()));

  std::vector<Index> set;  // O_i of section 4
  smallest_new_solid_angle_ = 1;
  if (options_.improve == Criterion::none) return set;
  for (Index t = first; t < grid.numbers(); ++t) {
    set.push_back(t);
    smallest_new_solid_angle_ =
        std::min(smallest_new_solid_angle_, solid_angle_of(smallest_solid_angle(grid.corner_points(t))));
  }
  set.insert(set.end(), neighbours.begin(), neighbours.end());
  return set;
}

bool Insertion::needs_improvement() const {  // reading D21
  return options_.improve != Criterion::none && smallest_new_solid_angle_ < options_.improve_below;
}

std::vector<Index> Insertion::flip(const Flip& flip, std::vector<Index> set) {
  const Index first = grid_->exchange(flip.old, flip.fresh);
  ++result_.flips;
  if (listener_.record) listener_.record(record_of(flip, *grid_, options_.improve));
  return updated_set(std::move(set), flip, first);
}

void Insertion::end_step() {
  if (grid_->e_avg() < least_e_avg_) {
    least_e_avg_ = grid_->e_avg();
    least_at_ = result_.insertions;
  }
#ifndef NDEBUG
  check_invariants(*grid_, first_of_step_);
#endif
  if (options_.check_every_step) check_invariants(*grid_);
  if (listener_.after_step) listener_.after_step(*grid_);
  if (listener_.inserted)
    listener_.inserted(result_.insertions, options_.points == AdaptOptions::automatic ? 0 : options_.points);
}

Adaptation Insertion::finish(Stop stop) {
  result_.stopped = stop;
  result_.e_avg_last = grid_->e_avg();
  result_.mesh = grid_->grid().mesh();
  find_worst(result_);
  for (Index p = 0; p < grid_->grid().points(); ++p)
    result_.on_surface.push_back(grid_->grid().on_surface(p));
  return std::move(result_);
}

}  // namespace tetproof::reference
