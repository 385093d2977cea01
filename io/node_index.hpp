// SPDX-License-Identifier: GPL-3.0-or-later
// From the tags that a file gave its nodes to their positions.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// Tags collected one by one; consecutive ones, the usual case, take no memory.
class Tags {
 public:
  Tags(std::vector<std::int64_t>& tags, std::int64_t& first) : tags_(tags), first_(first) {}

  /// `position`: how many were added before.
  void add(std::size_t position, std::int64_t tag) {
    if (!tags_.empty())
      tags_.push_back(tag);
    else if (position == 0)
      first_ = tag;
    else if (tag != static_cast<std::int64_t>(static_cast<std::uint64_t>(first_) + position))
      spell_out(position, tag);
  }

  void add(std::size_t position, const std::vector<std::int64_t>& tags) {
    for (const std::int64_t tag : tags) add(position++, tag);
  }

 private:
  void spell_out(std::size_t position, std::int64_t tag);

  std::vector<std::int64_t>& tags_;
  std::int64_t& first_;
};

/// Finds nodes by their tags. Memory grows with the number of nodes, never with the largest tag.
class NodeIndex {
 public:
  /// `document` must outlive the index; nodes added later are not found. A tag that several nodes have stands
  /// for the first of them: a warning if all have the same coordinates, InputError naming the file otherwise.
  explicit NodeIndex(Document& document);

  /// The position of the node with this tag, or -1-k after entering it as `document.unknown[k]`.
  Index operator()(std::int64_t tag) {
    const std::uint64_t offset = static_cast<std::uint64_t>(tag) - static_cast<std::uint64_t>(least_);
    if (consecutive_) return offset < nodes_ ? static_cast<Index>(offset) : unknown(tag);
    if (offset < dense_.size()) return dense_[offset] >= 0 ? dense_[offset] : unknown(tag);
    return find(tag);
  }

  /// The same for several threads at once; negative where no node has the tag, which is not entered.
  Index known(std::int64_t tag) const {
    const std::uint64_t offset = static_cast<std::uint64_t>(tag) - static_cast<std::uint64_t>(least_);
    if (consecutive_) return offset < nodes_ ? static_cast<Index>(offset) : -1;
    if (offset < dense_.size()) return dense_[offset];
    return table_.empty() ? -1 : table_[slot(tag)];
  }

 private:
  Index find(std::int64_t tag);
  Index unknown(std::int64_t tag);
  std::size_t slot(std::int64_t tag) const;
  void repeated(Index first, Index again);

  Document& document_;
  bool consecutive_ = false;
  std::int64_t least_ = 0;
  std::uint64_t nodes_ = 0;
  std::vector<Index> dense_;  // position of the node with tag least_ + i; -1: none
  std::vector<Index> table_;  // positions, by hashed tag, linear probing; -1: empty
  std::size_t mask_ = 0;
  std::size_t repeated_ = 0;
  std::unordered_map<std::int64_t, Index> unknown_;
};

}  // namespace tetproof::io
