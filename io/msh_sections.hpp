// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the .msh reader: each reads one section's content and stops in front of its $End.
#pragma once

#include "io/document.hpp"
#include "io/node_index.hpp"
#include "io/numbers.hpp"
#include "io/tag_sets.hpp"

namespace tetproof::io {

// Version 4.1.
void read_entities41(Numbers& in, Document& document, TagSets& sets);
void read_partitioned_entities41(Numbers& in, Document& document, TagSets& sets);
void read_nodes41(Numbers& in, Document& document);
void read_elements41(Numbers& in, Document& document, NodeIndex& index);

// Versions 2.0 to 2.2, after the line with the number of nodes or elements.
void read_nodes22(Numbers& in, std::int64_t count, bool parametric, Document& document);
/// `partition_counts`: as in 2.2 the third tag counts the partitions that follow; before, it was the
/// partition.
void read_elements22(Numbers& in, std::int64_t count, bool partition_counts, Document& document,
                     NodeIndex& index, TagSets& sets);

/// Makes room for `more` numbers at the end of `numbers` and returns where they start.
template <class T>
std::size_t append(std::vector<T>& numbers, std::size_t more) {
  const std::size_t start = numbers.size();
  if (start + more > numbers.capacity() && start > 0) numbers.reserve(std::max(start + more, 2 * start));
  numbers.resize(start + more);
  return start;
}

/// InputError unless `document` has fewer nodes than an Index can number.
void check_node_count(const Numbers& in, std::size_t nodes);

}  // namespace tetproof::io
