// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model/weld.hpp"

#include <bit>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace tetproof::io {
namespace {

// Mixes every bit of the three coordinates into every bit of the hash, so that the points of a lattice do not
// collide.
std::uint64_t hash(const Eigen::Vector3d& point) {
  std::uint64_t h = 0;
  for (int k = 0; k < 3; ++k) {
    h ^= std::bit_cast<std::uint64_t>(point[k] + 0.0);  // -0 becomes 0
    h = (h ^ (h >> 32)) * 0xd6e8feb86659fd93u;
    h = (h ^ (h >> 32)) * 0xd6e8feb86659fd93u;
  }
  return h ^ (h >> 32);
}

}  // namespace

std::vector<Index> weld(std::vector<Eigen::Vector3d>& points) {
  if (points.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    throw std::length_error("more than 2147483647 points");
  constexpr Index none = -1;
  const std::size_t mask = std::bit_ceil(points.size() + points.size() / 2 + 1) - 1;
  std::vector<Index> table(mask + 1, none);  // open addressing, at most two thirds full
  std::vector<Index> moved(points.size());
  Index kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d point = points[i];
    Index found = none;
    if (point == point) {
      std::size_t slot = hash(point) & mask;
      while (table[slot] != none && points[table[slot]] != point) slot = (slot + 1) & mask;
      if (table[slot] == none)
        table[slot] = kept;
      else
        found = table[slot];
    }
    if (found == none) points[found = kept++] = point;
    moved[i] = found;
  }
  points.resize(kept);
  return moved;
}

}  // namespace tetproof::io
