// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of .msh 2.0 to 2.2.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/element_types.hpp"
#include "io/msh_sections.hpp"

namespace tetproof::io {
namespace {

class ElementReader {
 public:
  ElementReader(Numbers& in, bool partition_counts, Document& document, NodeIndex& index, TagSets& sets)
      : in_(in),
        partition_counts_(partition_counts),
        document_(document),
        index_(index),
        sets_(sets),
        tags_(document.element_tags, document.first_element) {}

  // A line: tag, type, number of tags, tags, nodes.
  void read_text(std::int64_t count) {
    document_.connectivity.reserve(document_.connectivity.size() + 2 * count);
    for (std::int64_t e = 0; e < count; ++e) {
      const std::int64_t tag = in_.integer("the tag of an element");
      set_type(in_.integer("an element type"));
      const std::int64_t tags = in_.integer("the number of tags");
      in_.check_count(tags, "the number of tags", 2);
      read_element_tags(tags);
      const int each = type_ ? type_->nodes : in_.words_in_line();
      if (each == 0) in_.fail(fmt::format("expected the nodes of an element of type {}", number_));
      add(tag, each);
    }
  }

  // Headers (type, number of elements, number of tags), each with its elements (tag, tags, nodes).
  void read_binary(std::int64_t count) {
    for (std::int64_t left = count; left > 0;) {
      set_type(in_.integer("an element type"));
      if (!type_) in_.fail(fmt::format("unknown element type {}", number_));
      const std::int64_t here = in_.integer("the number of elements that follow");
      if (here < 1 || here > left)
        in_.fail(fmt::format("expected the number of elements that follow, 1 to {}, found {}", left, here));
      const std::int64_t tags = in_.integer("the number of tags");
      in_.check_count(tags, "the number of tags", 4);
      in_.check_count(here, "the number of elements that follow", 4 * (1 + tags + type_->nodes));
      for (std::int64_t e = 0; e < here; ++e) {
        const std::int64_t tag = in_.integer("the tag of an element");
        read_element_tags(tags);
        add(tag, type_->nodes);
      }
      left -= here;
    }
  }

 private:
  void set_type(std::int64_t number) {
    if (number == number_) return;
    number_ = number;
    type_ = number < 0 || number > std::numeric_limits<int>::max() ? nullptr
                                                                   : element_type(static_cast<int>(number));
    if (number < 0 || number > std::numeric_limits<int>::max())
      in_.fail(fmt::format("expected an element type, found {}", number));
  }

  // Physical, elementary, partitions: what the element belongs to.
  void read_element_tags(std::int64_t count) {
    tags_read_.resize(count);
    for (std::int64_t& tag : tags_read_)
      tag = in_.integer("an element's physical, elementary or partition tag");
    if (tags_read_ == last_tags_) return;
    last_tags_ = tags_read_;
    group_ = count > 0 ? tags_read_[0] : 0;
    entity_ = count > 1 ? tags_read_[1] : 0;
    groups_ = group_ != 0 ? sets_({group_}) : 0;
    partitions_ = 0;
    if (count > 2 && !partition_counts_) partitions_ = sets_({tags_read_[2]});
    if (count > 3 && partition_counts_) {
      const auto named = tags_read_.begin() + 3;
      partitions_ = sets_({named, named + std::clamp<std::int64_t>(tags_read_[2], 0, count - 3)});
    }
  }

  void add(std::int64_t tag, int each) {
    nodes_.resize(each);
    for (Index& node : nodes_) node = index_(in_.integer("the tag of a node"));
    if (repeats_last()) {
      const ElementBlock last = document_.blocks.back();
      std::vector<std::int64_t> groups = document_.tag_sets[last.groups];
      groups.push_back(group_);
      if (--document_.blocks.back().count == 0) document_.blocks.pop_back();
      ++block_for(each, sets_(groups)).count;
      return;
    }
    ElementBlock& block = block_for(each, groups_);
    tags_.add(block.first + block.count++, tag);
    document_.connectivity.insert(document_.connectivity.end(), nodes_.begin(), nodes_.end());
  }

