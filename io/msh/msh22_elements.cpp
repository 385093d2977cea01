// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/msh/msh22_elements.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/bytes/large_pages.hpp"
#include "io/loss/loss_list.hpp"
#include "io/msh/msh22_limits.hpp"

namespace tetproof::io {

Elements22::Elements22(ElementTags kind, Document& document, TagSets& sets, std::vector<ElementTag>& copies)
    : kind_(kind),
      document_(document),
      sets_(sets),
      element_tags_(document.element_tags, document.first_element),
      copies_(copies) {}

void Elements22::set_tags(std::span<const std::int64_t> tags) {
  if (std::equal(tags.begin(), tags.end(), tags_.begin(), tags_.end())) return;
  tags_.assign(tags.begin(), tags.end());
  const auto count = static_cast<std::int64_t>(tags.size());
  group_ = count > 0 ? tags_[0] : 0;
  entity_ = count > 1 ? tags_[1] : 0;
  partitions_ = 0;
  std::int64_t meant = std::min<std::int64_t>(count, 3);
  if (count > 2 && kind_ != ElementTags::v22) partitions_ = sets_({tags_[2]});
  if (count > 3 && kind_ == ElementTags::v22) {
    const auto named = tags_.begin() + 3;
    const std::int64_t partitions = std::clamp<std::int64_t>(tags_[2], 0, count - 3);
    partitions_ = sets_({named, named + partitions});
    meant += partitions;
  }
  // A third tag announces partitions. Without any behind it, it says nothing that is kept.
  if (count == 3 && kind_ == ElementTags::v22 && tags_[2] != 0) --meant;
  // A last 0 is the writer's, by which an element that looks like a copy of the one before is told apart.
  if (count == meant + 1 && kind_ == ElementTags::v22 && tags_.back() == 0) ++meant;
  spare_each_ = static_cast<std::size_t>(count - meant);
}

void Elements22::count_spare_tags(std::int64_t first, std::size_t elements) {
  if (spare_each_ == 0 || elements == 0) return;
  if (spare_count_ == 0) first_spare_ = first;
  spare_count_ += spare_each_ * elements;
}

void Elements22::list_dropped() {
  add_loss(document_.dropped, "tags of elements without a meaning", spare_count_,
           fmt::format("element {}", first_spare_));
}

void Elements22::set_entity(std::int64_t entity, const std::vector<std::int64_t>& partitions) {
  entity_ = entity;
  partitions_ = sets_(partitions);
}

// The file lists an element in several physical groups once for each of them; these listings differ only in
// the group and the tag. So an element waits until the next one has been read. An element with another number
// of tags is not such a copy: our writer has no other way to tell the two apart.
void Elements22::add(std::int64_t tag, std::span<const Index> nodes) {
  count_spare_tags(tag, 1);
  if (repeats_waiting(nodes)) {
    waiting_.groups.push_back(group_);
    copies_.emplace_back(tag, static_cast<Index>(document_.elements()));  // where its first listing will be
    return;
  }
  finish();
  waiting_.any = true;
  waiting_.tag = tag, waiting_.number = number_, waiting_.tags = tags_.size();
  waiting_.entity = entity_, waiting_.partitions = partitions_;
  waiting_.groups.clear();
  if (group_ != 0) waiting_.groups.push_back(group_);
  waiting_.nodes.assign(nodes.begin(), nodes.end());
}

// Adds all but the first and the last element at once, if none repeats the one before it.
void Elements22::add(const PlainElements22& piece, std::size_t left) {
  const std::size_t count = piece.tags.size();
  std::vector<Index>& all = document_.connectivity;
  if (all.size() + piece.nodes.size() > all.capacity())  // the rest probably has elements of the same size
    reserve_in_large_pages(
        all, all.size() + std::max(piece.nodes.size() / count * left, piece.nodes.size() + all.size() / 4));
  const Index* node = piece.nodes.data();
  const std::int64_t* tags = piece.run_tags.data();
  std::size_t e = 0;
  for (const PlainElements22::Run& run : piece.runs) {
    set_type(run.type->type);
    set_tags({tags, run.tags});
    tags += run.tags;
    const auto each = static_cast<std::size_t>(run.type->nodes);
    for (const std::size_t end = e + run.count; e < end;) {
      if (piece.repeats || e == 0 || e + 1 == count) {
        add(piece.tags[e++], {node, each});
        node += each;
        continue;
      }
      finish();
      const std::size_t here = std::min(end, count - 1) - e;
      count_spare_tags(piece.tags[e], here);
      ElementBlock& block = block_of({.type = run.type->type,
                                      .dim = dimension22(run.type->type),
                                      .entity = entity_,
                                      .groups = group_ != 0 ? sets_({group_}) : sets_({}),
                                      .partitions = partitions_,
                                      .nodes_each = run.type->nodes});
      element_tags_.add(block.first + block.count, std::span(piece.tags).subspan(e, here));
      all.insert(all.end(), node, node + here * each);
      block.count += here, e += here, node += here * each;
    }
  }
}

void Elements22::finish() {
  if (!waiting_.any) return;
  waiting_.any = false;
  ElementBlock& block = block_of({.type = static_cast<int>(waiting_.number),
                                  .dim = dimension22(static_cast<int>(waiting_.number)),
                                  .entity = waiting_.entity,
                                  .groups = sets_(waiting_.groups),
                                  .partitions = waiting_.partitions,
                                  .nodes_each = static_cast<std::int32_t>(waiting_.nodes.size())});
  element_tags_.add(block.first + block.count++, waiting_.tag);
  document_.connectivity.insert(document_.connectivity.end(), waiting_.nodes.begin(), waiting_.nodes.end());
}

Elements22::Mark Elements22::mark() const {
  return {document_.blocks, document_.elements(), document_.connectivity.size(), copies_.size(),
          waiting_,         spare_count_};
}

void Elements22::back_to(const Mark& mark) {
  document_.blocks = mark.blocks;
  document_.connectivity.resize(mark.nodes);
  element_tags_.cut(mark.elements);
  copies_.resize(mark.copies);
  waiting_ = mark.waiting;
  spare_count_ = mark.spare_count;
}

bool Elements22::repeats_waiting(std::span<const Index> nodes) const {
  return waiting_.any && waiting_.number == number_ && waiting_.entity == entity_ &&
         waiting_.tags == tags_.size() && waiting_.partitions == partitions_ &&
         std::equal(nodes.begin(), nodes.end(), waiting_.nodes.begin(), waiting_.nodes.end()) &&
         group_ != 0 && !waiting_.groups.empty() && waiting_.groups.size() < most_groups22 &&
         std::find(waiting_.groups.begin(), waiting_.groups.end(), group_) == waiting_.groups.end();
}

// Returns the last block if it is like this one, else a new block.
ElementBlock& Elements22::block_of(ElementBlock like) {
  std::vector<ElementBlock>& blocks = document_.blocks;
  if (blocks.empty() || blocks.back().type != like.type || blocks.back().nodes_each != like.nodes_each ||
      blocks.back().entity != like.entity || blocks.back().partitions != like.partitions ||
      blocks.back().groups != like.groups) {
    like.first = document_.elements();
    like.nodes = document_.connectivity.size();
    blocks.push_back(like);
  }
  return blocks.back();
}

}  // namespace tetproof::io
