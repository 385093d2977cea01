// SPDX-License-Identifier: GPL-3.0-or-later
#include "documents_pairing.hpp"

#include <algorithm>
#include <bit>
#include <deque>
#include <map>
#include <stdexcept>
#include <utility>

#include "io/element_types.hpp"

namespace tetproof::test {
namespace {

// The type and the number of the corners of an element of first order like it.
std::pair<int, std::size_t> corners_of(const Element& element) {
  static const std::map<io::Shape, int> first_order{{io::Shape::line, 1},       {io::Shape::triangle, 2},
                                                    {io::Shape::quadrangle, 3}, {io::Shape::tetrahedron, 4},
                                                    {io::Shape::hexahedron, 5}, {io::Shape::prism, 6},
                                                    {io::Shape::pyramid, 7}};
  const io::ElementType* type = io::element_type(element.type);
  if (!type || type->corners == type->nodes) return {0, 0};
  const auto found = first_order.find(type->shape);
  if (found == first_order.end()) return {0, 0};
  return {found->second, static_cast<std::size_t>(type->corners)};
}

using Key = std::pair<int, std::vector<Index>>;

}  // namespace

std::vector<Element> elements_of(const Document& document) {
  std::vector<Element> elements;
  for (const ElementBlock& block : document.blocks)
    for (std::size_t e = 0; e < block.count; ++e) {
      const auto node =
          document.connectivity.begin() +
          static_cast<std::ptrdiff_t>(block.nodes + e * static_cast<std::size_t>(block.nodes_each));
      elements.push_back({block.type,
                          block.dim,
                          block.entity,
                          document.element_tag(elements.size()),
                          document.tag_sets.at(static_cast<std::size_t>(block.groups)),
                          document.tag_sets.at(static_cast<std::size_t>(block.partitions)),
                          block.of_boundary,
                          {node, node + block.nodes_each}});
    }
  return elements;
}

Pairing pair_up(const Document& before, const std::vector<Element>& elements_before, const Document& after,
                const std::vector<Element>& elements_after) {
  Pairing pairs;
  std::map<std::uint32_t, Index> by_x;
  const auto bits = [](const Eigen::Vector3d& p) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(p.x()));
  };
  for (std::size_t i = 0; i < before.points.size(); ++i)
    if (!by_x.try_emplace(bits(before.points[i]), static_cast<Index>(i)).second)
      throw std::logic_error("two nodes with the same x cannot be told apart");
  pairs.node_after.assign(before.points.size(), none);
  for (std::size_t i = 0; i < after.points.size(); ++i) {
    const auto found = by_x.find(bits(after.points[i]));
    pairs.node_before.push_back(found == by_x.end() ? none : found->second);
    if (found == by_x.end()) continue;
    pairs.node_after[static_cast<std::size_t>(found->second)] = static_cast<Index>(i);
    by_x.erase(found);
  }

  std::map<Key, std::deque<Index>> whole, by_corners, incomplete;
  for (std::size_t e = 0; e < elements_before.size(); ++e) {
    Key key{elements_before[e].type, elements_before[e].nodes};
    for (Index& node : key.second)
      if (node < 0) node = none;
    whole[key].push_back(static_cast<Index>(e));
    const auto [type, corners] = corners_of(elements_before[e]);
    if (corners == 0) continue;
    // Where the format drops elements that name nodes which do not exist, even between the corners, those
    // that name none are the ones that came back.
    const bool names_unknown = std::count(key.second.begin(), key.second.end(), none) > 0;
    key.first = type, key.second.resize(corners);
    (names_unknown ? incomplete : by_corners)[key].push_back(static_cast<Index>(e));
  }
  pairs.element_after.assign(elements_before.size(), none);
  pairs.element_before.assign(elements_after.size(), none);
  const auto pair = [&](std::size_t e, std::initializer_list<std::map<Key, std::deque<Index>>*> among) {
    Key key{elements_after[e].type, elements_after[e].nodes};
    constexpr Index new_node = -2;
    for (Index& node : key.second) {
      if (node >= 0 && pairs.node_before[static_cast<std::size_t>(node)] == none)
        node = new_node;
      else
        node = node < 0 ? none : pairs.node_before[static_cast<std::size_t>(node)];
    }
    Index found = none;
    for (auto* in : among) {
      const auto like = in->find(key);
      if (like == in->end()) continue;
      std::deque<Index>& queue = like->second;
      while (!queue.empty() && pairs.element_after[static_cast<std::size_t>(queue.front())] != none)
        queue.pop_front();
      if (!queue.empty() && (found == none || queue.front() < found)) found = queue.front();
    }
    pairs.element_before[e] = found;
    if (found != none) pairs.element_after[static_cast<std::size_t>(found)] = static_cast<Index>(e);
  };
  // First those of a higher order, which came back as they are: what is left of them lost its nodes between.
  for (std::size_t e = 0; e < elements_after.size(); ++e)
    if (corners_of(elements_after[e]).first != 0) pair(e, {&whole});
  for (std::size_t e = 0; e < elements_after.size(); ++e)
    if (corners_of(elements_after[e]).first == 0) pair(e, {&whole, &by_corners});
  for (std::size_t e = 0; e < elements_after.size(); ++e)
    if (pairs.element_before[e] == none) pair(e, {&incomplete});
  return pairs;
}

}  // namespace tetproof::test
