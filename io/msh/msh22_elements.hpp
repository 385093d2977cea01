// SPDX-License-Identifier: GPL-3.0-or-later
// Adds the elements of .msh 1 to 3 to a document. Consecutive elements of one kind become a block. An element
// in several physical groups, which the file lists once for each of them, becomes one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/msh/msh22_plain.hpp"
#include "io/msh/msh_sections.hpp"

namespace tetproof::io {

class Elements22 {
 public:
  /// `copies` receives the tags of an element's further listings.
  Elements22(ElementTags kind, Document& document, TagSets& sets, std::vector<ElementTag>& copies);

  // Sets what the next elements are, until it is set anew.
  void set_type(std::int64_t number) { number_ = number; }
  /// Physical, elementary, partitions.
  void set_tags(std::span<const std::int64_t> tags);
  /// The same in version 3, which has these instead of the tags.
  void set_entity(std::int64_t entity, const std::vector<std::int64_t>& partitions);

  void add(std::int64_t tag, std::span<const Index> nodes);
  /// `left`: how many elements are left in the file, these included.
  void add(const PlainElements22& elements, std::size_t left);
  /// To be called after the last element.
  void finish();
  /// Lists the tags that have no meaning, behind those that have one.
  void list_dropped();

 private:
  struct Waiting {
    bool any = false;
    std::int64_t tag = 0, number = 0;
    std::size_t tags = 0;
    std::int64_t entity = 0;
    std::int32_t partitions = 0;
    std::vector<std::int64_t> groups{};
    std::vector<Index> nodes{};
  };

 public:
  /// A state to which `back_to` can return.
  struct Mark {
    std::vector<ElementBlock> blocks;
    std::size_t elements, nodes, copies;
    Waiting waiting;
    std::size_t spare_count;
  };
  Mark mark() const;
  void back_to(const Mark& mark);

 private:
  void count_spare_tags(std::int64_t first, std::size_t elements);
  bool repeats_waiting(std::span<const Index> nodes) const;
  ElementBlock& block_of(ElementBlock like);

  const ElementTags kind_;
  Document& document_;
  TagSets& sets_;
  Tags element_tags_;
  std::vector<ElementTag>& copies_;

  std::int64_t number_ = -1, group_ = 0, entity_ = 0;
  std::int32_t partitions_ = 0;
  std::vector<std::int64_t> tags_;  // those last set
  std::size_t spare_each_ = 0;      // of them without a meaning
  std::size_t spare_count_ = 0;     // of all elements
  std::int64_t first_spare_ = 0;    // the tag of the first element that has any
  Waiting waiting_;
};

}  // namespace tetproof::io
