// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/supplement/supplement_blocks.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "io/bytes/large_pages.hpp"

namespace tetproof::io {
namespace {

class BlockJoiner {
 public:
  BlockJoiner(Document& native, const Decoder& in) : in_(in), native_(native) {}

  void join(const std::vector<SupplementBlock>& all) {
    find_native(all);
    put_together(all);
  }

 private:
  // The native part has its elements sorted by kind. Finds where the connectivity of each block starts there.
  void find_native(const std::vector<SupplementBlock>& all) {
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return all[a].kind < all[b].kind; });
    source_.assign(all.size(), 0);
    std::size_t from = 0;  // the current native block
    std::size_t at = 0;    // how many of its elements are used up
    const auto& blocks = native_.blocks;
    for (const std::size_t b : order) {
      if (!all[b].written) continue;
      std::size_t left = all[b].block.count;
      bool first = true;
      while (left > 0) {
        if (from == blocks.size()) in_.fail("the file has fewer elements than its supplement speaks of");
        const ElementBlock& native = blocks[from];
        if (all[b].native && native.nodes_each != all[b].block.nodes_each)
          in_.fail("the file has other elements than its supplement speaks of");
        if (first) source_[b] = native.nodes + at * static_cast<std::size_t>(native.nodes_each);
        first = false;
        const std::size_t used = std::min(left, native.count - at);
        left -= used, at += used;
        if (at == native.count) ++from, at = 0;
      }
    }
    if (from != blocks.size()) in_.fail("the file has more elements than its supplement speaks of");
  }

  void put_together(const std::vector<SupplementBlock>& all) {
    std::vector<ElementBlock> blocks;
    std::size_t elements = 0, nodes = 0;
    bool as_it_is = true;
    for (std::size_t b = 0; b < all.size(); ++b) {
      ElementBlock block = all[b].block;
      block.first = elements, block.nodes = nodes;
      as_it_is = as_it_is && all[b].native && source_[b] == nodes;
      elements += block.count, nodes += block.count * static_cast<std::size_t>(block.nodes_each);
      blocks.push_back(block);
    }
    if (!as_it_is && !reorder(all)) {
      std::vector<Index> connectivity;
      reserve_in_large_pages(connectivity, nodes);
      for (std::size_t b = 0; b < all.size(); ++b) {
        const std::size_t size = blocks[b].count * static_cast<std::size_t>(blocks[b].nodes_each);
        const Index* from = all[b].native ? native_.connectivity.data() + source_[b] : all[b].listed.data();
        connectivity.insert(connectivity.end(), from, from + size);
      }
      native_.connectivity = std::move(connectivity);
    }
    native_.blocks = std::move(blocks);
  }

  // Brings the native connectivity into the order of the blocks, in place: a second copy would be most of the
  // memory that a large file needs. Returns false, and does nothing, if the native part does not have
  // exactly the connectivity of these blocks, or has it in too many pieces.
  bool reorder(const std::vector<SupplementBlock>& all) {
    constexpr std::size_t most_runs = 16;
    struct Run {
      std::size_t from, size;
    };
    std::vector<Run> runs;
    std::size_t total = 0;
    for (std::size_t b = 0; b < all.size(); ++b) {
      const std::size_t size = all[b].block.count * static_cast<std::size_t>(all[b].block.nodes_each);
      if (!all[b].native) return false;
      if (size == 0) continue;
      if (!runs.empty() && runs.back().from + runs.back().size == source_[b])
        runs.back().size += size;
      else
        runs.push_back({source_[b], size});
      total += size;
    }
    if (total != native_.connectivity.size() || runs.size() > most_runs) return false;
    const auto begin = native_.connectivity.begin();
    const auto place = [&](std::size_t i) { return begin + static_cast<std::ptrdiff_t>(i); };
    for (std::size_t r = 0, at = 0; r < runs.size(); at += runs[r++].size) {
      std::rotate(place(at), place(runs[r].from), place(runs[r].from + runs[r].size));
      for (std::size_t later = r + 1; later < runs.size(); ++later)
        if (runs[later].from < runs[r].from) runs[later].from += runs[r].size;
    }
    return true;
  }

  const Decoder& in_;
  Document& native_;
  std::vector<std::size_t> source_;  // where each block starts in the native connectivity
};

}  // namespace

void join_blocks(const std::vector<SupplementBlock>& all, Document& native, const Decoder& in) {
  BlockJoiner(native, in).join(all);
}

}  // namespace tetproof::io
