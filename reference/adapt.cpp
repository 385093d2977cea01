// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/adapt.hpp"

#include <fmt/core.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "io/error.hpp"
#include "reference/curvature.hpp"
#include "reference/exact.hpp"
#include "reference/trace_records.hpp"

namespace tetproof::reference {
namespace {

constexpr double most_tets = 2e8;

double absolute(const VolumeSetting& setting, double mean_volume) {
  return setting.absolute ? setting.value : setting.value * mean_volume;
}

// Eq. (3.1) with what reading D13 leaves to the first grid.
VolumeLaw law_of(const Grid& grid, const Weighting& weighting, const AdaptOptions& options,
                 double mean_volume) {
  const auto& x = grid.mesh.points;
  const auto largest_of = [&](const tbb::blocked_range<std::size_t>& range, double largest) {
    for (std::size_t t = range.begin(); t < range.end(); ++t) {
      const auto& [a, b, c, d] = grid.mesh.tets[t];
      largest = std::max(largest, weighting.distance(centroid(x[a], x[b], x[c], x[d])));
    }
    return largest;
  };
  double d1 = options.d1;
  if (d1 == 0)
    d1 = tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, grid.mesh.tets.size()), 0.0, largest_of,
                              [](double a, double b) { return std::max(a, b); });
  if (d1 == 0) throw InputError("every tetrahedron of the first grid is at distance 0: give d1");
  return {absolute(options.v0, mean_volume), absolute(options.v1, mean_volume), d1, options.p};
}

double mean_volume_of(const TetMesh& mesh) {
  CompensatedSum sum;
  for (const auto& [a, b, c, d] : mesh.tets)
    sum.add(volume(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]));
  return sum.value() / static_cast<double>(mesh.tets.size());
}

// Before memory runs out: how many tetrahedra the law asks for.
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

// The conditions that look at what has been reached, and not at the next choice (readings D17, D23).
class Progress {
 public:
  Progress(const AdaptOptions& options, double e_avg_goal, double e_avg)
      : options_(options), goal_(e_avg_goal), least_(e_avg) {}

  void inserted(double e_avg) {
    ++insertions_;
    if (e_avg < least_) {
      least_ = e_avg;
      least_at_ = insertions_;
    }
  }
  std::optional<Stop> stop(double e_avg, std::int64_t tets) const {
    if (options_.points != AdaptOptions::automatic && insertions_ >= options_.points) return Stop::points;
    if (e_avg <= goal_) return Stop::e_avg;
    if (insertions_ - least_at_ >= std::max<std::int64_t>(1000, tets / 10)) return Stop::stalled;
    return std::nullopt;
  }

 private:
  const AdaptOptions& options_;
  double goal_, least_;
  std::int64_t insertions_ = 0, least_at_ = 0;
};

}  // namespace

void check(const AdaptOptions& options) {
  const auto positive = [](double value, std::string_view name) {
    if (!(value > 0 && std::isfinite(value)))
      throw InputError(fmt::format("{}: expected a positive number, found {}", name, value));
  };
  positive(options.v0.value, "v0");
  positive(options.v1.value, "v1");
  positive(options.p, "p");
  if (options.d1 != 0) positive(options.d1, "d1");
  if (!(options.e_avg.value >= 0))
    throw InputError(fmt::format("e-avg: expected a number, not negative, found {}", options.e_avg.value));
  if (!(options.improve_below >= 0 && options.improve_below <= 1))
    throw InputError(fmt::format("improve-below: expected a solid angle from 0 to 1 (of 4 pi), found {}",
                                 options.improve_below));
  if (options.points < 0 && options.points != AdaptOptions::automatic)
    throw InputError(fmt::format("points: expected a number, not negative, found {}", options.points));
  if (options.past_dilution && options.points == AdaptOptions::automatic)
    throw InputError("past-dilution: expected a number of points with it, found automatic (reading D17)");
}

std::string_view name_of(Stop stop) {
  switch (stop) {
    case Stop::no_gain:
      return "no-gain";
    case Stop::dilution:
      return "dilution";
    case Stop::stalled:
      return "stalled";
    case Stop::points:
      return "points";
    case Stop::e_avg:
      return "e-avg";
  }
  throw std::logic_error("a reason to stop without a name");
}

Prepared weigh_grid(const Grid& grid, Weighting& weighting, const AdaptOptions& options,
                    const TrueSurface* true_surface, const Listener& listener) {
  if (listener.phase) listener.phase("weights");
  const double mean_volume = mean_volume_of(grid.mesh);
  weighting.set_law(law_of(grid, weighting, options, mean_volume));
  MapToSurface to_surface;
  if (true_surface) to_surface = [true_surface](const Eigen::Vector3d& p) { return (*true_surface)(p); };
  WeightedGrid weighted(Triangulation(grid.mesh, grid.on_surface), weighting, to_surface);
  check_demand(weighted, options);
  if (listener.record) record_first_grid(weighted, weighting, mean_volume, listener.record);
  if (listener.after_step) listener.after_step(weighted);
  return {std::move(weighted), mean_volume};
}

