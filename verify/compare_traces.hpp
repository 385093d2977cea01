// SPDX-License-Identifier: GPL-3.0-or-later
// Compares two runs of the paper's method decision by decision, and names the first place where they differ
// in the paper's words.
#pragma once

#include <cstdint>
#include <functional>
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

/// What checking one trace against the method says, decision by decision (reference/follow).
struct CheckedTrace {
  std::string cannot;                    ///< why it could not be checked; empty: it was
  bool admissible = true;                ///< whether the method and the readings allow every decision
  std::int64_t line = 0;                 ///< of the first decision that is not admissible
  std::string what;                      ///< that decision, and what the method does instead
  std::int64_t ties = 0;                 ///< decisions that tie with those of the method
  std::vector<std::string> not_checked;  ///< kinds of records that the trace leaves out
};
/// Checks the trace in a file, with the settings that the trace itself states. verify/ has no such function:
/// the caller passes one, so that the judge and the method stay strangers to each other.
using CheckTrace = std::function<CheckedTrace(const std::string& path)>;

struct TraceComparison {
  enum class Verdict {
    equal,
    tie,        ///< they part, and both are admissible to their ends: where they part, choices tie
    diverges,   ///< one of them does not follow the method, or they were asked for different things
    unresolved  ///< they part, and it cannot be decided whether one of them is wrong
  };
  Verdict verdict = Verdict::equal;
  std::string step;            ///< the decision where they part, a name of `trace_steps`; empty if equal
  std::string place;           ///< its place in the paper: "step (vi), eq. (3.5)"
  std::int64_t insertion = 0;  ///< the number of the insertion, from 1; 0: before the first
  std::string what;            ///< one sentence
  /// The number of records that differ in this step. It is 1 in step (vi), where the first difference ends
  /// the comparison of one with the other.
  std::int64_t count = 0;
  TraceSide reference, other;
  /// The file that is wrong, the line and the reason. Empty if none is known to be.
  TraceSide wrong;
  std::int64_t ties = 0;                   ///< if the verdict is `tie`: in how many decisions
  std::int64_t insertions = 0, flips = 0;  ///< numbers of those found equal before the difference
  std::vector<std::string> not_compared;   ///< what one of the traces leaves out
  std::vector<std::string> notes;
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
/// the records of one kind does not matter either. From then on the order counts. Nothing that a trace says
/// of itself is believed: a tetrahedron that an insertion or a flip names must be in the grid as the trace
/// has built it so far, and the qualities of flips are computed again.
///
/// Where the traces part, `check` tells which of them is wrong, or that they tie. Without it the verdict
/// there is `unresolved`, unless one of them contradicts itself.
///
/// Holds in memory all of the reference up to its first insertion, and all points after that. Throws
/// InputError for a file that is no trace, or whose records do not come in the format's order.
TraceComparison compare_traces(const std::string& other, const std::string& reference,
                               double tolerance = 1e-9, const CheckTrace& check = {});

/// "equal", "tie", "diverges" or "unresolved", as in JSON.
const char* name_of(TraceComparison::Verdict verdict);

/// The result as text for people: one to a few lines, each with its line end.
std::string comparison_text(const TraceComparison&);
/// The result as JSON. corpus/vectors/TRACE.md describes the keys.
std::string comparison_json(const TraceComparison&);

}  // namespace tetproof::verify
