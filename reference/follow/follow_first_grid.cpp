// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/follow/follow_first_grid.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "io/error.hpp"
#include "reference/engine/first_grid/exact.hpp"

namespace tetproof::reference {
namespace {

// Two numbers that are not equal, with as many digits as it takes to see that.
Divergence unequal(std::string_view name, double ours, double theirs, std::int64_t line) {
  for (int digits = 12; digits < 17; ++digits)
    if (const auto a = fmt::format("{:.{}g}", ours, digits), b = fmt::format("{:.{}g}", theirs, digits);
        a != b)
      return {fmt::format("{} is {}, not {}", name, a, b), line};
  return {fmt::format("{} is {:.17g}, not {:.17g}", name, ours, theirs), line};
}

// `place`: a difference of d below this [length] is rounding. Where a centroid lies on a surface vertex, d is
// only rounding, and a relative comparison would fail. V(d) may differ by what such a d makes of it.
void compare(const trace::Weight& theirs, std::int64_t line, const Weight& ours, const VolumeLaw& law,
             double place, double kappa_max, bool with_curvature) {
  const auto expect = [line](double a, double b, const std::string& name) {
    if (!close(a, b)) throw unequal(name, b, a, line);
  };
  const std::string at = " of the tetrahedron at " + text(theirs.tet);
  if (with_curvature && !theirs.kappa)
    throw Divergence{"the absolute curvature kappa (D15)" + at + " is missing", line};
  if (std::abs(theirs.d - ours.d) > place) expect(theirs.d, ours.d, "d, eq. (3.2)," + at);
  if (theirs.kappa && std::abs(*theirs.kappa - ours.kappa) > agree * kappa_max)
    expect(*theirs.kappa, ours.kappa, "the absolute curvature kappa (D15)" + at);
  expect(theirs.omega, ours.omega, "omega, eq. (3.6)," + at);
  const double size = std::max(ours.volume, ours.desired);
  if (std::abs(theirs.volume - ours.volume) > agree * size) expect(theirs.volume, ours.volume, "V" + at);
  const double d = ours.omega * ours.d, slack = ours.omega * place + agree * d;
  const double rounding = std::max(std::abs(desired_volume(d + slack, law) - ours.desired),
                                   std::abs(desired_volume(std::max(0.0, d - slack), law) - ours.desired));
  if (std::abs(theirs.desired - ours.desired) > rounding)
    expect(theirs.desired, ours.desired, "V(d), eq. (3.1)," + at);
  if (std::abs(theirs.error - ours.error) > agree * size + rounding)
    expect(theirs.error, ours.error, "E, eq. (3.3)," + at);
}

// Throws Divergence if the V(d) that the trace states are those of eq. (3.1) with other constants than its
// first_grid record states: then that record is at fault and not the weights. V(d) is linear in d^p, so that
// two weights give the constants, and all others must agree.
void expect_law(const TraceStart& start, const VolumeLaw& law) {
  const auto d = [](const trace::Weight& w) { return w.omega * w.d; };
  const auto ends =
      std::minmax_element(start.weights.begin(), start.weights.end(),
                          [&](const trace::Weight& a, const trace::Weight& b) { return d(a) < d(b); });
  const trace::Weight &low = *ends.first, &high = *ends.second;
  const auto power = [&](const trace::Weight& w) { return std::pow(d(w), law.p); };
  const double x0 = power(low), y0 = low.desired, width = power(high) - x0;
  const auto by_others = [&](const trace::Weight& w) {
    return width > 0 ? y0 + (power(w) - x0) / width * (high.desired - y0) : y0;
  };
  const auto by_law = [&](const trace::Weight& w) { return desired_volume(d(w), law); };
  const auto fit = [&](const auto& volume) {
    return std::all_of(start.weights.begin(), start.weights.end(), [&](const trace::Weight& w) {
      return std::abs(w.desired - volume(w)) <= agree * std::max(law.v0, law.v1);
    });
  };
  if (start.weights.size() > 2 && !fit(by_law) && fit(by_others))
    throw Divergence{"V(d) of all tetrahedra is eq. (3.1) with other V0, V1 or d1 than are stated",
                     start.first_grid_line};
}

}  // namespace

TraceStart read_start(trace::Reader& reader, std::optional<trace::Record>& next) {
  TraceStart start;
  for (; next; next = reader.next()) {
    const trace::Record& record = *next;
    if (const auto* weight = std::get_if<trace::Weight>(&record)) {
      start.weights.push_back(*weight);
      start.lines.push_back(reader.line());
    } else if (const auto* first = std::get_if<trace::FirstGrid>(&record)) {
      if (start.first_grid_line) throw Divergence{"step (v): a second first_grid record"};
      start.first_grid = *first;
      start.first_grid_line = reader.line();
    } else if (std::holds_alternative<trace::Insertion>(record) ||
               std::holds_alternative<trace::Flip>(record) || std::holds_alternative<trace::End>(record)) {
      break;
    } else {
      throw Divergence{fmt::format("step (v): a record of an earlier step, '{}'", trace::name_of(record))};
    }
  }
  if (!start.first_grid_line || start.weights.empty())
    throw InputError(fmt::format(
        "{}:{}: expected the records 'first_grid' and 'weight' of step (v), found {}", reader.path(),
        reader.line(), next ? fmt::format("'{}'", trace::name_of(*next)) : "the end of the file"));
  return start;
}

Grid adopt(const Grid& grid, TraceStart& start, TracePoints& points) {
  Grid adopted = grid;
  for (std::size_t w = 0; w < start.weights.size(); ++w) {
    Corners tet;
    try {
      for (int v = 0; v < 4; ++v) tet[v] = points.find(start.weights[w].tet[v]);
    } catch (const Divergence& unknown) {
      throw Divergence{
          "the first grid: " + unknown.what + "; tetproof-compare tells which of steps (i) to (iv) made it",
          start.lines[w]};
    }
    if (!start.named.emplace(sorted(tet), w).second)
      throw Divergence{
          "the first grid: the tetrahedron at " + text(start.weights[w].tet) + " is listed twice",
          start.lines[w]};
  }
  for (const auto& [place, number] : points.known()) adopted.mesh.points[number] = place;
  for (std::size_t t = 0; t < grid.mesh.tets.size(); ++t) {
    const auto& [a, b, c, d] = grid.mesh.tets[t];
    const auto& x = adopted.mesh.points;
    const auto named = start.named.find(sorted(grid.mesh.tets[t]));
    if (named == start.named.end()) continue;  // named below
    if (orientation(x[a], x[b], x[c], x[d]) <= 0)
      throw Divergence{"the first grid: the tetrahedron at " + text(std::array{x[a], x[b], x[c], x[d]}) +
                           " is not positive with these coordinates",
                       start.lines[named->second]};
  }
  // A tetrahedron of the trace that our grid does not have is said before one that the trace does not have.
  std::set<Corners> ours;
  for (const auto& tet : grid.mesh.tets) ours.insert(sorted(tet));
  std::size_t strange = start.weights.size();
  for (const auto& [tet, w] : start.named)
    if (!ours.contains(tet)) strange = std::min(strange, w);
  if (strange < start.weights.size())
    throw Divergence{
        "the first grid: the tetrahedron at " + text(start.weights[strange].tet) + " is not in it",
        start.lines[strange]};
  for (const Corners& tet : ours)
    if (!start.named.contains(tet)) {
      const auto& x = adopted.mesh.points;
      throw Divergence{
          "the first grid: no tetrahedron at " + text(std::array{x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]}),
          start.first_grid_line};
    }
  return adopted;
}

