// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model/values.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace tetproof::io {

bool has_step(const Values& values) {
  return values.time != 0 || std::signbit(values.time) || values.step != 0 || values.partition != 0 ||
         !values.interpolation.empty();
}

bool plain_numbers(const Values& values, std::size_t items) {
  return values.components > 0 && items > 0 && values.labels.empty() && values.nodes.empty() &&
         !has_step(values) && values.reals.empty() != values.integers.empty() &&
         values.size() == items * static_cast<std::size_t>(values.components);
}

bool of_all(const Values& values, std::size_t items) {
  return values.at.empty() && values.first == 0 && plain_numbers(values, items);
}

bool of_some(const Values& values, std::size_t items) {
  if (values.at.empty()) return of_all(values, items);
  return values.at.size() < items && values.first == 0 && plain_numbers(values, values.at.size()) &&
         values.at.front() >= 0 && static_cast<std::size_t>(values.at.back()) < items &&
         std::adjacent_find(values.at.begin(), values.at.end(), std::greater_equal<>()) == values.at.end();
}

}  // namespace tetproof::io
