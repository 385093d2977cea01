// SPDX-License-Identifier: GPL-3.0-or-later
// Reads ordinary nodes and elements of .msh 2.2, lines of text or binary records, with several threads. The
// functions return false where there are few of them or anything is unusual: an unknown type, a node that
// does not exist, more than a few tags, bytes in the other order. Then nothing was read.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "io/model/element_types.hpp"
#include "io/model/node_index.hpp"
#include "io/msh/numbers.hpp"

namespace tetproof::io {

/// Consecutive elements of a file.
struct PlainElements22 {
  /// Consecutive elements with the same type and tags.
  struct Run {
    const ElementType* type = nullptr;
    std::size_t tags = 0;  ///< how many of `run_tags` are its tags
    std::size_t count = 0;
  };
  std::vector<Run> runs{};
  std::vector<std::int64_t> run_tags{};  ///< of all runs, one after the other
  std::vector<std::int64_t> tags{};      ///< of the elements
  std::vector<Index> nodes{};
  /// An element may have the nodes of the one before it: such elements may be in several groups.
  bool repeats = false;

  void clear() { runs.clear(), run_tags.clear(), tags.clear(), nodes.clear(), repeats = false; }
};
using TakeElements22 = std::function<void(const PlainElements22&)>;

bool read_plain_nodes22(Numbers& in, std::size_t count, Document& document, Tags& tags);

/// Passes all elements to `take`, in order, and stops behind them. After false, the caller must undo what it
/// took.
bool read_plain_elements22(Numbers& in, std::size_t count, const NodeIndex& index,
                           const TakeElements22& take);
/// Does the same with the binary elements behind one header.
bool read_plain_records22(Numbers& in, const ElementType& type, std::size_t count, std::size_t tags,
                          const NodeIndex& index, const TakeElements22& take);

}  // namespace tetproof::io