void compare_weights(const TraceStart& start, const Insertion& insertion, const TracePoints& points) {
  const trace::FirstGrid& theirs = start.first_grid;
  const Adaptation& ours = insertion.so_far();
  const auto expect_curvature = [&](const std::optional<double>& found, double of_ours,
                                    std::string_view name) {
    if (!found && ours.with_curvature)
      throw Divergence{fmt::format("{} is missing", name), start.first_grid_line};
    if (found && std::abs(*found - of_ours) > agree * ours.kappa_max)
      throw unequal(name, of_ours, *found, start.first_grid_line);
  };
  const auto expect = [&](double found, double of_ours, std::string_view name) {
    if (!close(found, of_ours)) throw unequal(name, of_ours, found, start.first_grid_line);
  };
  const auto expect_count = [&](std::int64_t found, std::int64_t of_ours, std::string_view name) {
    if (found != of_ours)
      throw Divergence{fmt::format("the first grid has {} {}, not {}", of_ours, name, found),
                       start.first_grid_line};
  };
  expect_count(theirs.points, insertion.grid().grid().points(), "points");
  expect_count(theirs.tets, insertion.grid().grid().tets(), "tetrahedra");
  expect(theirs.mean_volume, ours.mean_volume, "the mean volume");
  expect(theirs.v0, ours.law.v0, "V0");
  expect(theirs.v1, ours.law.v1, "V1");
  expect(theirs.d1, ours.law.d1, "d1");
  expect(theirs.e_avg_goal.value_or(0), insertion.e_avg_goal(), "the E_avg at which the insertion ends");
  expect_curvature(theirs.kappa_min, ours.kappa_min, "the smallest absolute curvature (D15)");
  expect_curvature(theirs.kappa_max, ours.kappa_max, "the largest absolute curvature (D15)");
  try {
    for (Index t = 0; t < insertion.grid().grid().numbers(); ++t) {
      const std::size_t w = start.named.at(sorted(insertion.grid().grid().corners(t)));
      compare(start.weights[w], start.lines[w], insertion.grid().weight(t), ours.law, points.reach(),
              ours.kappa_max, ours.with_curvature);
    }
  } catch (const Divergence&) {
    expect_law(start, ours.law);
    throw;
  }
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
