// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel collection with the same result for any number of threads. Internal.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace tetproof::verify {

/// Cuts [0, n) into pieces of fixed size, calls `collect(begin, end, found)` for each, and joins their lists
/// `found` in the order of the pieces.
template <class T, class Collect>
std::vector<T> collect_in_order(std::size_t n, std::size_t piece, const Collect& collect) {
  const std::size_t pieces = (n + piece - 1) / piece;
  std::vector<std::vector<T>> found(pieces);
  tbb::parallel_for(std::size_t{0}, pieces,
                    [&](std::size_t i) { collect(i * piece, std::min(n, (i + 1) * piece), found[i]); });
  std::size_t total = 0;
  for (const auto& part : found) total += part.size();
  std::vector<T> all;
  all.reserve(total);
  for (auto& part : found)
    all.insert(all.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
  return all;
}

}  // namespace tetproof::verify
