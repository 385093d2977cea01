// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/edit/joint_values.hpp"

#include <cstddef>
#include <utility>

#include "io/edit/moved_values.hpp"

namespace tetproof::io {
namespace {

bool alike(const Values& a, const Values& b) {
  return a.name == b.name && a.components == b.components && a.reals.empty() == b.reals.empty() &&
         a.labels == b.labels && a.texts == b.texts && a.nodes.empty() == b.nodes.empty() &&
         a.of_view == b.of_view && a.time == b.time && a.step == b.step && a.partition == b.partition &&
         a.interpolation == b.interpolation && a.length_power == b.length_power;
}

template <class Item>
void append(std::vector<Item>& all, const std::vector<Item>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void list_positions(Values& values) {
  std::vector<Index> at;
  for (std::size_t row = 0; row < values.items(); ++row) at.push_back(item_of(values, row));
  values.at = std::move(at);
  values.first = 0;
}

void join(Values& all, Values&& more) {
  const std::size_t before = all.items(), items = more.items();
  const bool goes_on = all.at.empty() && more.at.empty() && all.first + before == more.first;
  if (before == 0) {
    all.first = more.first;
    all.at = std::move(more.at);
  } else if (items > 0 && !goes_on) {
    list_positions(all);
    list_positions(more);
    append(all.at, more.at);
  }
  append(all.reals, more.reals);
  append(all.integers, more.integers);
  append(all.nodes, more.nodes);
}

}  // namespace

void join_values(std::vector<Values>& all, std::vector<Values>&& more, Index by, Index unknown) {
  std::vector<bool> is_free(all.size(), true);
  for (Values& values : more) {
    if (values.at.empty())
      values.first += static_cast<std::size_t>(by);
    else
      for (Index& at : values.at) at = moved_behind(at, by, unknown);
    std::size_t k = 0;
    while (k < is_free.size() && !(is_free[k] && alike(all[k], values))) ++k;
    if (k == is_free.size()) {
      all.push_back(std::move(values));
    } else {
      is_free[k] = false;
      join(all[k], std::move(values));
    }
  }
}

}  // namespace tetproof::io
