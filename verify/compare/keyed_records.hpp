// SPDX-License-Identifier: GPL-3.0-or-later
// Matches the records of one kind in two traces by their keys (an edge, a cell), in whatever order each trace
// has them.
#pragma once

#include <unordered_map>

#include "verify/compare/point_index.hpp"
#include "verify/compare/trace_differences.hpp"

namespace tetproof::verify {

/// The reference's records of one kind R. Each waits for its partner in the other trace. Differences are
/// added to `step`. `always_there`: every run has such records; a trace without any has left them out, which
/// is no difference.
template <class Key, class R>
class KeyedRecords {
 public:
  struct Entry {
    R record;
    std::int64_t line = 0, partner = 0;  ///< `partner`: the line of the partner; 0: none yet
  };

  explicit KeyedRecords(Step step, bool always_there = false) : step_(step), always_there_(always_there) {}

  /// Adds the reference's next record. Throws InputError if its key is there already.
  void add(const TraceStream& reference, const Key& key, const R& record) {
    const auto [found, fresh] = entries_.try_emplace(key, Entry{record, reference.line()});
    if (!fresh)
      throw InputError(fmt::format("{}:{}: expected another {} record, found the one of line {} again",
                                   reference.path(), reference.line(), trace::name_of(record),
                                   found->second.line));
  }

  /// Finds the reference's record for a record of the other trace. If there is none, or if it already has a
  /// partner, adds a difference and returns nullptr. `line`: the line of `record` in the other trace.
  /// `name(record)`: its name in messages. `by_rounding`: rounding may explain that the reference has none.
  template <class Name>
  const Entry* match(std::int64_t line, const Key& key, const R& record, Differences& differences,
                     const Name& name, bool by_rounding = false) {
    other_has_any_ = true;
    if (left_out()) return nullptr;
    const auto found = entries_.find(key);
    if (found == entries_.end()) {
      differences.add(
          step_, 0, line,
          [&] {
            return Differences::Difference{fmt::format("{}: only in other", name(record)),
                                           {0, "nothing"},
                                           {line, "has it", trace::to_line(record)}};
          },
          by_rounding);
      return nullptr;
    }
    Entry& entry = found->second;
    if (entry.partner) {
      differences.add(step_, entry.line, line, [&] {
        return Differences::Difference{
            fmt::format("{}: twice in other", name(record)),
            {entry.line, "once", trace::to_line(entry.record)},
            {line, fmt::format("again, after line {}", entry.partner), trace::to_line(record)}};
      });
      return nullptr;
    }
    entry.partner = line;
    return &entry;
  }

  /// Adds a difference for each record without a partner. `name(record)`: its name in messages.
  /// `by_rounding(record)`: whether rounding decides if there is such a record.
  template <class Name, class ByRounding>
  void rest(Differences& differences, const Name& name, const ByRounding& by_rounding) const {
    if (left_out()) return;
    for (const auto& keyed : entries_) {
      const Entry& entry = keyed.second;
      if (!entry.partner)
        differences.add(
            step_, entry.line, 0,
            [&] {
              return Differences::Difference{fmt::format("{}: only in reference", name(entry.record)),
                                             {entry.line, "has it", trace::to_line(entry.record)},
                                             {0, "nothing"}};
            },
            by_rounding(entry.record));
    }
  }

  /// The reference's record with this key; nullptr if there is none.
  const R* find(const Key& key) const {
    const auto found = entries_.find(key);
    return found == entries_.end() ? nullptr : &found->second.record;
  }

  bool empty() const { return entries_.empty(); }
  /// Whether one of the two traces leaves these records out. Only known after both were read.
  bool left_out() const { return always_there_ && entries_.empty() == other_has_any_; }

 private:
  Step step_;
  bool always_there_;
  std::unordered_map<Key, Entry, ArrayHash> entries_;
  bool other_has_any_ = false;
};

}  // namespace tetproof::verify
