// SPDX-License-Identifier: GPL-3.0-or-later
// Works out which elements and nodes of a document come back from a file of a format, and in which order.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "io/document.hpp"
#include "io/loss/holds.hpp"

namespace tetproof::io {

class WrittenPart {
 public:
  /// A block whose elements come back: `count` of them, with `nodes_each` nodes each.
  struct Block {
    const ElementBlock* block;
    int nodes_each;
    std::size_t count;
  };

  WrittenPart(const Document& document, const Holds& holds);

  /// An element that comes back as triangles.
  struct Cut {
    const ElementBlock* block;
    std::size_t element;       ///< in the block
    std::size_t first, count;  ///< its triangles in `triangles_`
    bool as_it_was;            ///< it is a triangle, and comes back as that
  };

  const std::vector<Cut>& cut() const { return cut_; }          ///< in the document's order
  const std::vector<Block>& blocks() const { return blocks_; }  ///< in the order in which they come back
  bool comes_back(const Block& block, std::size_t e) const {
    return block.count == block.block->count || !names_unknown(*block.block, e);
  }
  bool names_unknown(const ElementBlock& block, std::size_t e) const;
  const Index* nodes_of(const ElementBlock& block, std::size_t e) const {
    return document_.connectivity.data() + block.nodes + e * static_cast<std::size_t>(block.nodes_each);
  }

  /// The nodes in the order in which they come back.
  std::size_t nodes() const { return all_nodes_ ? document_.points.size() : nodes_.size(); }
  std::size_t node(std::size_t i) const { return all_nodes_ ? i : static_cast<std::size_t>(nodes_[i]); }
  bool all_nodes() const { return all_nodes_; }  ///< all come back, in the document's order

 private:
  void find_cut(const ElementBlock& block, const Holds& holds);
  std::vector<Index> in_order_of_elements() const;

  const Document& document_;
  std::vector<Block> blocks_;
  std::vector<Cut> cut_;
  std::vector<std::array<Index, 3>> triangles_;  // of nodes
  bool all_nodes_ = true;
  std::vector<Index> nodes_;
};

}  // namespace tetproof::io