std::vector<Index> set_to_improve(const WeightedGrid& grid, const std::array<Index, 4>& neighbours,
                                  Index first, const AdaptOptions& options) {
  std::vector<Index> set;
  if (options.improve == Criterion::none) return set;
  bool needed = false;
  for (Index t = first; t < grid.grid().numbers(); ++t) {
    set.push_back(t);
    needed |= solid_angle_of(smallest_solid_angle(grid.grid().corner_points(t))) < options.improve_below;
  }
  if (!needed) return {};
  for (const Index n : neighbours)
    if (n >= 0) set.push_back(n);
  return set;
}

std::array<Index, 4> neighbours_of(const Triangulation& grid, Index tet) {
  return {grid.neighbour(tet, 0), grid.neighbour(tet, 1), grid.neighbour(tet, 2), grid.neighbour(tet, 3)};
}

Adaptation adapt(const Grid& first_grid, const TriangleSurface& surface, const AdaptOptions& options,
                 const TrueSurface* true_surface, const Listener& listener) {
  check(options);
  Weighting weighting(surface, options.curvature);
  auto [grid, mean_volume] = weigh_grid(first_grid, weighting, options, true_surface, listener);  // (v)
  Adaptation result{.law = weighting.law(),
                    .mean_volume = mean_volume,
                    .with_curvature = options.curvature,
                    .kappa_min = weighting.kappa_min(),
                    .kappa_max = weighting.kappa_max(),
                    .kappa_outlier_ratio = outlier_ratio(weighting.kappas()),
                    .e_avg_first = grid.e_avg()};

  if (listener.phase) listener.phase("insertion");
  Progress progress(options, absolute(options.e_avg, mean_volume), grid.e_avg());
  for (;;) {  // (vi)
    if (const auto stop = progress.stop(grid.e_avg(), grid.grid().tets())) {
      result.stopped = *stop;
      break;
    }
    const std::optional<Candidate> chosen = grid.best();  // eq. (3.5)
    if (!chosen || !(grid.e_avg_after(*chosen) < grid.e_avg())) {
      result.stopped = Stop::no_gain;
      break;
    }
    if (!grid.is_positive(*chosen)) {  // reading D18
      grid.refuse(chosen->tet);
      ++result.refused;
      continue;
    }
    const Weight& weight = grid.weight(chosen->tet);
    if (!options.past_dilution && weight.volume <= weight.desired) {  // reading D17
      result.stopped = Stop::dilution;
      break;
    }
    const auto neighbours = neighbours_of(grid.grid(), chosen->tet);
    const auto split = grid.grid().corner_points(chosen->tet);
    const Index first = grid.apply(*chosen);  // Table 4
    ++result.insertions;
    ++result.rows[chosen->split.row];
    if (listener.record) listener.record(record_of(*chosen, split, result.insertions, grid.e_avg()));

    const std::vector<Index> set = set_to_improve(grid, neighbours, first, options);
    if (!set.empty())  // section 4
      result.flips += improve(grid, set, options.improve, [&](const Flip& flip) {
        if (listener.record) listener.record(record_of(flip, grid, options.improve));
      });
    progress.inserted(grid.e_avg());
    if (options.check_every_step) check_invariants(grid);
    if (listener.after_step) listener.after_step(grid);
  }
  result.e_avg_last = grid.e_avg();
  result.mesh = grid.grid().mesh();
  for (Index p = 0; p < grid.grid().points(); ++p) result.on_surface.push_back(grid.grid().on_surface(p));
  return result;
}

void check_invariants(const WeightedGrid& weighted) {
  const Triangulation& grid = weighted.grid();
  std::map<std::array<Index, 3>, std::vector<std::array<Index, 3>>> faces;  // sorted, then as they run
  CompensatedSum sum;
  std::int64_t tets = 0;
  for (Index t = 0; t < grid.numbers(); ++t) {
    if (!grid.alive(t)) continue;
    ++tets;
    const auto [a, b, c, d] = grid.corner_points(t);
    if (orientation(a, b, c, d) <= 0)
      throw std::logic_error(fmt::format("tetrahedron {} is not positive", t));
    sum.add(volume_error(volume(a, b, c, d), weighted.weight(t).desired));
    for (const auto& [i, j, k] : tet_faces) {
      std::array<Index, 3> face{grid.corners(t)[i], grid.corners(t)[j], grid.corners(t)[k]};
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      auto key = face;
      std::sort(key.begin(), key.end());
      faces[key].push_back(face);
    }
  }
  for (const auto& [key, uses] : faces)
    if (uses.size() > 2 || (uses.size() == 2 && uses[0] == uses[1]))
      throw std::logic_error(fmt::format("face {} {} {} is not shared by two tetrahedra on its two sides",
                                         key[0], key[1], key[2]));
  const double e_avg = average_error(sum.value(), tets);
  if (tets != grid.tets() || !(std::abs(e_avg - weighted.e_avg()) <= 1e-12 * e_avg))
    throw std::logic_error(fmt::format("E_avg is kept as {} of {} tetrahedra, and is {} of {}",
                                       weighted.e_avg(), grid.tets(), e_avg, tets));
}

}  // namespace tetproof::reference
