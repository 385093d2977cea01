// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the positions of nodes by the tags that a file gives them.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// Collects tags one by one. Consecutive tags, the usual case, take no memory.
class Tags {
 public:
  Tags(std::vector<std::int64_t>& tags, std::int64_t& first) : tags_(tags), first_(first) {}

  /// `position`: the number of tags that were added before.
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

  /// Adds `count` consecutive tags from `tag` on, if they continue the tags so far. Otherwise adds none and
  /// returns false.
  bool add_run(std::size_t position, std::int64_t tag, std::size_t count) {
    const bool goes_on = tag == static_cast<std::int64_t>(static_cast<std::uint64_t>(first_) + position);
    if (!tags_.empty() || count == 0 || (position > 0 && !goes_on)) return false;
    if (position == 0) first_ = tag;
    return true;
  }

  /// Adds `count` tags, which the caller writes to the returned address.
  std::int64_t* spelled_out(std::size_t position, std::size_t count);

  /// Keeps only the first `position` tags.
  void cut(std::size_t position) {
    if (!tags_.empty()) tags_.resize(position);
  }

 private:
  void spell_out(std::size_t position);

  std::vector<std::int64_t>& tags_;
  std::int64_t& first_;
};

/// Finds nodes by their tags. The memory depends on the number of nodes, never on the largest tag.
class NodeIndex {
 public:
  /// `document` must outlive the index. Nodes that are added later are not found. If several nodes have the
  /// same tag, it stands for the first of them. The document gets a warning if they have the same
  /// coordinates; otherwise InputError is thrown.
  explicit NodeIndex(Document& document);

  /// The position of the node with this tag. If there is none, the tag is entered as `document.unknown[k]`
  /// and the result is -1-k.
  Index operator()(std::int64_t tag) {
    const std::uint64_t offset = static_cast<std::uint64_t>(tag) - static_cast<std::uint64_t>(least_);
    if (consecutive_) return offset < nodes_ ? static_cast<Index>(offset) : unknown(tag);
    if (offset < dense_.size()) return dense_[offset] >= 0 ? dense_[offset] : unknown(tag);
    return find(tag);
  }

  /// The same, but negative if no node has the tag, which is not entered. Several threads may call it at
  /// once.
  Index known(std::int64_t tag) const { return Known(*this)(tag); }

  /// The same for long loops: holds the parts of the index that they need, so that these stay in registers.
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
