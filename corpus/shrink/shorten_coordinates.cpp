// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/shrink/shorten_coordinates.hpp"

#include <array>
#include <utility>
#include <vector>

#include "corpus/shrink/bring_near.hpp"
#include "corpus/shrink/decimals.hpp"

namespace tetproof::corpus {
namespace {

// Decimals beyond the coarsest that are tried: few at first, where one more or less matters.
constexpr std::array tried_decimals{0, 1, 2, 3, 4, 5, 6, 8, 10, 12, 14, 16};

bool same_vertices(const TriangleSurface& a, const TriangleSurface& b) {
  return a.vertices == b.vertices;
}

bool bring_near(CertifiedTest& test, TriangleSurface& surface) {
  constexpr std::array<std::array<bool, 2>, 3> choices{{{true, true}, {true, false}, {false, true}}};
  auto success = test.first(choices.size(), surface.triangles.size(),
                            [&](std::size_t i) -> std::optional<TriangleSurface> {
                              TriangleSurface moved = brought_near(surface, choices[i][0], choices[i][1]);
                              if (same_vertices(moved, surface)) return std::nullopt;
                              return moved;
                            });
  if (success) surface = std::move(success->surface);
  return success.has_value();
}

void round_vertex(Eigen::Vector3d& p, int decimals) {
  for (double& x : p)
    if (decimals_of(x) > decimals) x = rounded(x, decimals);
}

// A candidate counts only if it has fewer decimals in all: so the rounding ends.
std::optional<TriangleSurface> if_shorter(TriangleSurface candidate, const TriangleSurface& surface,
                                          int coarsest) {
  if (decimals_beyond(candidate, coarsest) >= decimals_beyond(surface, coarsest)) return std::nullopt;
  return candidate;
}

bool round_all(CertifiedTest& test, TriangleSurface& surface) {
  const int coarsest = coarsest_decimals(surface);
  auto success = test.first(tried_decimals.size(), surface.triangles.size(), [&](std::size_t i) {
    TriangleSurface candidate = surface;
    for (Eigen::Vector3d& p : candidate.vertices) round_vertex(p, coarsest + tried_decimals[i]);
    return if_shorter(std::move(candidate), surface, coarsest);
  });
  if (success) surface = std::move(success->surface);
  return success.has_value();
}

// A coordinate of a vertex, or all three.
struct Place {
  std::size_t vertex;
  int axis;  // -1: all
};

bool round_places(CertifiedTest& test, TriangleSurface& surface, const std::vector<Place>& places) {
  const int coarsest = coarsest_decimals(surface);
  const std::size_t each = tried_decimals.size(), n = places.size() * each;
  bool changed = false;
  for (std::size_t at = 0; at < n;) {
    auto success = test.first(n - at, surface.triangles.size(), [&](std::size_t i) {
      const auto [vertex, axis] = places[(at + i) / each];
      TriangleSurface candidate = surface;
      Eigen::Vector3d& p = candidate.vertices[vertex];
      round_vertex(p, coarsest + tried_decimals[(at + i) % each]);
      for (int other = 0; axis >= 0 && other < 3; ++other)
        if (other != axis) p[other] = surface.vertices[vertex][other];
      return if_shorter(std::move(candidate), surface, coarsest);
    });
    if (!success) break;
    surface = std::move(success->surface);
    changed = true;
    at = ((at + success->index) / each + 1) * each;
  }
  return changed;
}

bool round_vertices(CertifiedTest& test, TriangleSurface& surface) {
  std::vector<Place> places;
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) places.push_back({v, -1});
  return round_places(test, surface, places);
}

// Long coordinates by themselves: often one of a vertex matters and its others do not.
bool round_long_coordinates(CertifiedTest& test, TriangleSurface& surface) {
  constexpr int long_beyond = 4;
  const int coarsest = coarsest_decimals(surface);
  std::vector<Place> places;
  for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    for (int axis = 0; axis < 3; ++axis)
      if (decimals_of(surface.vertices[v][axis]) > coarsest + long_beyond) places.push_back({v, axis});
  return round_places(test, surface, places);
}

}  // namespace

bool shorten_coordinates(CertifiedTest& test, TriangleSurface& surface) {
  const bool moved = bring_near(test, surface);
  const bool all = round_all(test, surface);
  const bool vertices = round_vertices(test, surface);
  const bool coordinates = round_long_coordinates(test, surface);
  return moved || all || vertices || coordinates;
}

}  // namespace tetproof::corpus
