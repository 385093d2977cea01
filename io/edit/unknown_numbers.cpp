// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/edit/unknown_numbers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "io/edit/free_numbers.hpp"

namespace tetproof::io {
namespace {

using Used = std::vector<bool>;  // by position in `Document::unknown`

void use(Index i, Used& used) {
  if (i < 0) used[static_cast<std::size_t>(-1 - i)] = true;
}

void use(const std::vector<Values>& all, Used& used) {
  for (const Values& values : all)
    for (const Index i : values.at) use(i, used);
}

Used names_of_nodes(const Document& document) {
  Used used(document.unknown.size(), false);
  for (const Index i : document.connectivity) use(i, used);
  use(document.node_values, used);
  for (const PeriodicLink& link : document.periodic)
    for (const auto& pair : link.nodes) use(pair[0], used), use(pair[1], used);
  for (const LengthBound& bound : document.length_bounds)
    use(bound.nodes[0], used), use(bound.nodes[1], used);
  return used;
}

Used names_of_elements(const Document& document) {
  Used used(document.unknown.size(), false);
  use(document.element_values, used);
  use(document.element_node_values, used);
  for (const GhostElement& ghost : document.ghost_elements) use(ghost.element, used);
  return used;
}

}  // namespace

std::size_t free_unknown_numbers(Document& document) {
  if (document.unknown.empty()) return 0;
  std::vector<std::pair<std::int64_t, std::size_t>> sorted;
  for (std::size_t k = 0; k < document.unknown.size(); ++k) sorted.emplace_back(document.unknown[k], k);
  std::sort(sorted.begin(), sorted.end());
  Used move(sorted.size(), false);
  const auto see = [&](std::int64_t number, const Used& used) {
    for (auto at = std::lower_bound(sorted.begin(), sorted.end(), std::pair(number, std::size_t{0}));
         at != sorted.end() && at->first == number; ++at)
      if (used[at->second]) move[at->second] = true;
  };
  const Used of_nodes = names_of_nodes(document), of_elements = names_of_elements(document);
  for (std::size_t i = 0; i < document.points.size(); ++i) see(document.node_tag(i), of_nodes);
  for (std::size_t i = 0; i < document.elements(); ++i) see(document.element_tag(i), of_elements);
  const auto moved = static_cast<std::size_t>(std::count(move.begin(), move.end(), true));
  if (moved == 0) return 0;
  std::vector<std::int64_t> taken = document.unknown;
  for (std::size_t i = 0; i < document.points.size(); ++i) taken.push_back(document.node_tag(i));
  for (std::size_t i = 0; i < document.elements(); ++i) taken.push_back(document.element_tag(i));
  FreeNumbers free(std::move(taken));
  for (std::size_t k = 0; k < move.size(); ++k)
    if (move[k]) document.unknown[k] = free.next();
  return moved;
}

std::string freed_unknown_numbers(Document& document) {
  const std::size_t moved = free_unknown_numbers(document);
  if (moved == 0) return {};
  return fmt::format("; {} moved behind all others",
                     moved == 1 ? std::string("1 number that names nothing")
                                : fmt::format("{} numbers that name nothing", moved));
}

}  // namespace tetproof::io
