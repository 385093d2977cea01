// SPDX-License-Identifier: GPL-3.0-or-later
// Compares two runs of the paper's method, decision by decision, and names the first place where they differ
// in the paper's words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tetproof::verify {

/// One of two traces, at the place where they differ.
struct TraceSide {
  std::string file;
  std::int64_t line = 0;  ///< line of the record in question, from 1; 0: the trace has no such record
  std::string says;       ///< the record in words
  std::string record;     ///< the record, one line of JSON; empty: none, or several
};

struct TraceComparison {
  enum class Verdict {
    equal,
    tie,      ///< they differ where two choices are equally good, or where rounding decides
    diverges  ///< one of them is not the paper's method, as the reference reads it
  };
  Verdict verdict = Verdict::equal;
  std::string step;            ///< the decision that differs, a name of `trace_steps`; empty if equal
  std::string place;           ///< its place in the paper: "step (vi), eq. (3.5)"
  std::int64_t insertion = 0;  ///< the number of the insertion, from 1; 0: before the first
  std::string what;            ///< one sentence
  /// How many records differ in this step; 1 in step (vi), which the first difference ends.
  std::int64_t count = 0;
  TraceSide reference, other;
  std::int64_t insertions = 0, flips = 0;  ///< how many were equal before the first difference
  std::int64_t reordered = 0;              ///< insertions whose order differs within a tie
  std::vector<std::string> notes;          ///< what was not compared, and ties met
};

/// The decisions that are compared, in the order in which differences are looked for. Their names are the
/// words of `TraceComparison::step`.
struct TraceStep {
  const char* name;
  const char* place;
};
const std::vector<TraceStep>& trace_steps();

/// Compares two traces (corpus/vectors/TRACE.md). Points are the same if they are closer than `tolerance`, in
/// diagonals of the reference's lattice. Numbers are the same if their relative difference is less than
/// `tolerance` (for lengths: their difference in diagonals). The order of the points of a tetrahedron does
/// not matter, nor does the order of the records of one kind before the first insertion. Keeps in memory the
/// reference up to its first insertion, and the points of the rest. InputError for a file that is no trace,
/// or whose records do not come in the order of the format.
TraceComparison compare_traces(const std::string& other, const std::string& reference,
                               double tolerance = 1e-9);

/// The comparison in words: one line or a few, each with its line end.
std::string comparison_text(const TraceComparison&);
/// The comparison as JSON; corpus/vectors/TRACE.md describes the keys.
std::string comparison_json(const TraceComparison&);

}  // namespace tetproof::verify
