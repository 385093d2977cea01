// SPDX-License-Identifier: GPL-3.0-or-later
// Steps (i) to (iv) of two traces: settings, lattice, indicators, moved vertices, cuts, rows of Table 2,
// mapped points.
#pragma once

#include <array>
#include <memory>
#include <set>
#include <vector>

#include "verify/compare/keyed_records.hpp"
#include "verify/compare/tolerance.hpp"

namespace tetproof::verify {

/// The reference's steps (i) to (iv), and the comparison of the other's with them.
class FirstSteps {
 public:
  /// Reads up to the first record of step (v).
  FirstSteps(TraceStream& reference, double tolerance);

  /// Reads the other trace as far and adds what differs. Notes say what is not compared because only one of
  /// the two tells it.
  void compare(TraceStream& other, Differences& differences, std::vector<std::string>& notes);

  /// "tetrahedron xyz of cell (i, j, k), row 12a of Table 2": the lattice tetrahedron of the reference that
  /// holds a point; without the row where the reference does not tell it.
  std::string lattice_tetrahedron(const trace::Point& point) const;

  const Tolerance& tolerance() const { return tolerance_; }
  const trace::Settings& settings() const { return settings_; }
  double diagonal() const { return (lattice_.box[1] - lattice_.box[0]).stableNorm(); }  ///< of the lattice
  /// The largest coordinate of the lattice's box.
  double magnitude() const;

 private:
  using IndicatorRecords = KeyedRecords<std::array<int, 2>, trace::Indicators>;
  /// The other's indicators, which wait until all is known that explains them.
  struct Waiting {
    const IndicatorRecords::Entry* reference;
    trace::Indicators other;
    std::int64_t line;
  };
  /// Lattice vertices of one trace.
  struct Vertices {
    std::set<trace::LatticeVertex> mended;
    std::set<trace::LatticeVertex> near;  ///< a cut of one of their edges is where they are

    /// Whether rounding decides that it is on the surface, or was taken there.
    bool doubtful(const trace::LatticeVertex& v) const { return near.contains(v) || mended.contains(v); }
  };

  template <class Take>
  void read(TraceStream& stream, const Take& take);
  void note(Vertices& vertices, const trace::Record& record) const;
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
