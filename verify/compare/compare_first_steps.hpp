// SPDX-License-Identifier: GPL-3.0-or-later
// Compares steps (i) to (iv) of two traces: settings, lattice, indicators, moved vertices, cuts, rows of
// Table 2, mapped points.
#pragma once

#include <array>
#include <memory>
#include <set>
#include <vector>

#include "verify/compare/keyed_records.hpp"
#include "verify/compare/tolerance.hpp"

namespace tetproof::verify {

/// The reference's steps (i) to (iv). Compares the other trace's steps with them.
class FirstSteps {
 public:
  /// Reads the reference up to its first record of step (v).
  FirstSteps(TraceStream& reference, double tolerance);

  /// Reads the other trace up to the same place and adds what differs. `not_compared` gets what only
  /// one trace has.
  void compare(TraceStream& other, Differences& differences, std::vector<std::string>& not_compared);

  /// Names the reference's lattice tetrahedron that holds a point: "tetrahedron xyz of cell (i, j, k), row
  /// 12a of Table 2". The row is missing if the reference does not give it.
  std::string lattice_tetrahedron(const trace::Point& point) const;

  const Tolerance& tolerance() const { return tolerance_; }
  const trace::Settings& settings() const { return settings_; }
  /// The diagonal of the lattice's box [length].
  double diagonal() const { return (lattice_.box[1] - lattice_.box[0]).stableNorm(); }

 private:
  using IndicatorRecords = KeyedRecords<std::array<int, 2>, trace::Indicators>;
  /// Indicators of the other trace. They are compared after all records that may explain a difference are
  /// known.
  struct Waiting {
    const IndicatorRecords::Entry* reference;
    trace::Indicators other;
    std::int64_t line;
  };
  /// The lattice vertices of one trace about which rounding may decide.
  struct Vertices {
    std::set<trace::LatticeVertex> mended;
    std::set<trace::LatticeVertex> near;  ///< one of their edges is cut at the vertex itself

    /// Whether rounding decides that the vertex is on the surface, or that it was moved there.
    bool doubtful(const trace::LatticeVertex& v) const { return near.contains(v) || mended.contains(v); }
  };

  template <class Take>
  void read(TraceStream& stream, const Take& take);
  void note(Vertices& vertices, const trace::Record& record) const;
  /// `exact_only`: no tolerance moves lattice vertices near the surface onto it, so rounding of the lattice
  /// decides which vertices are on the surface.
  void compare_indicators(const std::vector<Waiting>& rows, const Vertices& other, bool exact_only,
                          Differences& differences) const;
  trace::Point position(const trace::LatticeVertex& vertex) const;  ///< eq. (2.1)

  Tolerance tolerance_;
  trace::Settings settings_;
  trace::Lattice lattice_;
  std::int64_t settings_line_ = 0, lattice_line_ = 0;
  Vertices vertices_;
  IndicatorRecords indicators_{Step::indicators, true};
  KeyedRecords<trace::LatticeVertex, trace::Moved> moved_{Step::moved};
  KeyedRecords<std::array<int, 6>, trace::Cut> cuts_{Step::cut};
  KeyedRecords<std::array<int, 3>, trace::Rows> rows_{Step::table2, true};
  std::unique_ptr<PointIndex> from_;
  KeyedRecords<std::array<int, 1>, trace::Mapped> mapped_{Step::mapped};
};

}  // namespace tetproof::verify
