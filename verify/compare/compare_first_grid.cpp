// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare/compare_first_grid.hpp"

#include <limits>

namespace tetproof::verify {
namespace {

using namespace trace;

constexpr double rounding = 1e-12;  // of curvatures, relative to the largest
constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Passes the records of step (v), which may come in any order, to `take`.
template <class Take>
void read(TraceStream& stream, const Take& take) {
  bool summary = false;
  for (;; stream.take()) {
    if (const auto* first = stream.next_is<trace::FirstGrid>()) {
      if (summary) stream.fail("one first_grid record");
      summary = true;
      take(*first);
    } else if (const auto* weight = stream.next_is<Weight>()) {
      take(*weight);
    } else if (!stream.next() || stream.next_is<Insertion>() || stream.next_is<End>()) {
      return;
    } else {
      stream.fail("first_grid, weight, insertion or end");
    }
  }
}

}  // namespace

FirstGrid::FirstGrid(TraceStream& reference, const FirstSteps& steps)
    : steps_(steps), tolerance_(steps.tolerance()), points_(tolerance_.length) {
  read(reference, [&](const auto& record) {
    if constexpr (std::is_same_v<std::decay_t<decltype(record)>, Weight>) {
      Entry entry{{},           record.d,         record.kappa.value_or(none),
                  record.omega, record.volume,    record.desired,
                  record.error, reference.line(), 0};
      for (int i = 0; i < 4; ++i) entry.points[i] = points_.number(Side::reference, record.tet[i]);
      const auto [found, fresh] = by_points_.try_emplace(sorted(entry.points), tets_.size());
      if (!fresh)
        throw InputError(
            fmt::format("{}:{}: expected another weight record, found the tetrahedron of line {} again",
                        reference.path(), reference.line(), tets_[found->second].line));
      tets_.push_back(entry);
    } else {
      summary_ = record;
      summary_line_ = reference.line();
    }
  });
}

std::string FirstGrid::name(const Tet& tet) const {
  return fmt::format("tetrahedron at {} of the first grid", at(tet));
}

Weight FirstGrid::record(const Entry& entry) const {
  Weight weight;
  weight.d = entry.d;
  weight.omega = entry.omega;
  weight.volume = entry.volume;
  weight.desired = entry.desired;
  weight.error = entry.error;
  for (int i = 0; i < 4; ++i) weight.tet[i] = points_.at(entry.points[i]);
  if (!std::isnan(entry.kappa)) weight.kappa = entry.kappa;
  return weight;
}

// The magnitude of the curvatures. At least 1 / diagonal, because the curvatures of a flat surface are only
// rounding.
double FirstGrid::curvature_scale() const {
  return std::max(summary_ ? summary_->kappa_max.value_or(0) : 0, 1 / steps_.diagonal());
}

// Eq. (3.1) with the reference's constants.
double FirstGrid::desired_volume(double d) const {
  const double t = std::pow(d / summary_->d1, steps_.settings().p);
  return std::max((1 - t) * summary_->v0 + t * summary_->v1, std::min(summary_->v0, summary_->v1));
}

std::vector<TetKey> FirstGrid::tets() const {
  std::vector<TetKey> all;
  for (const Entry& entry : tets_) all.push_back(sorted(entry.points));
  return all;
}

void FirstGrid::compare_weight(const Entry& a, const Weight& b, std::int64_t line,
                               Differences& differences) const {
  const auto compare = [&](Step step, const char* what, bool same, double reference, double other,
                           bool by_rounding = false) {
    if (same) return;
    differences.add(
        step, a.line, line,
        [&] {
          const auto [one, two] = apart(reference, other);
          return Differences::Difference{
              fmt::format("{} of the {} is {} in reference, {} in other", what, name(b.tet), one, two),
              {a.line, one, to_line(record(a))},
              {line, two, to_line(b)}};
        },
        by_rounding);
  };
  const double mean = summary_ ? summary_->mean_volume : 0;
  const double volumes = std::max({std::abs(mean), std::abs(a.volume), std::abs(a.desired)});
  compare(Step::distance, "the distance d", std::abs(a.d - b.d) <= tolerance_.length, a.d, b.d);
  const double kappa = b.kappa.value_or(none), largest = curvature_scale();
  compare(Step::curvature, "the absolute curvature kappa",
          std::isnan(a.kappa) ? std::isnan(kappa) : tolerance_.same(a.kappa, kappa, largest), a.kappa, kappa);
  // If all curvatures are equal up to rounding, the weights can have any size.
  const bool all_alike = summary_ && summary_->kappa_min && summary_->kappa_max &&
                         *summary_->kappa_max - *summary_->kappa_min <= rounding * largest;
  compare(Step::weight, "the weight omega", tolerance_.same(a.omega, b.omega, 1), a.omega, b.omega,
          all_alike);
  compare(Step::volume, "the volume V", tolerance_.same(a.volume, b.volume, mean), a.volume, b.volume);
  // A distance that is right within the tolerance may change V(d) by more than the tolerance: the root
  // functions of eq. (3.1) are steep at 0.
  double by_distance = 0;
  if (summary_)
    for (const double d :
         {a.omega * a.d + tolerance_.length, std::max(0.0, a.omega * a.d - tolerance_.length)})
      by_distance = std::max(by_distance, std::abs(desired_volume(d) - desired_volume(a.omega * a.d)));
  compare(Step::desired, "the desired volume V(d)",
          tolerance_.same(a.desired, b.desired, mean) || std::abs(a.desired - b.desired) <= by_distance,
          a.desired, b.desired);
  compare(Step::error, "the error E",
          tolerance_.same(a.error, b.error, volumes) || std::abs(a.error - b.error) <= by_distance, a.error,
          b.error);
}

void FirstGrid::compare_summary(const std::optional<trace::FirstGrid>& other, std::int64_t other_line,
                                Differences& differences) const {
  if (!summary_ && !other) return;
  const auto sides = [&](const std::string& what, const std::string& a, const std::string& b) {
    return Differences::Difference{what,
                                   {summary_line_, a, summary_ ? to_line(*summary_) : ""},
                                   {other_line, b, other ? to_line(*other) : ""}};
  };
  if (!summary_ || !other) {
    differences.add(Step::first_grid, summary_line_, other_line, [&] {
      return sides(
          fmt::format("{} is adapted (it has a first_grid record)", summary_ ? "reference" : "other"),
          summary_ ? "adapts the grid" : "does not", other ? "adapts the grid" : "does not");
    });
    return;
  }
  const auto compare = [&](Step step, const char* what, bool same, const auto& a, const auto& b,
                           bool asked = false) {
    if (same) return;
    differences.add(step, summary_line_, other_line, [&] {
      const auto [one, two] = apart(a, b);
      Differences::Difference made =
          sides(fmt::format("{} is {} in reference, {} in other", what, one, two), one, two);
      made.asked = asked;
      return made;
    });
  };
  const trace::FirstGrid &a = *summary_, &b = *other;
  const auto numbers = [&](Step step, const char* what, double in_a, double in_b, double scale = 0) {
    compare(step, what, tolerance_.same(in_a, in_b, scale), in_a, in_b);
  };
  const auto curvatures = [&](const char* what, const std::optional<double>& in_a,
                              const std::optional<double>& in_b) {
    compare(Step::curvature, what,
            in_a && in_b ? tolerance_.same(*in_a, *in_b, curvature_scale())
                         : in_a.has_value() == in_b.has_value(),
            in_a.value_or(none), in_b.value_or(none));
  };
  compare(Step::first_grid, "the number of tetrahedra of the first grid", a.tets == b.tets, a.tets, b.tets);
  compare(Step::first_grid, "the number of points of the first grid", a.points == b.points, a.points,
          b.points);
  curvatures("the smallest absolute curvature", a.kappa_min, b.kappa_min);
  curvatures("the largest absolute curvature", a.kappa_max, b.kappa_max);
  numbers(Step::volume_law, "the mean volume", a.mean_volume, b.mean_volume);
  numbers(Step::volume_law, "V_0", a.v0, b.v0);
  numbers(Step::volume_law, "V_1", a.v1, b.v1);
  compare(Step::volume_law, "d_1", std::abs(a.d1 - b.d1) <= tolerance_.length, a.d1, b.d1);
  numbers(Step::average, "E_avg of the first grid", a.e_avg, b.e_avg, a.mean_volume);
  const double goal = a.e_avg_goal.value_or(0), other_goal = b.e_avg_goal.value_or(0);
  compare(Step::average, "the E_avg at which the insertion ends", tolerance_.same(goal, other_goal), goal,
          other_goal, true);
}

void FirstGrid::compare(TraceStream& other, Differences& differences,
                        std::vector<std::string>& not_compared) {
  std::optional<trace::FirstGrid> summary;
  std::int64_t summary_line = 0;
  const auto where = [&](const Tet& tet) {
    const Point centroid = (tet[0] + tet[1] + tet[2] + tet[3]) / 4;
    return fmt::format("{} (in lattice {})", name(tet), steps_.lattice_tetrahedron(centroid));
  };
  bool any = false;
  read(other, [&](const auto& record) {
    const std::int64_t line = other.line();
    if constexpr (std::is_same_v<std::decay_t<decltype(record)>, Weight>) {
      any = true;
      std::array<int, 4> points;
      for (int i = 0; i < 4; ++i) points[i] = points_.number(Side::other, record.tet[i]);
      if (tets_.empty()) return;
      const auto found = by_points_.find(sorted(points));
      Entry* const entry = found == by_points_.end() ? nullptr : &tets_[found->second];
      if (entry && !entry->partner) {
        entry->partner = line;
        return compare_weight(*entry, record, line, differences);
      }
      differences.add(Step::first_grid, entry ? entry->line : 0, line, [&] {
        return Differences::Difference{
            fmt::format("{}: {} in other", where(record.tet), entry ? "twice" : "only"),
            {entry ? entry->line : 0, entry ? "has it once" : "nothing",
             entry ? to_line(this->record(*entry)) : ""},
            {line, short_text(record.tet), to_line(record)}};
      });
    } else {
      summary = record;
      summary_line = line;
    }
  });
  compare_summary(summary, summary_line, differences);
  if (any == tets_.empty() && summary_ && summary)
    not_compared.push_back(fmt::format("the tetrahedra of the first grid: {} has no weight records",
                                       tets_.empty() ? "reference" : "other"));
  if (!any) return;
  for (const Entry& entry : tets_)
    if (!entry.partner)
      differences.add(Step::first_grid, entry.line, 0, [&] {
        const Weight weight = record(entry);
        return Differences::Difference{fmt::format("{}: only in reference", where(weight.tet)),
                                       {entry.line, short_text(weight.tet), to_line(weight)},
                                       {0, "nothing"}};
      });
}

}  // namespace tetproof::verify
