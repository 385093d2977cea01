// SPDX-License-Identifier: GPL-3.0-or-later
// From the tags that a file gave its nodes to their positions.
#pragma once

#include <cstdint>
#include <span>
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
    else if (tag != static_cast<std::int64_t>(static_cast<std::uint64_t>(first_) + position)) {
      tags_.reserve(2 * position + 2);
      spell_out(position);
      tags_.push_back(tag);
    }
  }

  void add(std::size_t position, std::span<const std::int64_t> tags) {
    for (const std::int64_t tag : tags) add(position++, tag);
  }

  /// `count` tags that go up from `tag`; false, and none were added, where that cannot be told so shortly.
  bool add_run(std::size_t position, std::int64_t tag, std::size_t count) {
    const bool goes_on = tag == static_cast<std::int64_t>(static_cast<std::uint64_t>(first_) + position);
    if (!tags_.empty() || count == 0 || (position > 0 && !goes_on)) return false;
    if (position == 0) first_ = tag;
    return true;
  }

  /// The place of `count` tags that the caller fills in.
  std::int64_t* spelled_out(std::size_t position, std::size_t count);

  /// Takes back all but the first `position`.
  void cut(std::size_t position) {
    if (!tags_.empty()) tags_.resize(position);
  }

 private:
  void spell_out(std::size_t position);

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
  Index known(std::int64_t tag) const { return Known(*this)(tag); }

  /// The same for long loops, which find what they need of the index in registers.
  class Known {
   public:
    explicit Known(const NodeIndex& index)
        : index_(index),
          least_(static_cast<std::uint64_t>(index.least_)),
          consecutive_(index.consecutive_ ? index.nodes_ : 0) {}
    Index operator()(std::int64_t tag) const {
      const std::uint64_t offset = static_cast<std::uint64_t>(tag) - least_;
      return offset < consecutive_ ? static_cast<Index>(offset) : elsewhere(tag, offset);
    }

   private:
    Index elsewhere(std::int64_t tag, std::uint64_t offset) const {
      if (offset < index_.dense_.size()) return index_.dense_[offset];
      return index_.table_.empty() ? -1 : index_.table_[index_.slot(tag)];
    }

    const NodeIndex& index_;
    const std::uint64_t least_, consecutive_;
  };

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
