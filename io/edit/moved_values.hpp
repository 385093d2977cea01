// SPDX-License-Identifier: GPL-3.0-or-later
// Moves values to other nodes or elements, and numbers that stay behind those that go.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// A row of values that goes to a node or an element; `to` is negative as in `Values::at`. `local`: for
/// values of elements' nodes, which of the row's nodes are taken; empty: all.
struct MovedRow {
  Index to;
  std::size_t row;
  std::span<const std::int32_t> local{};
};

/// The position of a row's node or element; negative as in `Values::at`.
inline Index item_of(const Values& values, std::size_t row) {
  return values.at.empty() ? static_cast<Index>(values.first + row) : values.at[row];
}

/// Replaces the rows of `values` by those given. Positions that count up are stored as `first`.
void move_rows(Values& values, std::span<const MovedRow> rows);

/// Sets the numbers of nodes or elements; numbers that count up are stored as their first.
void set_numbers(std::vector<std::int64_t> numbers, std::vector<std::int64_t>& tags, std::int64_t& first);

}  // namespace tetproof::io
