// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of numbers behind the points or faces of a text: any number of them behind each, and none behind some.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// Collects the rows of numbers that a reader finds behind its items, and makes values of them.
class Rows {
 public:
  /// `whole`: each number is written as an integer.
  void add(std::size_t item, std::span<const double> numbers, bool whole);
  /// Adds values called `name` to `all`, one for each length of a row. They are integers if all their numbers
  /// are whole.
  void give(std::vector<Values>& all, const std::string& name, std::size_t items) &&;
  bool empty() const { return groups_.empty(); }

 private:
  struct Group {
    std::vector<Index> at;
    std::vector<double> numbers;
    bool whole = true;
  };
  std::map<std::size_t, Group> groups_;  // by the length of a row
};

/// Finds the row of numbers that a writer puts behind each item. Several values can share the rows if no item
/// is in two of them and their numbers of components differ: `Rows` tells them apart again.
class RowsOf {
 public:
  explicit RowsOf(std::size_t items) : items_(items) {}
  /// False, and nothing changes, if `Rows` could not give these values back.
  bool add(const Values& values);
  const std::vector<const Values*>& held() const { return held_; }
  bool empty() const { return held_.empty(); }
  /// The values of an item, and the item's position in them; null if it has none.
  const Values* find(std::size_t item, std::size_t& row) const {
    if (of_.empty()) return nullptr;
    row = static_cast<std::size_t>(row_[item]);
    return of_[item] < 0 ? nullptr : held_[static_cast<std::size_t>(of_[item])];
  }
  /// Whether every item has the same number of numbers behind it.
  bool complete() const;
  int most_components() const;

 private:
  std::size_t items_;
  std::vector<const Values*> held_;
  std::vector<std::int8_t> of_;  // of each item: a position in held_, or -1
  std::vector<Index> row_;
};

}  // namespace tetproof::io
