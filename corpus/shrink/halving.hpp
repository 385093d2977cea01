// SPDX-License-Identifier: GPL-3.0-or-later
// Delta debugging: many changes are tried at once, then half of them, and so on. Internal.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "corpus/shrink/certified_test.hpp"

namespace tetproof::corpus {

/// Tries n changes in runs: all at once, then each half of those that are left, each quarter, ..., each run
/// of `smallest`. `make` makes the candidate of a run of changes, on top of those accepted so far; `accept`
/// is told each run that is accepted, with its candidate. `most`: the triangles that a candidate may have.
/// Returns the number of changes in accepted runs. A. Zeller and R. Hildebrandt, "Simplifying and Isolating
/// Failure-Inducing Input", 2002.
inline std::size_t try_by_halves(
    CertifiedTest& test, std::size_t n, std::size_t smallest, const std::function<std::size_t()>& most,
    const std::function<std::optional<TriangleSurface>(std::span<const std::size_t>)>& make,
    const std::function<void(std::span<const std::size_t>, TriangleSurface)>& accept) {
  std::vector<std::size_t> left(n);
  std::iota(left.begin(), left.end(), 0);
  std::size_t accepted = 0;
  for (std::size_t size = n; size >= smallest && size > 0 && !left.empty(); size /= 2) {
    std::vector<std::size_t> kept;
    std::size_t at = 0;  // where the next run begins
    const auto run = [&](std::size_t i) {
      const std::size_t begin = at + i * size;
      return std::span(left).subspan(begin, std::min(size, left.size() - begin));
    };
    while (at < left.size()) {
      const std::size_t runs = (left.size() - at + size - 1) / size;
      auto success = test.first(runs, most(), [&](std::size_t i) { return make(run(i)); });
      const std::size_t before = success ? success->index * size : left.size() - at;
      kept.insert(kept.end(), left.begin() + at, left.begin() + at + before);
      if (!success) break;
      const auto changes = run(success->index);
      accepted += changes.size();
      at += before + changes.size();
      accept(changes, std::move(success->surface));
    }
    left = std::move(kept);
  }
  return accepted;
}

}  // namespace tetproof::corpus
