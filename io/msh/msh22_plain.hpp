// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes and elements of .msh 2.2 where they are as usual, lines of text or binary records, read by several
// threads. False where they are few or anything about them is unusual (an unknown type, a node that does not
// exist, more than a few tags, bytes in the other order): then nothing was read.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "io/model/element_types.hpp"
#include "io/model/node_index.hpp"
#include "io/msh/numbers.hpp"

namespace tetproof::io {

/// Some of the elements of a file, one after the other.
struct PlainElements22 {
  /// Elements one after the other that are alike in type and tags.
  struct Run {
    const ElementType* type = nullptr;
    std::size_t tags = 0;  ///< so many of `run_tags`
    std::size_t count = 0;
  };
  std::vector<Run> runs{};
  std::vector<std::int64_t> run_tags{};  ///< one run's after the other's
  std::vector<std::int64_t> tags{};      ///< of the elements
  std::vector<Index> nodes{};
  bool repeats =
      false;  ///< an element may have the nodes of the one before it, as those in several groups do

  void clear() { runs.clear(), run_tags.clear(), tags.clear(), nodes.clear(), repeats = false; }
};
using TakeElements22 = std::function<void(const PlainElements22&)>;

bool read_plain_nodes22(Numbers& in, std::size_t count, Document& document, Tags& tags);

/// Gives all elements to `take`, in order, and stops behind them. False as above; what was taken must then be
/// given back.
bool read_plain_elements22(Numbers& in, std::size_t count, const NodeIndex& index,
                           const TakeElements22& take);
/// The binary elements behind one header.
bool read_plain_records22(Numbers& in, const ElementType& type, std::size_t count, std::size_t tags,
                          const NodeIndex& index, const TakeElements22& take);

}  // namespace tetproof::io
