// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/follow/follow_first_grid.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "io/error.hpp"
#include "reference/engine/first_grid/exact.hpp"

namespace tetproof::reference {
namespace {

// Compares the settings, except the number of points, which the end of the trace shows.
void compare(const trace::Settings& theirs, const trace::Settings& ours) {
  const auto same = [](const auto& trace, const auto& here, std::string_view name) {
    if (trace != here)
      throw Divergence{fmt::format("settings: the trace has {} {}, this run {}", name, trace, here)};
  };
  const auto same_number = [&](double trace, double here, std::string_view name) {
    if (!close(trace, here)) same(trace, here, name);
  };
  same(theirs.region, ours.region, "region");
  same_number(theirs.box_scale, ours.box_scale, "box_scale");
  same_number(theirs.on_surface, ours.on_surface, "on_surface");
  same(theirs.diagonals, ours.diagonals, "diagonals");
  same(theirs.literal, ours.literal, "literal");
  same_number(theirs.p, ours.p, "p");
  same(theirs.curvature, ours.curvature, "curvature");
  same(theirs.parametric, ours.parametric, "parametric");
  same(theirs.improve, ours.improve, "improve");
  if (ours.improve != "none") same_number(theirs.improve_below, ours.improve_below, "improve_below");
  same(theirs.past_dilution, ours.past_dilution, "past_dilution");
}

void expect(double theirs, double ours, std::string_view name) {
  if (!close(theirs, ours)) throw Divergence{fmt::format("{} is {:.12g}, not {:.12g}", name, ours, theirs)};
}

// `place`: a difference of d below this [length] is rounding. Where a centroid lies on a surface vertex, d is
// only rounding, and a relative comparison would fail.
void compare(const trace::Weight& theirs, const Weight& ours, double place, double kappa_max) {
  const std::string at = " of the tetrahedron at " + text(theirs.tet);
  if (std::abs(theirs.d - ours.d) > place) expect(theirs.d, ours.d, "d, eq. (3.2)," + at);
  if (theirs.kappa && std::abs(*theirs.kappa - ours.kappa) > agree * kappa_max)
    expect(*theirs.kappa, ours.kappa, "the absolute curvature kappa (D15)" + at);
  expect(theirs.omega, ours.omega, "omega, eq. (3.6)," + at);
  const double size = std::max(ours.volume, ours.desired);
  if (std::abs(theirs.volume - ours.volume) > agree * size) expect(theirs.volume, ours.volume, "V" + at);
  expect(theirs.desired, ours.desired, "V(d), eq. (3.1)," + at);
  if (std::abs(theirs.error - ours.error) > agree * size)
    expect(theirs.error, ours.error, "E, eq. (3.3)," + at);
}

}  // namespace

TraceStart read_start(trace::Reader& reader, const trace::Settings& ours) {
  TraceStart start;
  bool has_first_grid = false;
  while ((start.next = reader.next())) {
    const trace::Record& record = *start.next;
    if (std::holds_alternative<trace::Insertion>(record) || std::holds_alternative<trace::Flip>(record) ||
        std::holds_alternative<trace::End>(record))
      break;
    if (const auto* settings = std::get_if<trace::Settings>(&record)) compare(*settings, ours);
    if (const auto* weight = std::get_if<trace::Weight>(&record)) start.weights.push_back(*weight);
    if (const auto* first = std::get_if<trace::FirstGrid>(&record)) {
      start.first_grid = *first;
      has_first_grid = true;
    }
  }
  if (!has_first_grid || start.weights.empty())
    throw InputError(fmt::format("{}: expected the records 'first_grid' and 'weight' of step (v), found none",
                                 reader.path()));
  return start;
}

Grid adopt(const Grid& grid, TraceStart& start, TracePoints& points) {
  Grid adopted = grid;
  for (std::size_t w = 0; w < start.weights.size(); ++w) {
    Corners tet;
    try {
      for (int v = 0; v < 4; ++v) tet[v] = points.find(start.weights[w].tet[v]);
    } catch (const Divergence& unknown) {
      throw Divergence{"the first grid: " + unknown.what +
                       "; tetproof-compare tells which of steps (i) to (iv) made it"};
    }
    if (!start.named.emplace(sorted(tet), w).second)
      throw Divergence{"the first grid: the tetrahedron at " + text(start.weights[w].tet) +
                       " is listed twice"};
  }
  for (const auto& [place, number] : points.known()) adopted.mesh.points[number] = place;
  for (std::size_t t = 0; t < grid.mesh.tets.size(); ++t) {
    const auto& [a, b, c, d] = grid.mesh.tets[t];
    const auto& x = adopted.mesh.points;
    if (!start.named.contains(sorted(grid.mesh.tets[t])))
      throw Divergence{"the first grid: no tetrahedron at " + text(std::array{x[a], x[b], x[c], x[d]})};
    if (orientation(x[a], x[b], x[c], x[d]) <= 0)
      throw Divergence{"the first grid: the tetrahedron at " + text(std::array{x[a], x[b], x[c], x[d]}) +
                       " is not positive with these coordinates"};
  }
  if (start.named.size() != grid.mesh.tets.size())
    throw Divergence{
        fmt::format("the first grid has {} tetrahedra, not {}", grid.mesh.tets.size(), start.named.size())};
  return adopted;
}

void compare_weights(const TraceStart& start, const Insertion& insertion, const TracePoints& points) {
  const trace::FirstGrid& theirs = start.first_grid;
  const Adaptation& ours = insertion.so_far();
  const auto expect_curvature = [&](const std::optional<double>& found, double of_ours,
                                    std::string_view name) {
    if (found && std::abs(*found - of_ours) > agree * ours.kappa_max) expect(*found, of_ours, name);
  };
  expect_curvature(theirs.kappa_min, ours.kappa_min, "the smallest absolute curvature (D15)");
  expect_curvature(theirs.kappa_max, ours.kappa_max, "the largest absolute curvature (D15)");
  for (Index t = 0; t < insertion.grid().grid().numbers(); ++t) {
    const trace::Weight& weight = start.weights[start.named.at(sorted(insertion.grid().grid().corners(t)))];
    compare(weight, insertion.grid().weight(t), points.reach(), ours.kappa_max);
  }
  expect(theirs.v0, ours.law.v0, "V0");
  expect(theirs.v1, ours.law.v1, "V1");
  expect(theirs.d1, ours.law.d1, "d1");
  if (!same_average(insertion, theirs.e_avg, ours.e_avg_first))
    expect(theirs.e_avg, ours.e_avg_first, "E_avg of the first grid, eq. (3.4),");
}

double rounding_of_averages(const Insertion& insertion) {
  return 1e-14 * insertion.so_far().mean_volume;
}

bool same_average(const Insertion& insertion, double a, double b) {
  return close(a, b) || std::abs(a - b) <= rounding_of_averages(insertion);
}

}  // namespace tetproof::reference
