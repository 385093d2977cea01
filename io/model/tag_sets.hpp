// SPDX-License-Identifier: GPL-3.0-or-later
// Stores each set of tags (physical groups, partitions) once, for the many entities and blocks that share it.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

class TagSets {
 public:
  explicit TagSets(Document& document) : sets_(document.tag_sets) {
    for (const auto& set : sets_) known_.emplace(set, static_cast<std::int32_t>(known_.size()));
  }

  /// The position of `tags` in `document.tag_sets`. Adds the set if it is new.
  std::int32_t operator()(const std::vector<std::int64_t>& tags) {
    if (tags == sets_[last_]) return last_;
    const auto [place, is_new] = known_.try_emplace(tags, static_cast<std::int32_t>(sets_.size()));
    if (is_new) sets_.push_back(tags);
    return last_ = place->second;
  }

 private:
  std::vector<std::vector<std::int64_t>>& sets_;
  std::map<std::vector<std::int64_t>, std::int32_t> known_;
  std::int32_t last_ = 0;
};

}  // namespace tetproof::io