  // An element in several physical groups stands once for each of them: the last one again, but for its group
  // and its tag.
  bool repeats_last() const {
    if (document_.blocks.empty() || group_ == 0) return false;
    const ElementBlock& last = document_.blocks.back();
    if (!same_but_groups(last, static_cast<int>(nodes_.size())) ||
        !std::equal(nodes_.begin(), nodes_.end(), document_.connectivity.end() - last.nodes_each))
      return false;
    const auto& groups = document_.tag_sets[last.groups];
    return !groups.empty() && std::find(groups.begin(), groups.end(), group_) == groups.end();
  }

  bool same_but_groups(const ElementBlock& block, int each) const {
    return block.type == number_ && block.nodes_each == each && block.entity == entity_ &&
           block.partitions == partitions_;
  }

  // The last block if the next element belongs to it, or a new one.
  ElementBlock& block_for(int each, std::int32_t groups) {
    if (document_.blocks.empty() || !same_but_groups(document_.blocks.back(), each) ||
        document_.blocks.back().groups != groups) {
      ElementBlock block{.type = static_cast<int>(number_),
                         .dim = type_ ? type_->dim : 3,
                         .entity = entity_,
                         .groups = groups,
                         .partitions = partitions_,
                         .nodes_each = each};
      block.first = document_.elements();
      block.nodes = document_.blocks.empty()
                        ? 0
                        : document_.blocks.back().nodes +
                              document_.blocks.back().count * document_.blocks.back().nodes_each;
      document_.blocks.push_back(block);
    }
    return document_.blocks.back();
  }

  Numbers& in_;
  const bool partition_counts_;
  Document& document_;
  NodeIndex& index_;
  TagSets& sets_;
  Tags tags_;
  std::int64_t number_ = -1;
  const ElementType* type_ = nullptr;
  std::vector<std::int64_t> tags_read_, last_tags_;
  std::vector<Index> nodes_;
  std::int64_t group_ = 0, entity_ = 0;
  std::int32_t groups_ = 0, partitions_ = 0;
};

}  // namespace

void read_nodes22(Numbers& in, std::int64_t count, bool parametric, Document& document) {
  Tags tags(document.node_tags, document.first_node);
  check_node_count(in, document.points.size() + count);
  document.points.reserve(document.points.size() + count);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::size_t position = document.points.size();
    tags.add(position, in.integer("the tag of a node"));
    const double x = in.real("a coordinate"), y = in.real("a coordinate"), z = in.real("a coordinate");
    document.points.emplace_back(x, y, z);
    if (!parametric) continue;
    const std::int64_t dim = in.integer("the dimension of a node's entity");
    if (dim < 0 || dim > 3)
      in.fail(fmt::format("expected the dimension of a node's entity, 0 to 3, found {}", dim));
    const std::int64_t entity = in.integer("the tag of a node's entity");
    const int each = dim == 1 || dim == 2 ? static_cast<int>(dim) : 0;
    if (document.node_blocks.empty() || document.node_blocks.back().dim != dim ||
        document.node_blocks.back().entity != entity)
      document.node_blocks.push_back({.dim = static_cast<int>(dim),
                                      .entity = entity,
                                      .first = position,
                                      .parameters_each = each,
                                      .parameters = document.parameters.size()});
    ++document.node_blocks.back().count;
    for (int k = 0; k < each; ++k) document.parameters.push_back(in.real("a parametric coordinate"));
  }
}

void read_elements22(Numbers& in, std::int64_t count, bool partition_counts, Document& document,
                     NodeIndex& index, TagSets& sets) {
  ElementReader reader(in, partition_counts, document, index, sets);
  in.binary() ? reader.read_binary(count) : reader.read_text(count);
}

}  // namespace tetproof::io
