// SPDX-License-Identifier: GPL-3.0-or-later
// The shared parts of comparing two traces: a stream of records, the collected differences, and words for
// messages.
#pragma once

#include <fmt/format.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "io/error.hpp"
#include "io/trace.hpp"
#include "verify/compare_traces.hpp"

namespace tetproof::verify {

/// The compared decisions, each before the decisions that depend on it.
enum class Step {
  settings,
  lattice,
  indicators,
  table3,
  moved,
  cut,
  table2,
  mapped,
  first_grid,
  distance,
  curvature,
  weight,
  volume,
  volume_law,
  desired,
  error,
  average,
  choice,
  table4,
  point,
  average_after,
  flips,
  end
};

/// The word of `TraceComparison::step`.
inline const char* name_of(Step step) {
  return trace_steps()[static_cast<std::size_t>(step)].name;
}

/// A trace that is being read, with access to the next record.
class TraceStream {
 public:
  explicit TraceStream(const std::string& path) : reader_(path) { take(); }

  const trace::Record* next() const { return next_ ? &*next_ : nullptr; }
  template <class R>
  const R* next_is() const {
    return next_ ? std::get_if<R>(&*next_) : nullptr;
  }
  std::int64_t line() const { return reader_.line(); }  ///< the line of the next record
  const std::string& path() const { return reader_.path(); }
  void take() { next_ = reader_.next(); }

  [[noreturn]] void fail(std::string_view expected) const {
    fail(expected, next_ ? trace::name_of(*next_) : "the end of the trace");
  }
  [[noreturn]] void fail(std::string_view expected, std::string_view found) const {
    throw InputError(fmt::format("{}:{}: expected {}, found {}", path(), line(), expected, found));
  }

 private:
  trace::Reader reader_;
  std::optional<trace::Record> next_;
};

/// What one trace says at a difference.
struct Says {
  std::int64_t line = 0;
  std::string says;
  std::string record{};
};

/// Collects differences, which may come in any order. For each step, keeps their number and the first one in
/// the order of the reference. Differences that rounding decides only count if the step has no others.
class Differences {
 public:
  struct Difference {
    std::string what;
    Says reference, other;
    bool asked = false;  ///< the two runs were asked for different things, so neither need be wrong
  };
  /// `make()` returns the difference; it is called only if this is the first one so far. A line is 0 if that
  /// trace has no record; such differences of the other trace come after those with a record in the
  /// reference. `by_rounding`: two correct implementations can differ here.
  template <class Make>
  void add(Step step, std::int64_t reference_line, std::int64_t other_line, const Make& make,
           bool by_rounding = false) {
    Found& found = found_[{step, by_rounding}];
    ++found.count;
    const std::pair order{reference_line == 0, reference_line ? reference_line : other_line};
    if (found.count > 1 && order >= found.order) return;
    found.order = order;
    found.difference = make();
  }
  bool none() const { return found_.empty(); }
  /// Whether `step` is the earliest one that differs.
  bool first_is(Step step) const { return !none() && found_.begin()->first.first == step; }
  bool has(Step step) const { return found_.contains({step, false}) || found_.contains({step, true}); }
  /// Fills in `result` with the difference of the earliest step.
  void tell(TraceComparison& result) const;

 private:
  struct Found {
    std::int64_t count = 0;
    std::pair<bool, std::int64_t> order;
    Difference difference;
  };
  std::map<std::pair<Step, bool>, Found> found_;
};

/// Fills in `result` with a difference: its place, and what both traces say.
void tell(TraceComparison& result, Step step, std::int64_t count, const Differences::Difference& difference);

// Words.
std::string text(const trace::Point& point);           ///< (x, y, z), with all digits
std::string text(const trace::LatticeVertex& vertex);  ///< (i, j, k)
std::string short_text(const trace::Point& point);     ///< (x, y, z), with six digits; the record has all
std::string short_text(const trace::Tet& tet);         ///< its four points
std::string at(const trace::Tet& tet);                 ///< its centroid, with a few digits
/// Two numbers with one digit more than is needed to see that they differ; at least `digits`.
std::pair<std::string, std::string> apart(double a, double b, int digits = 4);
std::pair<std::string, std::string> apart(std::int64_t a, std::int64_t b);
std::string counted(std::int64_t n, const char* one, const char* many);

}  // namespace tetproof::verify
