// SPDX-License-Identifier: GPL-3.0-or-later
// Compares step (v) of two traces: the tetrahedra of the first grid, and their values of eqs (3.1) to (3.4)
// and (3.6).
#pragma once

#include <optional>
#include <unordered_map>

#include "verify/compare/compare_first_steps.hpp"
#include "verify/compare/trace_points.hpp"
#include "verify/compare/trace_splits.hpp"

namespace tetproof::verify {

/// The reference's first grid. Compares the other trace's first grid with it.
class FirstGrid {
 public:
  /// Reads the reference up to its first insertion or its end. `steps` belongs to the same reference and must
  /// outlive this object.
  FirstGrid(TraceStream& reference, const FirstSteps& steps);

  /// Reads the other trace up to the same place and adds what differs. `not_compared` gets what only
  /// one trace has.
  void compare(TraceStream& other, Differences& differences, std::vector<std::string>& not_compared);

  const std::optional<trace::FirstGrid>& summary() const { return summary_; }
  /// Its tetrahedra, by their points; empty if the reference does not say them.
  std::vector<TetKey> tets() const;
  TracePoints& points() { return points_; }  ///< the first grid's points, to which insertions add theirs

 private:
  struct Entry {
    std::array<int, 4> points;
    double d, kappa, omega, volume, desired, error;  // kappa is NaN without curvature
    std::int64_t line, partner;                      // the partner's line in the other trace; 0: none yet
  };
  trace::Weight record(const Entry& entry) const;
  double desired_volume(double d) const;  ///< needs `summary_`
  double curvature_scale() const;         ///< [1/length]
  void compare_weight(const Entry& entry, const trace::Weight& weight, std::int64_t line,
                      Differences& differences) const;
  void compare_summary(const std::optional<trace::FirstGrid>& other, std::int64_t other_line,
                       Differences& differences) const;

  std::string name(const trace::Tet& tet) const;

  const FirstSteps& steps_;
  Tolerance tolerance_;
  TracePoints points_;
  std::vector<Entry> tets_;
  std::unordered_map<TetKey, std::size_t, ArrayHash> by_points_;
  std::optional<trace::FirstGrid> summary_;
  std::int64_t summary_line_ = 0;
};

}  // namespace tetproof::verify
