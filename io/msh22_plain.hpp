// SPDX-License-Identifier: GPL-3.0-or-later
// The elements of a text .msh 2.2 file where every line is as usual, read by several threads.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "io/element_types.hpp"
#include "io/node_index.hpp"
#include "io/numbers.hpp"

namespace tetproof::io {

/// Some of the elements of a file, one after the other.
struct PlainElements22 {
  /// Elements one after the other that are alike in type and tags.
  struct Run {
    const ElementType* type = nullptr;
    std::vector<std::int64_t> tags{};
    std::size_t count = 0;
  };
  std::vector<Run> runs{};
  std::vector<std::int64_t> tags{};  ///< of the elements
  std::vector<Index> nodes{};

  void clear() { runs.clear(), tags.clear(), nodes.clear(); }
};

/// Gives all elements to `take`, in order, and stops behind them. False where a line is unusual: an unknown
/// type, a node that does not exist, more than a few tags, an element that repeats the one before it (as
/// those in several groups do); what was taken must then be given back, and nothing was read.
bool read_plain_elements22(Numbers& in, std::size_t count, const NodeIndex& index,
                           const std::function<void(const PlainElements22&)>& take);

}  // namespace tetproof::io
