// SPDX-License-Identifier: GPL-3.0-or-later
// What statements of OBJ say of the elements below them, and what elements name at their corners.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// Names in the order of their first use.
class ObjLabels {
 public:
  std::int64_t operator()(const std::string& name) {
    const auto [place, is_new] = known_.try_emplace(name, static_cast<std::int64_t>(names_.size()));
    if (is_new) names_.push_back(name);
    return place->second;
  }
  std::vector<std::string> take() { return std::move(names_); }

 private:
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::int64_t> known_;
};

/// A statement that holds for the elements below it: nothing is stored until there is one.
struct ObjState {
  bool said = false;
  std::string name;         // as it stands now
  std::int64_t number = 0;  // likewise; -1: a name not yet numbered
  std::vector<std::int64_t> of_elements;
  ObjLabels labels;

  void set(std::string text) { said = true, name = std::move(text), number = -1; }
  void add_element(std::size_t elements_before) {
    if (!said) return;
    if (of_elements.empty() && elements_before > 0) of_elements.assign(elements_before, labels(""));
    if (number < 0) number = labels(name);
    of_elements.push_back(number);
  }
};

/// Values of corners: `vt` or `vn`.
struct ObjCorners {
  std::vector<std::array<double, 3>> all;
  std::int64_t above = 0;  // how many stand above the statement at hand
  int components = 0;
  std::size_t bad = 0;  // elements that name one that does not exist, or none at some corners
  std::vector<bool> used;
  std::vector<std::int64_t> named;  // by the element at hand, from 0; none: -1
  Values values;

  /// When all of `all` are there, and elements begin.
  void start(const char* name) {
    values.name = name;
    values.components = components;
    used.resize(all.size());
  }
  void add_element(std::size_t element) {
    const auto count = static_cast<std::int64_t>(all.size());
    if (std::all_of(named.begin(), named.end(), [](std::int64_t i) { return i == none_named; })) return;
    if (std::any_of(named.begin(), named.end(), [&](std::int64_t i) { return i < 0 || i >= count; })) {
      ++bad;
      return;
    }
    values.at.push_back(static_cast<Index>(element));
    values.nodes.push_back(static_cast<std::int32_t>(named.size()));
    for (const std::int64_t i : named) {
      const auto& numbers = all[static_cast<std::size_t>(i)];
      values.reals.insert(values.reals.end(), numbers.begin(), numbers.begin() + components);
      used[static_cast<std::size_t>(i)] = true;
    }
  }
  static constexpr std::int64_t none_named = INT64_MIN;
};

}  // namespace tetproof::io
