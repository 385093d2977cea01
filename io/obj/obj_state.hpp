// SPDX-License-Identifier: GPL-3.0-or-later
// Statements of OBJ that hold for the elements below them, and values that elements name at their corners.
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

/// A statement that holds for the elements below it. Nothing is stored before the first one.
struct ObjState {
  bool said = false;
  std::string name;         // that holds now
  std::int64_t number = 0;  // of this name; -1: it has none yet
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

/// Values at corners: `vt` or `vn`.
struct ObjCorners {
  std::vector<std::array<double, 3>> all;
  std::int64_t above = 0;  // how many stand above the statement at hand
  int components = 0;
  std::vector<bool> used;
  std::vector<std::int64_t>
      named;  // by the corners of the element at hand, from 0; -1: one that does not exist
  Values values;

  /// Called when `all` is complete, before the first element.
  void start(const char* name) {
    values.name = name;
    values.components = components;
    used.resize(all.size());
  }
  /// Takes what the element's corners name. False, and nothing is taken, if they name some that do not exist,
  /// or not at every corner.
  bool add_element(std::size_t element) {
    const auto count = static_cast<std::int64_t>(all.size());
    if (std::all_of(named.begin(), named.end(), [](std::int64_t i) { return i == none_named; })) return true;
    if (std::any_of(named.begin(), named.end(), [&](std::int64_t i) { return i < 0 || i >= count; }))
      return false;
    values.at.push_back(static_cast<Index>(element));
    values.nodes.push_back(static_cast<std::int32_t>(named.size()));
    for (const std::int64_t i : named) {
      const auto& numbers = all[static_cast<std::size_t>(i)];
      values.reals.insert(values.reals.end(), numbers.begin(), numbers.begin() + components);
      used[static_cast<std::size_t>(i)] = true;
    }
    return true;
  }
  static constexpr std::int64_t none_named = INT64_MIN;
};

}  // namespace tetproof::io
