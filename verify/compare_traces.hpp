// SPDX-License-Identifier: GPL-3.0-or-later
// Compares two runs of the paper's method decision by decision, and names the first place where they differ
// in the paper's words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tetproof::verify {

/// What one of the two traces says at the place of a difference.
struct TraceSide {
  std::string file;
  std::int64_t line = 0;  ///< the line of the record, from 1; 0: there is no record
  std::string says;       ///< for people
  std::string record;     ///< the record as one line of JSON; empty: there is none, or there are several
};

struct TraceComparison {
  enum class Verdict {
    equal,
    tie,      ///< they differ where two choices are equally good, or where rounding decides
    diverges  ///< one of them does not follow the paper's method as the reference reads it
  };
  Verdict verdict = Verdict::equal;
  std::string step;            ///< the decision, a name of `trace_steps`; empty if equal
  std::string place;           ///< its place in the paper: "step (vi), eq. (3.5)"
  std::int64_t insertion = 0;  ///< the number of the insertion, from 1; 0: before the first
  std::string what;            ///< one sentence
  /// The number of records that differ in this step. It is 1 in step (vi), where the first difference ends
  /// the comparison.
  std::int64_t count = 0;
  TraceSide reference, other;
  std::int64_t insertions = 0, flips = 0;  ///< numbers of those found equal before the difference
  std::int64_t reordered = 0;              ///< insertions that came in another order within a tie
  std::vector<std::string> notes;          ///< what was not compared, and the ties that were met
};

/// The decisions that are compared, in the order in which differences are looked for. `name` is the word in
/// `TraceComparison::step`.
struct TraceStep {
  const char* name;
  const char* place;
};
const std::vector<TraceStep>& trace_steps();

/// Compares two traces (format: corpus/vectors/TRACE.md).
///
/// `tolerance` is relative. Points and lengths are the same if they differ by at most `tolerance` diagonals
/// of the reference's lattice; other numbers are the same if they differ by at most this fraction of
/// themselves. The order of a tetrahedron's points does not matter. Before the first insertion, the order of
/// the records of one kind does not matter either.
///
/// Holds in memory all of the reference up to its first insertion, and all points after that. Throws
/// InputError for a file that is no trace, or whose records do not come in the format's order.
TraceComparison compare_traces(const std::string& other, const std::string& reference,
                               double tolerance = 1e-9);

/// The result as text for people: one to a few lines, each with its line end.
std::string comparison_text(const TraceComparison&);
/// The result as JSON. corpus/vectors/TRACE.md describes the keys.
std::string comparison_json(const TraceComparison&);

}  // namespace tetproof::verify
