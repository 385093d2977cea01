// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/edit/joint_numbers.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "io/edit/moved_values.hpp"
#include "io/edit/origin.hpp"

namespace tetproof::io {
namespace {

using Numbers = std::vector<std::int64_t>;

template <class TagOf>
NumbersOf numbers_of(std::size_t count, bool of_file, const TagOf& tag) {
  NumbersOf all{.numbers = Numbers(count), .of_file = of_file && count > 0};
  for (std::size_t i = 0; i < count; ++i) all.numbers[i] = tag(i);
  return all;
}

bool meet(Numbers a, Numbers b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  Numbers both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return !both.empty();
}

}  // namespace

NumbersOf NumbersOf::nodes(const Document& document) {
  return numbers_of(document.points.size(), has_node_numbers(document),
                    [&](std::size_t i) { return document.node_tag(i); });
}

NumbersOf NumbersOf::elements(const Document& document) {
  return numbers_of(document.elements(), has_element_numbers(document),
                    [&](std::size_t i) { return document.element_tag(i); });
}

JointNumbers join_numbers(NumbersOf all, NumbersOf more) {
  JointNumbers joint;
  joint.of_files = all.of_file || more.of_file;
  const bool first_moves = !all.of_file && more.of_file;
  const bool both_there = !all.numbers.empty() && !more.numbers.empty();
  if (both_there && (!all.of_file || !more.of_file || meet(all.numbers, more.numbers))) {
    Numbers& moving = first_moves ? all.numbers : more.numbers;
    const Numbers& staying = first_moves ? more.numbers : all.numbers;
    const auto [low, high] = std::minmax_element(moving.begin(), moving.end());
    const auto [least, most] = std::minmax_element(staying.begin(), staying.end());
    constexpr std::int64_t limit = std::int64_t{1} << 60;
    if (std::min(*low, *least) < -limit || std::max(*high, *most) > limit) {
      joint.all_move = joint.more_move = true;
      return joint;
    }
    const std::int64_t step = *most - *low + 1;
    for (std::int64_t& number : moving) number += step;
    (first_moves ? joint.all_move : joint.more_move) = step != 0;
  }
  all.numbers.insert(all.numbers.end(), more.numbers.begin(), more.numbers.end());
  set_numbers(std::move(all.numbers), joint.tags, joint.first);
  return joint;
}

}  // namespace tetproof::io
