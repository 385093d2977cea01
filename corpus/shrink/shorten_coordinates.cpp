// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/shrink/shorten_coordinates.hpp"

#include <array>
#include <utility>

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

bool round_vertices(CertifiedTest& test, TriangleSurface& surface) {
  const int coarsest = coarsest_decimals(surface);
  const std::size_t each = tried_decimals.size(), n = surface.vertices.size() * each;
  bool changed = false;
  for (std::size_t at = 0; at < n;) {
    auto success = test.first(n - at, surface.triangles.size(), [&](std::size_t i) {
      TriangleSurface candidate = surface;
      round_vertex(candidate.vertices[(at + i) / each], coarsest + tried_decimals[(at + i) % each]);
      return if_shorter(std::move(candidate), surface, coarsest);
    });
    if (!success) break;
    surface = std::move(success->surface);
    changed = true;
    at = ((at + success->index) / each + 1) * each;
  }
  return changed;
}

}  // namespace

bool shorten_coordinates(CertifiedTest& test, TriangleSurface& surface) {
  const bool moved = bring_near(test, surface);
  const bool all = round_all(test, surface);
  const bool vertices = round_vertices(test, surface);
  return moved || all || vertices;
}

}  // namespace tetproof::corpus
