// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/adaptation/triangulation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace tetproof::reference {
namespace {

using Face = std::array<Index, 3>;  // ascending

Face face_of(const Corners& tet, int face) {
  const auto& [i, j, k] = tet_faces[face];
  Face f{tet[i], tet[j], tet[k]};
  if (f[0] > f[1]) std::swap(f[0], f[1]);
  if (f[1] > f[2]) std::swap(f[1], f[2]);
  if (f[0] > f[1]) std::swap(f[0], f[1]);
  return f;
}

std::uint64_t edge_key(Index a, Index b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint32_t>(std::max(a, b));
}

// A face of a tetrahedron whose neighbour across it is still to be found.
struct Side {
  Face face;
  Index tet;
  int at;
};

}  // namespace

Triangulation::Triangulation(TetMesh mesh, std::vector<std::uint8_t> on_surface)
    : mesh_(std::move(mesh)), on_surface_(std::move(on_surface)), alive_(std::ssize(mesh_.tets)) {
  neighbours_.assign(mesh_.tets.size(), {-1, -1, -1, -1});
  std::vector<Side> sides;
  sides.reserve(4 * mesh_.tets.size());
  for (Index t = 0; t < numbers(); ++t) {
    for (int f = 0; f < 4; ++f) sides.push_back({face_of(mesh_.tets[t], f), t, f});
    count_edges(mesh_.tets[t], +1);
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return std::tie(a.face, a.tet) < std::tie(b.face, b.tet); });
  for (std::size_t s = 1; s < sides.size(); ++s) {
    if (sides[s].face != sides[s - 1].face) continue;
    if (s > 1 && sides[s].face == sides[s - 2].face)
      throw std::logic_error("a face of the grid belongs to three tetrahedra");
    neighbours_[sides[s].tet][sides[s].at] = sides[s - 1].tet;
    neighbours_[sides[s - 1].tet][sides[s - 1].at] = sides[s].tet;
  }
}

std::array<Eigen::Vector3d, 4> Triangulation::corner_points(Index tet) const {
  const auto& [a, b, c, d] = mesh_.tets[tet];
  return {point(a), point(b), point(c), point(d)};
}

bool Triangulation::edge_is_shared(Index tet, int i, int j) const {
  for (int f = 0; f < 4; ++f)
    if (f != i && f != j && neighbours_[tet][f] >= 0) return true;
  return surface_edges_.at(edge_key(mesh_.tets[tet][i], mesh_.tets[tet][j])) > 1;
}

void Triangulation::count_edges(const Corners& tet, int change) {
  for (int i = 0; i < 4; ++i) {
    if (!on_surface(tet[i])) continue;
    for (int j = i + 1; j < 4; ++j) {
      if (!on_surface(tet[j])) continue;
      const auto found = surface_edges_.try_emplace(edge_key(tet[i], tet[j]), 0).first;
      found->second += change;
      if (found->second == 0) surface_edges_.erase(found);
    }
  }
}

Index Triangulation::add_point(const Eigen::Vector3d& point, bool on_surface) {
  if (mesh_.points.size() == std::numeric_limits<Index>::max())
    throw std::length_error("more points than an index can number");
  mesh_.points.push_back(point);
  on_surface_.push_back(on_surface);
  return points() - 1;
}

Index Triangulation::replace(std::span<const Index> old, std::span<const Corners> fresh) {
  if (mesh_.tets.size() + fresh.size() > std::numeric_limits<Index>::max())
    throw std::length_error("more tetrahedra than an index can number");
  // The outer faces of the old tetrahedra, each with the neighbour beyond it and the neighbour's own face
  // number.
  std::vector<Side> around;
  for (const Index t : old)
    for (int f = 0; f < 4; ++f) {
      const Index n = neighbours_[t][f];
      if (n < 0 || std::find(old.begin(), old.end(), n) != old.end()) continue;
      const auto back = std::find(neighbours_[n].begin(), neighbours_[n].end(), t);
      around.push_back({face_of(mesh_.tets[t], f), n, static_cast<int>(back - neighbours_[n].begin())});
    }
  for (const Index t : old) {
    count_edges(mesh_.tets[t], -1);
    neighbours_[t].fill(replaced);
  }
  const Index first = numbers();
  for (const Corners& tet : fresh) {
    count_edges(tet, +1);
    const Index t = numbers();
    mesh_.tets.push_back(tet);
    neighbours_.push_back({-1, -1, -1, -1});
    for (int f = 0; f < 4; ++f) {
      const Face face = face_of(tet, f);
      const auto partner =
          std::find_if(around.begin(), around.end(), [&](const Side& s) { return s.face == face; });
      if (partner == around.end()) {  // shared with a later new tetrahedron, or on the boundary
        around.push_back({face, t, f});
        continue;
      }
      neighbours_[t][f] = partner->tet;
      neighbours_[partner->tet][partner->at] = t;
      *partner = around.back();
      around.pop_back();
    }
  }
  for (const Side& left : around)
    if (left.tet < first) throw std::logic_error("a shared face lost its tetrahedron in an exchange");
  alive_ += std::ssize(fresh) - std::ssize(old);
  return first;
}

TetMesh Triangulation::mesh() const {
  TetMesh now{mesh_.points, {}};
  now.tets.reserve(static_cast<std::size_t>(alive_));
  for (Index t = 0; t < numbers(); ++t)
    if (alive(t)) now.tets.push_back(mesh_.tets[t]);
  return now;
}

}  // namespace tetproof::reference
