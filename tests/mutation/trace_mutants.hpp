// SPDX-License-Identifier: GPL-3.0-or-later
// Changes a trace at random, as a mistake in an implementation or in a file would.
#pragma once

#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace tetproof::mutation {

/// The kinds of changes.
enum class Operation {
  key_changed,
  key_dropped,
  key_exchanged,  ///< with the same key of another record of its kind
  record_dropped,
  record_doubled,
  record_exchanged,  ///< with the next one, where the order counts
  cut_at_byte,
  cut_at_line
};
const char* name_of(Operation);
inline constexpr int operations = 8;

struct Mutant {
  Operation operation;
  std::string kind;  ///< of the changed record
  std::string what;  ///< the change, for people
  std::string text;  ///< the whole file
  /// The lines of `text`, from 1, at which the change can be found. A changed key: the record's line. A key
  /// that two records have exchanged: both lines. If a change gives a record the name of another one (the
  /// same edge, cell, vertex, tetrahedron, ...), that one's line too, because the two cannot be told apart.
  /// A dropped record is missed
  /// - of step (i), at the next record;
  /// - of steps (ii) to (iv), at the first record after these steps;
  /// - `first_grid`: at the first record after step (v); `weight`: at the `first_grid` record;
  /// - from step (vi) on, at one of the following records up to the next insertion or the end; `end`: at the
  ///   last line.
  /// A doubled record: its two lines. Two exchanged records: their lines, and where the one that now comes
  /// too late is missed. A file that is cut: its last line.
  std::set<std::int64_t> lines;
  /// Dropped settings, or the only record of its kind: they may be left out, which is told.
  bool left_out = false;
};

/// One change at random. `trace`: the lines of a trace that begins with its settings.
Mutant mutate(const std::vector<std::string>& trace, std::mt19937_64& random);

}  // namespace tetproof::mutation
