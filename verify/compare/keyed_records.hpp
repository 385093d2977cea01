// SPDX-License-Identifier: GPL-3.0-or-later
// Records of one kind, matched by what names them (an edge, a cell) in whatever order each trace gives them.
#pragma once

#include <unordered_map>

#include "verify/compare/point_index.hpp"
#include "verify/compare/trace_differences.hpp"

namespace tetproof::verify {

/// The reference's records R of a kind; each waits for its partner in the other trace. Their differences
/// count for `step`. `always_there`: a run has such records, so that a trace without them leaves them out and
/// is not wrong about them.
template <class Key, class R>
class KeyedRecords {
 public:
  struct Entry {
    R record;
    std::int64_t line = 0, partner = 0;  ///< the partner's line; 0: none yet
  };

  explicit KeyedRecords(Step step, bool always_there = false) : step_(step), always_there_(always_there) {}

  /// Takes the reference's next record.
  void add(const TraceStream& reference, const Key& key, const R& record) {
    const auto [found, fresh] = entries_.try_emplace(key, Entry{record, reference.line()});
    if (!fresh)
      throw InputError(fmt::format("{}:{}: expected another {} record, found the one of line {} again",
                                   reference.path(), reference.line(), trace::name_of(record),
                                   found->second.line));
  }

  /// The reference's record for the other's in this line, which `name(record)` calls; nullptr, and a
  /// difference, if there is none (perhaps `by_rounding`) or an earlier one took it.
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

  /// Adds a difference for each record that found no partner; `name(record)` calls it, and
  /// `by_rounding(record)` says whether rounding decides that there is one.
  template <class Name, class ByRounding>
  void rest(Differences& differences, const Name& name, const ByRounding& by_rounding) const {
    if (left_out()) return;
    for (const auto& [key, entry] : entries_)
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

  /// The reference's record; nullptr for none.
  const R* find(const Key& key) const {
    const auto found = entries_.find(key);
    return found == entries_.end() ? nullptr : &found->second.record;
  }

  bool empty() const { return entries_.empty(); }
  /// One of the two traces leaves these records out; known at its end.
  bool left_out() const { return always_there_ && entries_.empty() == other_has_any_; }

 private:
  Step step_;
  bool always_there_;
  std::unordered_map<Key, Entry, ArrayHash> entries_;
  bool other_has_any_ = false;
};

}  // namespace tetproof::verify
