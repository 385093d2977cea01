// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model/node_index.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "io/bytes/large_pages.hpp"
#include "io/error.hpp"

namespace tetproof::io {

void Tags::spell_out(std::size_t position) {
  for (std::size_t i = 0; i < position; ++i)
    tags_.push_back(static_cast<std::int64_t>(static_cast<std::uint64_t>(first_) + i));
}

std::int64_t* Tags::spelled_out(std::size_t position, std::size_t count) {
  const std::size_t all = position + count;
  if (all > tags_.capacity()) reserve_in_large_pages(tags_, std::max(all, 2 * position));
  if (tags_.empty()) spell_out(position);
  tags_.resize(all);
  return tags_.data() + position;
}

NodeIndex::NodeIndex(Document& document) : document_(document), nodes_(document.points.size()) {
  for (std::size_t k = 0; k < document.unknown.size(); ++k)
    unknown_.emplace(document.unknown[k], -1 - static_cast<Index>(k));
  const std::vector<std::int64_t>& tags = document.node_tags;
  if (tags.empty()) {
    consecutive_ = true;
    least_ = document.first_node;
    return;
  }
  const auto [least, most] = std::minmax_element(tags.begin(), tags.end());
  least_ = *least;
  const std::uint64_t range = static_cast<std::uint64_t>(*most) - static_cast<std::uint64_t>(*least);
  if (range < 4 * nodes_) {
    dense_.assign(range + 1, -1);
    for (std::size_t i = 0; i < tags.size(); ++i) {
      Index& place = dense_[static_cast<std::uint64_t>(tags[i]) - static_cast<std::uint64_t>(least_)];
      if (place < 0)
        place = static_cast<Index>(i);
      else
        repeated(place, static_cast<Index>(i));
    }
    return;
  }
  mask_ = std::bit_ceil(2 * tags.size()) - 1;
  table_.assign(mask_ + 1, -1);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const std::size_t place = slot(tags[i]);
    if (table_[place] < 0)
      table_[place] = static_cast<Index>(i);
    else
      repeated(table_[place], static_cast<Index>(i));
  }
}

// The slot that holds the node with this tag, or the empty slot where it would go.
std::size_t NodeIndex::slot(std::int64_t tag) const {
  std::uint64_t mixed = static_cast<std::uint64_t>(tag) * 0x9e3779b97f4a7c15u;
  mixed = (mixed ^ mixed >> 32) * 0xd6e8feb86659fd93u;
  std::size_t place = (mixed ^ mixed >> 32) & mask_;
  while (table_[place] >= 0 && document_.node_tags[table_[place]] != tag) place = (place + 1) & mask_;
  return place;
}

Index NodeIndex::find(std::int64_t tag) {
  if (table_.empty()) return unknown(tag);
  const Index position = table_[slot(tag)];
  return position >= 0 ? position : unknown(tag);
}

Index NodeIndex::unknown(std::int64_t tag) {
  const auto [place, is_new] = unknown_.try_emplace(tag, -1 - static_cast<Index>(document_.unknown.size()));
  if (is_new) document_.unknown.push_back(tag);
  return place->second;
}

void NodeIndex::repeated(Index first, Index again) {
  const Eigen::Vector3d &a = document_.points[first], &b = document_.points[again];
  // The bits count: NaN equals itself, and -0 is not 0. NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
  if (std::memcmp(a.data(), b.data(), sizeof(double) * 3) != 0)
    throw InputError(
        fmt::format("{}: node {} is given twice with different coordinates: ({}, {}, {}) and ({}, {}, {})",
                    document_.path, document_.node_tag(first), a.x(), a.y(), a.z(), b.x(), b.y(), b.z()));
  if (repeated_++ == 0)
    document_.warnings.push_back(
        fmt::format("{}: node {} is given twice with the same coordinates (the first such)", document_.path,
                    document_.node_tag(first)));
}

}  // namespace tetproof::io
