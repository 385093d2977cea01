// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/edit/new_nodes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "io/edit/moved_values.hpp"
#include "io/edit/new_elements.hpp"
#include "io/edit/origin.hpp"
#include "io/loss/loss_list.hpp"

namespace tetproof::io {
namespace {

class Mover {
 public:
  Mover(Document& document, const std::vector<Index>& target) : document_(document), target_(target) {
    Index next = 0;
    is_first_.resize(target.size());
    for (std::size_t i = 0; i < target.size(); ++i) {
      is_first_[i] = target[i] == next;
      next += is_first_[i] ? 1 : 0;
    }
    count_ = static_cast<std::size_t>(next);
  }

  MovedNodes move() {
    if (count_ == target_.size()) return {};
    list_merged();
    move_numbers();
    move_blocks();
    for (Values& values : document_.node_values) move_values(values);
    std::erase_if(document_.node_values, [](const Values& values) { return values.items() == 0; });
    move_pairs();
    std::vector<Eigen::Vector3d>& points = document_.points;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (is_first_[i]) points[static_cast<std::size_t>(target_[i])] = points[i];
    points.resize(count_);
    points.shrink_to_fit();
    for (Index& node : document_.connectivity)
      if (node >= 0) node = target_[static_cast<std::size_t>(node)];
    return std::move(moved_);
  }

 private:
  void move_numbers() {
    if (!has_node_numbers(document_)) return leave_out_sections(document_, moved_.lost);
    std::vector<std::int64_t> numbers;
    for (std::size_t i = 0; i < target_.size(); ++i)
      if (is_first_[i]) numbers.push_back(document_.node_tag(i));
    set_numbers(std::move(numbers), document_.node_tags, document_.first_node);
  }

  void move_blocks() {
    std::vector<double> parameters;
    std::vector<NodeBlock> blocks;
    for (NodeBlock block : document_.node_blocks) {
      const std::size_t begin = block.first, end = block.first + block.count, from = block.parameters;
      const auto each = static_cast<std::size_t>(block.parameters_each);
      block.count = 0;
      block.parameters = parameters.size();
      for (std::size_t i = begin; i < end; ++i) {
        if (!is_first_[i]) continue;
        if (block.count++ == 0) block.first = static_cast<std::size_t>(target_[i]);
        const auto at = document_.parameters.begin() + static_cast<std::ptrdiff_t>(from + (i - begin) * each);
        parameters.insert(parameters.end(), at, at + static_cast<std::ptrdiff_t>(each));
      }
      if (block.count > 0) blocks.push_back(block);
    }
    document_.node_blocks = std::move(blocks);
    document_.parameters = std::move(parameters);
  }

  // Lists the nodes that go to another one without being of its entity, or with other parameters.
  void list_merged() {
    struct Place {
      const NodeBlock* block = nullptr;
      const double* parameters = nullptr;
    };
    const auto each_node = [&](bool first, const auto& see) {
      for (const NodeBlock& block : document_.node_blocks)
        for (std::size_t k = 0; k < block.count; ++k)
          if (const Index to = target_[block.first + k]; to >= 0 && is_first_[block.first + k] == first)
            see(static_cast<std::size_t>(to), block.first + k,
                Place{&block, document_.parameters.data() + block.parameters +
                                  k * static_cast<std::size_t>(block.parameters_each)});
    };
    std::vector<Place> places(document_.node_blocks.empty() ? 0 : count_);
    each_node(true, [&](std::size_t to, std::size_t, const Place& place) { places[to] = place; });
    each_node(false, [&](std::size_t to, std::size_t node, const Place& one) {
      const Place& stays = places[to];
      if (stays.block && stays.block->dim == one.block->dim && stays.block->entity == one.block->entity &&
          stays.block->parameters_each == one.block->parameters_each &&
          std::equal(one.parameters, one.parameters + one.block->parameters_each, stays.parameters))
        return;
      add_loss(moved_.lost, "entities and parameters of merged points", 1,
               fmt::format("node {}, of entity {} of dimension {}", document_.named(static_cast<Index>(node)),
                           one.block->entity, one.block->dim));
    });
  }

  // The first row of each new node is taken; others are compared with it.
  void move_values(Values& values) {
    constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> row_of(count_, none);
    std::vector<MovedRow> rows;
    const std::size_t items = values.items(), each = static_cast<std::size_t>(std::max(values.components, 0));
    const auto differ = [&](std::size_t a, std::size_t b) {
      for (std::size_t k = 0; k < each; ++k)
        if (values.reals.empty() ? values.integers[a * each + k] != values.integers[b * each + k]
                                 : values.reals[a * each + k] != values.reals[b * each + k])
          return true;
      return false;
    };
    for (std::size_t row = 0; row < items; ++row) {
      const Index item = item_of(values, row);
      const Index to = item < 0 ? item : target_[static_cast<std::size_t>(item)];
      if (item >= 0 && to < 0) continue;
      if (item >= 0) {
        std::size_t& first = row_of[static_cast<std::size_t>(to)];
        if (first != none) {
          moved_.differing += differ(first, row);
          continue;
        }
        first = row;
      }
      rows.push_back({to, row});
    }
    move_rows(values, rows);
  }

  // Periodic links, bounds of lengths and the Voronoi diagram name nodes.
  void move_pairs() {
    const auto moved = [&](std::array<Index, 2>& pair) {
      for (Index& node : pair) {
        if (node < 0) continue;
        node = target_[static_cast<std::size_t>(node)];
        if (node < 0) return false;
      }
      return true;
    };
    std::size_t lost = 0;
    for (PeriodicLink& link : document_.periodic)
      lost += std::erase_if(link.nodes, [&](std::array<Index, 2>& pair) { return !moved(pair); });
    add_loss(moved_.lost, "pairs of periodic nodes", lost, "a node of the first is left out");
    lost = std::erase_if(document_.length_bounds, [&](LengthBound& bound) { return !moved(bound.nodes); });
    add_loss(moved_.lost, "bounds of lengths", lost, "a node of the first is left out");
    Voronoi& voronoi = document_.voronoi;
    add_loss(moved_.lost, "cells of a Voronoi diagram",
             voronoi.cells.size() + (voronoi.cells.empty() ? voronoi.points.size() : 0),
             "they belong to nodes that are no longer the same");
    voronoi = {};
  }

  Document& document_;
  const std::vector<Index>& target_;
  std::vector<bool> is_first_;  // of each node: its new position has not been taken by one before it
  std::size_t count_ = 0;
  MovedNodes moved_;
};

}  // namespace

MovedNodes move_nodes(Document& document, const std::vector<Index>& target) {
  return Mover(document, target).move();
}

}  // namespace tetproof::io
