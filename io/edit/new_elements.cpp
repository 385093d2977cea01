// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/edit/new_elements.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "io/edit/free_numbers.hpp"
#include "io/edit/moved_values.hpp"
#include "io/edit/origin.hpp"
#include "io/edit/unknown_numbers.hpp"
#include "io/loss/loss_list.hpp"
#include "io/model/block_of.hpp"

namespace tetproof::io {
namespace {

bool same_kind(const ElementBlock& a, const ElementBlock& b) {
  return a.type == b.type && a.dim == b.dim && a.entity == b.entity && a.groups == b.groups &&
         a.partitions == b.partitions && a.of_boundary == b.of_boundary && a.faces == b.faces;
}

// Rows that ascended ascend again.
void sort_like(const Values& values, std::vector<MovedRow>& rows) {
  const bool ascending =
      std::adjacent_find(values.at.begin(), values.at.end(), std::greater_equal<>()) == values.at.end();
  if (ascending && (values.at.empty() || values.at.front() >= 0))
    std::stable_sort(rows.begin(), rows.end(),
                     [](const MovedRow& one, const MovedRow& other) { return one.to < other.to; });
}

}  // namespace

NewElements::NewElements(const Document& document) : wants_local_(!document.element_node_values.empty()) {}

void NewElements::add_place(const ElementBlock& like, std::size_t from, std::size_t nodes) {
  const auto each = static_cast<std::int32_t>(nodes);
  if (blocks_.empty() || blocks_.back().nodes_each != each || !same_kind(blocks_.back(), like)) {
    ElementBlock& block = blocks_.emplace_back(like);
    block.nodes_each = each;
    block.count = 0;
    block.first = from_.size();
    block.nodes = connectivity_.size();
  }
  ++blocks_.back().count;
  from_.push_back(static_cast<Index>(from));
}

void NewElements::add(const ElementBlock& like, std::size_t from, const Index* nodes,
                      std::span<const std::int32_t> local) {
  add_place(like, from, local.size());
  for (const std::int32_t k : local) connectivity_.push_back(nodes[k]);
  if (wants_local_) local_.insert(local_.end(), local.begin(), local.end());
}

void NewElements::add_free(const ElementBlock& like, std::size_t from, std::span<const Index> nodes) {
  add_place(like, from, nodes.size());
  connectivity_.insert(connectivity_.end(), nodes.begin(), nodes.end());
  if (wants_local_) local_.insert(local_.end(), nodes.size(), -1);
}

std::vector<Loss> NewElements::replace(Document& document, Numbers numbers) && {
  starts_.assign(document.elements() + 1, 0);
  for (const Index from : from_) ++starts_[static_cast<std::size_t>(from) + 1];
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  made_.resize(from_.size());
  std::vector<std::size_t> next = starts_;
  for (std::size_t i = 0; i < from_.size(); ++i)
    made_[next[static_cast<std::size_t>(from_[i])]++] = static_cast<Index>(i);

  std::vector<Loss> lost = without_element_numbers(document);
  bool others = from_.size() != document.elements();
  for (std::size_t i = 0; i < from_.size() && !others; ++i) others = from_[i] != static_cast<Index>(i);
  if (others && (numbers == Numbers::anew || !has_element_numbers(document)))
    leave_out_sections(document, lost);
  if (numbers == Numbers::kept) {
    number(document);
  } else {
    document.element_tags.clear();
    document.first_element = 1;
  }
  move_values(document);
  move_positions(document);
  document.blocks = std::move(blocks_);
  document.connectivity = std::move(connectivity_);
  free_unknown_numbers(document);
  return lost;
}

void NewElements::number(Document& document) const {
  if (!has_element_numbers(document)) return;
  std::optional<FreeNumbers> free;
  const auto free_number = [&] {
    if (!free) {
      std::vector<std::int64_t> taken(document.elements());
      for (std::size_t i = 0; i < taken.size(); ++i) taken[i] = document.element_tag(i);
      free.emplace(std::move(taken));
    }
    return free->next();
  };
  std::vector<std::int64_t> numbers(from_.size());
  for (std::size_t i = 0; i < from_.size(); ++i) {
    const auto from = static_cast<std::size_t>(from_[i]);
    const bool is_first = made_[starts_[from]] == static_cast<Index>(i);
    numbers[i] = is_first ? document.element_tag(from) : free_number();
  }
  set_numbers(std::move(numbers), document.element_tags, document.first_element);
}

void NewElements::move_values(Document& document) const {
  const auto each_target = [&](const Values& values, const auto& give) {
    const std::size_t items = values.items();
    for (std::size_t row = 0; row < items; ++row) {
      const Index item = item_of(values, row);
      if (item < 0) {
        give(item, row);
        continue;
      }
      const auto from = static_cast<std::size_t>(item);
      for (std::size_t k = starts_[from]; k < starts_[from + 1]; ++k) give(made_[k], row);
    }
  };
  std::vector<MovedRow> rows;
  for (Values& values : document.element_values) {
    rows.clear();
    each_target(values, [&](Index to, std::size_t row) { rows.push_back({to, row}); });
    sort_like(values, rows);
    move_rows(values, rows);
  }
  for (Values& values : document.element_node_values) {
    rows.clear();
    each_target(values, [&](Index to, std::size_t row) {
      if (to < 0) return rows.push_back({to, row});
      const ElementBlock& block = block_of(blocks_, static_cast<std::size_t>(to));
      const auto each = static_cast<std::size_t>(block.nodes_each);
      std::span<const std::int32_t> local(
          local_.data() + block.nodes + (static_cast<std::size_t>(to) - block.first) * each, each);
      // Values may be those of corners alone.
      while (!local.empty() && local.back() >= values.nodes[row]) local = local.first(local.size() - 1);
      if (!local.empty() && std::all_of(local.begin(), local.end(),
                                        [&](std::int32_t k) { return k >= 0 && k < values.nodes[row]; }))
        rows.push_back({to, row, local});
    });
    sort_like(values, rows);
    move_rows(values, rows);
  }
  const auto is_empty = [](const Values& values) { return values.items() == 0; };
  std::erase_if(document.element_values, is_empty);
  std::erase_if(document.element_node_values, is_empty);
}

void NewElements::move_positions(Document& document) const {
  std::vector<GhostElement> ghosts;
  for (const GhostElement& ghost : document.ghost_elements) {
    if (ghost.element < 0) {
      ghosts.push_back(ghost);
      continue;
    }
    const auto from = static_cast<std::size_t>(ghost.element);
    for (std::size_t k = starts_[from]; k < starts_[from + 1]; ++k) {
      ghosts.push_back(ghost);
      ghosts.back().element = made_[k];
    }
  }
  document.ghost_elements = std::move(ghosts);
  // A facet goes on with its polygons that stayed as they are, one for one.
  std::vector<Facet> facets;
  for (Facet& facet : document.facets) {
    const std::size_t begin = starts_[facet.first], end = starts_[facet.first + facet.polygons];
    if (begin == end || (end - begin == 1 && facet.holes.empty())) continue;
    facet.first = static_cast<std::size_t>(made_[begin]);
    facet.polygons = end - begin;
    facets.push_back(std::move(facet));
  }
  document.facets = std::move(facets);
}

std::vector<Loss> without_element_numbers(Document& document) {
  std::vector<Loss> lost;
  if (document.format != "tetgen") return lost;
  std::erase_if(document.element_values, [&](const Values& values) {
    if (values.name != "neighbours" && values.name != "faces" && values.name != "edges") return false;
    add_loss(lost, "TetGen's numbers of " + values.name, values.items(),
             "they count elements that are numbered anew");
    return true;
  });
  return lost;
}

void leave_out_sections(Document& document, std::vector<Loss>& lost) {
  for (const Section& section : document.sections)
    add_loss(lost, "sections", 1, "$" + section.name + " may name numbers that are no longer the same");
  document.sections.clear();
}

}  // namespace tetproof::io
