// SPDX-License-Identifier: GPL-3.0-or-later
// Two runs of the paper's method, decision by decision: the first place where they differ, in the paper's
// words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tetproof::verify {

/// What one of two traces says at a place.
struct TraceSide {
  std::string file;
  std::int64_t line = 0;  ///< of the record in question, from 1; 0: it has none
  std::string says;       ///< for people
  std::string record;     ///< the record, one line of JSON; empty: none, or several
};

struct TraceComparison {
  enum class Verdict {
    equal,
    tie,      ///< they part where two choices are equally good, or where rounding decides
    diverges  ///< one of them is not the paper's method, as the reference reads it
  };
  Verdict verdict = Verdict::equal;
  std::string step;            ///< which decision: see `trace_steps`; empty if equal
  std::string place;           ///< its place in the paper: "step (vi), eq. (3.5)"
  std::int64_t insertion = 0;  ///< the number of the insertion, from 1; 0: before the first
  std::string what;            ///< one sentence
  std::int64_t count =
      0;  ///< how many records differ in this step; 1 in step (vi), where the first one ends it
  TraceSide reference, other;
  std::int64_t insertions = 0, flips = 0;  ///< found the same before the two part
  std::int64_t reordered = 0;              ///< insertions that came in another order within a tie
  std::vector<std::string> notes;          ///< what was not compared, and ties met
};

/// The decisions that are compared, in the order in which a difference is looked for: the words of
/// `TraceComparison::step`.
struct TraceStep {
  const char* name;
  const char* place;
};
const std::vector<TraceStep>& trace_steps();

/// Compares two traces (corpus/vectors/TRACE.md). `tolerance`: points that are closer than this, in diagonals
/// of the reference's lattice, are the same, and numbers that differ by less than this part of themselves
/// (lengths: of the diagonal). The order of the points of a tetrahedron does not matter, nor that of the
/// records of one kind before the first insertion. Holds the reference up to its first insertion in memory,
/// and of the rest the points. Throws InputError for a file that is no trace or whose records don't come in
/// the format's order.
TraceComparison compare_traces(const std::string& other, const std::string& reference,
                               double tolerance = 1e-9);

/// For people: one to a few lines, each with its line end.
std::string comparison_text(const TraceComparison&);
/// As JSON; corpus/vectors/TRACE.md describes the keys.
std::string comparison_json(const TraceComparison&);

}  // namespace tetproof::verify
