// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/rows.hpp"

#include <algorithm>
#include <cmath>

#include "io/model/values.hpp"

namespace tetproof::io {

void Rows::add(std::size_t item, std::span<const double> numbers, bool whole) {
  if (numbers.empty()) return;
  Group& group = groups_[numbers.size()];
  group.at.push_back(static_cast<Index>(item));
  group.numbers.insert(group.numbers.end(), numbers.begin(), numbers.end());
  group.whole = group.whole && whole;
}

void Rows::give(std::vector<Values>& all, const std::string& name, std::size_t items) && {
  for (auto& [components, group] : groups_) {
    Values values{.name = name, .components = static_cast<int>(components)};
    if (group.whole)
      for (const double number : group.numbers) values.integers.push_back(static_cast<std::int64_t>(number));
    else
      values.reals = std::move(group.numbers);
    if (group.at.size() != items) values.at = std::move(group.at);
    all.push_back(std::move(values));
  }
  groups_.clear();
}

bool RowsOf::add(const Values& values) {
  if (!of_some(values, items_)) return false;
  for (const std::int64_t number : values.integers)  // the reader reads them as doubles
    if (std::abs(static_cast<double>(number)) > 9007199254740992.0) return false;
  for (const Values* other : held_)
    if (other->components == values.components) return false;
  if (of_.empty()) of_.assign(items_, -1), row_.resize(items_);
  const auto item = [&](std::size_t i) {
    return values.at.empty() ? i : static_cast<std::size_t>(values.at[i]);
  };
  const std::size_t count = values.items();
  for (std::size_t i = 0; i < count; ++i)
    if (of_[item(i)] >= 0) return false;
  for (std::size_t i = 0; i < count; ++i) {
    of_[item(i)] = static_cast<std::int8_t>(held_.size());
    row_[item(i)] = static_cast<Index>(i);
  }
  held_.push_back(&values);
  return true;
}

bool RowsOf::complete() const {
  return held_.size() == 1 && held_[0]->at.empty();
}

int RowsOf::most_components() const {
  int most = 0;
  for (const Values* values : held_) most = std::max(most, values->components);
  return most;
}

}  // namespace tetproof::io
