// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/first_grid/indicators.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace tetproof::reference {

using namespace tables;

bool SurfaceVertices::contains(Vertex v) const {
  return std::binary_search(vertices.begin(), vertices.end(), v);
}

void SurfaceVertices::add(const std::vector<NearVertex>& more) {
  SurfaceVertices merged;
  std::size_t old = 0;
  const auto take_old = [&] {
    merged.vertices.push_back(vertices[old]);
    merged.points.push_back(points[old++]);
  };
  for (const NearVertex& near : more) {
    while (old < vertices.size() && vertices[old] < near.vertex) take_old();
    merged.vertices.push_back(near.vertex);
    merged.points.push_back(near.point);
  }
  while (old < vertices.size()) take_old();
  *this = std::move(merged);
}

std::vector<std::int8_t> initial_indicators(std::vector<std::int8_t> inside,
                                            const std::vector<Vertex>& on_surface,
                                            const SurfaceVertices& settled, Region region) {
  if (region == Region::outside)
    for (std::int8_t& indicator : inside) indicator = static_cast<std::int8_t>(-indicator);
  for (const Vertex v : on_surface) inside[v] = 0;
  for (const Vertex v : settled.vertices) inside[v] = 0;
  return inside;
}

namespace {

// Table 3. Its rows request new indicators of vertices that are 0. All requests are collected first and then
// applied at once; a vertex that is asked for both signs becomes exterior (reading D6).
void apply_table3(const Lattice& lattice, const std::vector<EdgeIntersections>& intersections,
                  const SurfaceVertices& settled, Indicators& indicators) {
  const auto& initial = indicators.initial;
  std::vector<std::pair<Vertex, int>> requests;
  for (const EdgeIntersections& met : intersections) {
    Vertex vi = lattice.low(met.edge), vj = lattice.high(met.edge);
    if ((initial[vi] == 0 && settled.contains(vi)) || (initial[vj] == 0 && settled.contains(vj))) continue;
    if (initial[vi] > initial[vj]) std::swap(vi, vj);
    const int needed = initial[vi] * initial[vj] < 0 ? 1 : 0;
    if (met.count <= needed) continue;
    const int r = table3_row(initial[vi], initial[vj]);
    ++indicators.table3[r];
    indicators.dropped += met.count - needed;
    if (initial[vi] == 0) requests.emplace_back(vi, table3[r].new_vi);
    if (initial[vj] == 0) requests.emplace_back(vj, table3[r].new_vj);
  }
  std::sort(requests.begin(), requests.end());  // for each vertex, -1 comes before +1 and wins
  for (std::size_t q = 0; q < requests.size(); ++q)
    if (q == 0 || requests[q].first != requests[q - 1].first)
      indicators.sign[requests[q].first] = static_cast<std::int8_t>(requests[q].second);
}

}  // namespace

Indicators characterize(const Lattice& lattice, std::vector<std::int8_t> initial,
                        const std::vector<EdgeIntersections>& intersections, const SurfaceVertices& settled) {
  Indicators indicators;
  indicators.initial = std::move(initial);
  indicators.sign = indicators.initial;
  apply_table3(lattice, intersections, settled, indicators);

  Cuts& cuts = indicators.cuts;
  cuts.directions.assign(lattice.vertices(), 0);
  for (const EdgeIntersections& met : intersections) {
    const Vertex low = lattice.low(met.edge), high = lattice.high(met.edge);
    if (indicators.sign[low] * indicators.sign[high] >= 0) continue;
    const bool low_is_exterior = indicators.sign[low] < 0;
    if (indicators.initial[low_is_exterior ? low : high] == 0)
      continue;  // the exterior end itself is the cut (reading D7)
    cuts.directions[low] |= static_cast<std::uint8_t>(1 << (met.edge & 7));
    cuts.points.push_back(low_is_exterior ? met.nearest_low : met.nearest_high);
    cuts.edges.push_back(met.edge);
  }
  cuts.first.resize(lattice.vertices());
  std::uint32_t next = 0;
  for (Vertex v = 0; v < lattice.vertices(); ++v) {
    cuts.first[v] = next;
    next += __builtin_popcount(cuts.directions[v]);
  }
  return indicators;
}

}  // namespace tetproof::reference
