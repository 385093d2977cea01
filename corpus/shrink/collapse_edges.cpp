// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/shrink/collapse_edges.hpp"

#include <array>
#include <utility>
#include <vector>

#include "corpus/generators/random.hpp"
#include "corpus/shrink/editable_surface.hpp"
#include "corpus/shrink/halving.hpp"

namespace tetproof::corpus {
namespace {

using Edge = std::array<Index, 2>;

constexpr std::size_t smallest_batch = 2;

std::vector<Edge> shuffled_edges(const EditableSurface& surface, std::uint64_t seed) {
  Random random(seed);
  std::vector<Edge> edges = surface.edges();
  shuffle(edges, random);
  return edges;
}

// The three ways to collapse an edge.
Collapse way(const EditableSurface& surface, const Edge& edge, std::size_t i) {
  const auto& [a, b] = edge;
  const Eigen::Vector3d &at_a = surface.vertices()[a], &at_b = surface.vertices()[b];
  if (i == 0) return {a, b, at_b};
  if (i == 1) return {b, a, at_a};
  return {a, b, at_a / 2 + at_b / 2};
}
constexpr std::size_t ways = 3;

std::optional<Collapse> first_way(const EditableSurface& surface, const Edge& edge) {
  for (std::size_t i = 0; i < ways; ++i)
    if (const Collapse collapse = way(surface, edge, i); surface.allows(collapse)) return collapse;
  return std::nullopt;
}

// Edges so far apart that a collapse of one changes no triangle at the ends of another.
std::vector<Edge> independent_edges(const EditableSurface& surface, std::uint64_t seed) {
  std::vector<std::uint8_t> taken(surface.vertices().size(), 0);
  std::vector<Edge> chosen;
  for (const Edge& edge : shuffled_edges(surface, seed)) {
    std::vector<Index> around{edge[0], edge[1]};
    bool free = true;
    for (const Index end : edge)
      for (const Index v : surface.neighbours(end)) around.push_back(v);
    for (const Index v : around) free = free && !taken[v];
    if (!free || !first_way(surface, edge)) continue;
    for (const Index v : around) taken[v] = 1;
    chosen.push_back(edge);
  }
  return chosen;
}

// As `base` with the edges collapsed, where they still can be: one collapse may come in the way of another.
EditableSurface collapsed(EditableSurface base, const std::vector<Edge>& edges,
                          std::span<const std::size_t> run) {
  for (const std::size_t i : run)
    if (const auto collapse = first_way(base, edges[i])) base.apply(*collapse);
  return base;
}

bool collapse_batches(CertifiedTest& test, TriangleSurface& surface, std::uint64_t seed) {
  EditableSurface base(surface);
  const std::vector<Edge> edges = independent_edges(base, seed);
  return try_by_halves(
             test, edges.size(), smallest_batch, [&] { return surface.triangles.size() - 1; },
             [&](std::span<const std::size_t> run) {
               return std::optional(collapsed(base, edges, run).surface());
             },
             [&](std::span<const std::size_t> run, TriangleSurface accepted) {
               base = collapsed(std::move(base), edges, run);
               surface = std::move(accepted);
             }) > 0;
}

bool collapse_singles(CertifiedTest& test, TriangleSurface& surface, std::uint64_t seed) {
  EditableSurface base(surface);
  const std::vector<Edge> edges = shuffled_edges(base, seed);
  bool changed = false;
  for (std::size_t at = 0; at < ways * edges.size();) {
    auto success = test.first(ways * edges.size() - at, surface.triangles.size() - 1,
                              [&](std::size_t i) -> std::optional<TriangleSurface> {
                                const Collapse collapse = way(base, edges[(at + i) / ways], (at + i) % ways);
                                if (!base.allows(collapse)) return std::nullopt;
                                EditableSurface next = base;
                                next.apply(collapse);
                                return next.surface();
                              });
    if (!success) break;
    at += success->index;
    base.apply(way(base, edges[at / ways], at % ways));
    surface = std::move(success->surface);
    changed = true;
    at = (at / ways + 1) * ways;
  }
  return changed;
}

}  // namespace

std::int64_t collapse_edges(CertifiedTest& test, TriangleSurface& surface, std::uint64_t seed) {
  const std::size_t before = surface.vertices.size();
  std::uint64_t round = seed;
  while (collapse_batches(test, surface, ++round) && !test.out_of_time()) {
  }
  while (collapse_singles(test, surface, ++round) && !test.out_of_time()) {
  }
  return static_cast<std::int64_t>(before - surface.vertices.size());
}

}  // namespace tetproof::corpus
