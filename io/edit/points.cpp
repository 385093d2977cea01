// SPDX-License-Identifier: GPL-3.0-or-later
// Merges points, leaves out unused ones, and numbers nodes and elements anew.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "io/bytes/words.hpp"
#include "io/edit/edits.hpp"
#include "io/edit/new_elements.hpp"
#include "io/edit/new_nodes.hpp"
#include "io/edit/unknown_numbers.hpp"
#include "io/error.hpp"
#include "io/loss/loss_list.hpp"
#include "io/model/weld.hpp"

namespace tetproof::io {
namespace {

// Finds the points that stayed by the cells of a lattice. A cell is twice as wide as the tolerance, so that
// points within it are in neighbouring cells, however their quotients are rounded; and as points that stayed
// are wider apart than the tolerance, a cell has few of them. Where the quotient is beyond all numbers, only
// equal coordinates are within the tolerance: each is a cell.
class NearPoints {
 public:
  NearPoints(const std::vector<Eigen::Vector3d>& points, double tolerance)
      : points_(points), tolerance_(tolerance) {}

  /// The first point that stayed within the tolerance; -1: none.
  Index find(const Eigen::Vector3d& point) const {
    Index found = -1;
    const Eigen::Array3d cell = cell_of(point);
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {
          const auto here = cells_.find(key(cell + Eigen::Array3d(x, y, z)));
          if (here == cells_.end()) continue;
          for (const Index i : here->second)
            if ((found < 0 || i < found) &&
                (points_[static_cast<std::size_t>(i)] - point).stableNorm() <= tolerance_)
              found = i;
        }
    return found;
  }
  void add(Index i) { cells_[key(cell_of(points_[static_cast<std::size_t>(i)]))].push_back(i); }

 private:
  Eigen::Array3d cell_of(const Eigen::Vector3d& point) const {
    const Eigen::Array3d cell = (point.array() / tolerance_ / 2).floor();
    return cell.isFinite().select(cell, point.array()) + 0.0;
  }
  static std::uint64_t key(const Eigen::Array3d& cell) {  // cells of one key are told apart by the distance
    std::uint64_t key = 0;
    for (const double x : cell) key = (key ^ std::hash<double>()(x)) * 0x9e3779b97f4a7c15u;
    return key ^ (key >> 29);
  }

  const std::vector<Eigen::Vector3d>& points_;
  double tolerance_;
  std::unordered_map<std::uint64_t, std::vector<Index>> cells_;
};

// The first point to which each point goes.
std::vector<Index> near_points(const std::vector<Eigen::Vector3d>& points, double tolerance) {
  NearPoints stayed(points, tolerance);
  std::vector<Index> target(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    target[i] = static_cast<Index>(i);
    if (!points[i].allFinite()) continue;
    if (const Index first = stayed.find(points[i]); first >= 0)
      target[i] = first;
    else
      stayed.add(target[i]);
  }
  Index next = 0;  // positions become those without the points that go
  for (std::size_t i = 0; i < target.size(); ++i)
    target[i] = target[i] == static_cast<Index>(i) ? next++ : target[static_cast<std::size_t>(target[i])];
  return target;
}

// The number of elements that have a node twice.
std::size_t collapsed(const Document& document) {
  std::size_t count = 0;
  std::vector<Index> nodes;
  for (const ElementBlock& block : document.blocks) {
    const auto each = static_cast<std::size_t>(block.nodes_each);
    for (std::size_t e = 0; e < block.count; ++e) {
      const Index* first = document.connectivity.data() + block.nodes + e * each;
      nodes.assign(first, first + each);
      std::sort(nodes.begin(), nodes.end());
      count += std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end();
    }
  }
  return count;
}

}  // namespace

Edit merge_points(Document& document, std::optional<double> tolerance) {
  if (tolerance && !(*tolerance >= 0 && std::isfinite(*tolerance)))
    throw InputError(fmt::format("expected a tolerance of at least 0, found {}", *tolerance));
  const std::size_t before = document.points.size(), collapsed_before = collapsed(document);
  std::vector<Index> target;
  if (tolerance.value_or(0) > 0) {
    target = near_points(document.points, *tolerance);
  } else {
    std::vector<Eigen::Vector3d> points = document.points;
    target = weld(points);
  }
  MovedNodes moved = move_nodes(document, target);
  const std::size_t merged = before - document.points.size(), now = collapsed(document);
  std::string did = fmt::format(
      "{} merged into others {}", counted(merged, "points"),
      tolerance.value_or(0) > 0 ? fmt::format("within {}", *tolerance) : std::string("at the same place"));
  if (now > collapsed_before)
    did += fmt::format("; {} a node twice now",
                       now - collapsed_before == 1 ? std::string("1 element has")
                                                   : fmt::format("{} elements have", now - collapsed_before));
  if (moved.differing > 0)
    add_loss(moved.lost, "values of merged points", moved.differing,
             "they differ from those of the point that stays");
  return {did, std::move(moved.lost)};
}

Edit prune(Document& document) {
  std::vector<Index> target(document.points.size(), -1);
  for (const Index node : document.connectivity)
    if (node >= 0) target[static_cast<std::size_t>(node)] = 0;
  Index next = 0;
  for (Index& node : target)
    if (node == 0) node = next++;
  const std::size_t unused = target.size() - static_cast<std::size_t>(next);
  return {fmt::format("{} left out", counted(unused, "unused points")),
          std::move(move_nodes(document, target).lost)};
}

Edit renumber(Document& document) {
  std::int64_t nodes = 0, elements = 0;
  for (std::size_t i = 0; i < document.points.size(); ++i)
    nodes += document.node_tag(i) != static_cast<std::int64_t>(i) + 1;
  for (std::size_t i = 0; i < document.elements(); ++i)
    elements += document.element_tag(i) != static_cast<std::int64_t>(i) + 1;
  Edit edit;
  if (elements > 0) edit.lost = without_element_numbers(document);
  if (nodes > 0 || elements > 0) leave_out_sections(document, edit.lost);
  document.node_tags.clear();
  document.element_tags.clear();
  document.first_node = document.first_element = 1;
  edit.did = fmt::format("{} and {} numbered anew, from 1 on{}", counted(nodes, "nodes"),
                         counted(elements, "elements"), freed_unknown_numbers(document));
  return edit;
}

}  // namespace tetproof::io
