// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/edit/moved_values.hpp"

#include <utility>

namespace tetproof::io {
namespace {

bool counts_up(const std::vector<std::int64_t>& numbers) {
  for (std::size_t i = 1; i < numbers.size(); ++i)
    if (numbers[i] <= numbers[i - 1] || numbers[i] - 1 != numbers[i - 1]) return false;
  return true;
}

template <class Number>
void take(const std::vector<Number>& from, std::vector<Number>& to, std::size_t start, std::size_t count) {
  if (from.empty()) return;
  const auto begin = from.begin() + static_cast<std::ptrdiff_t>(start);
  to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
}

}  // namespace

void move_rows(Values& values, std::span<const MovedRow> rows) {
  const std::vector<double> reals = std::exchange(values.reals, {});
  const std::vector<std::int64_t> integers = std::exchange(values.integers, {});
  const std::vector<std::int32_t> nodes = std::exchange(values.nodes, {});
  const auto each = static_cast<std::size_t>(values.components > 0 ? values.components : 0);
  std::vector<std::size_t> starts;  // of rows of different lengths
  for (std::size_t row = 0, start = 0; row < nodes.size();
       start += static_cast<std::size_t>(nodes[row++]) * each)
    starts.push_back(start);
  values.at.clear();
  bool ascending = true;
  for (const MovedRow& moved : rows) {
    const std::size_t start = nodes.empty() ? moved.row * each : starts[moved.row];
    const auto length = nodes.empty() ? std::int32_t{1} : nodes[moved.row];
    if (moved.local.empty()) {
      take(reals, values.reals, start, static_cast<std::size_t>(length) * each);
      take(integers, values.integers, start, static_cast<std::size_t>(length) * each);
    }
    for (const std::int32_t k : moved.local) {
      take(reals, values.reals, start + static_cast<std::size_t>(k) * each, each);
      take(integers, values.integers, start + static_cast<std::size_t>(k) * each, each);
    }
    if (!nodes.empty())
      values.nodes.push_back(moved.local.empty() ? length : static_cast<std::int32_t>(moved.local.size()));
    ascending = ascending && moved.to >= 0 &&
                (values.at.empty() || moved.to == values.at.front() + static_cast<Index>(values.at.size()));
    values.at.push_back(moved.to);
  }
  values.first = 0;
  if (!ascending || values.at.empty()) return;
  values.first = static_cast<std::size_t>(values.at.front());
  values.at.clear();
}

void set_numbers(std::vector<std::int64_t> numbers, std::vector<std::int64_t>& tags, std::int64_t& first) {
  if (!numbers.empty() && counts_up(numbers)) {
    first = numbers.front();
    numbers.clear();
  }
  tags = std::move(numbers);
}

}  // namespace tetproof::io
