// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/adaptation/weighted_grid.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/engine/first_grid/exact.hpp"

namespace tetproof::reference {

WeightedGrid::WeightedGrid(Triangulation grid, const Weighting& weighting,
                           const std::vector<double>& distances, MapToSurface to_surface, bool literal)
    : grid_(std::move(grid)), weighting_(weighting), to_surface_(std::move(to_surface)), literal_(literal) {
  weights_.resize(grid_.numbers());
  tbb::parallel_for(Index{0}, grid_.numbers(),
                    [&](Index t) { weights_[t] = weighting_.weigh(grid_.corner_points(t), distances[t]); });
  std::vector<Entry> entries(weights_.size());
  std::vector<int> pieces(weights_.size());
  tbb::parallel_for(Index{0}, grid_.numbers(), [&](Index t) { entries[t] = bound(t, pieces[t]); });
  for (std::size_t t = 0; t < weights_.size(); ++t) {
    sum_.add(weights_[t].error);
    queues_[pieces[t] - 2].push(entries[t]);
  }
  if (!to_surface_ || grid_.tets() == 0) return;
  CompensatedSum volume;
  for (const Weight& w : weights_) volume.add(w.volume);
  boundary_.emplace(2 * std::cbrt(volume.value() / static_cast<double>(grid_.tets())));
  for (Index t = 0; t < grid_.numbers(); ++t)
    for (int f = 0; f < 4; ++f)
      if (grid_.neighbour(t, f) < 0) boundary_->add(face(t, f));
}

BoundaryFace WeightedGrid::face(Index tet, int f) const {
  BoundaryFace face;
  for (int v = 0; v < 3; ++v) {
    face.names[v] = grid_.corners(tet)[tet_faces[f][v]];
    face.corners[v] = grid_.point(face.names[v]);
  }
  return face;
}

std::array<Eigen::Vector3d, 4> WeightedGrid::piece(const std::array<Eigen::Vector3d, 4>& corners,
                                                   const Split& split, int k) const {
  auto points = corners;
  points[split.replaced[k]] = split.point;
  return points;
}

bool WeightedGrid::pieces_positive(Index tet, const Split& split) const {
  const auto corners = grid_.corner_points(tet);
  for (int k = 0; k < split.pieces; ++k) {
    const auto [a, b, c, d] = piece(corners, split, k);
    if (orientation(a, b, c, d) <= 0) return false;
  }
  return true;
}

Candidate WeightedGrid::candidate(Index tet) const {
  const Split split = split_by_table4(grid_, tet);
  if (split.on_surface && to_surface_ && !left_.contains(tet)) {
    Split to_surface = split;
    to_surface.point = to_surface_(split.point);
    if (pieces_positive(tet, to_surface)) {
      Candidate found = candidate(tet, to_surface);
      found.moved = true;
      return found;
    }
  }
  return candidate(tet, split);
}

Candidate WeightedGrid::candidate(Index tet, const Split& split) const {
  Candidate found{.tet = tet, .split = split, .pieces = {}, .change = 0};
  const auto corners = grid_.corner_points(tet);
  const Weight& whole = weights_[tet];
  const Eigen::Vector3d centre = centroid(corners[0], corners[1], corners[2], corners[3]);
  for (int k = 0; k < split.pieces; ++k) {
    const auto points = piece(corners, split, k);
    const double moved_by = (centroid(points[0], points[1], points[2], points[3]) - centre).norm();
    const double distance = weighting_.distance(points, (whole.d + moved_by) * (1 + 1e-12));
    found.pieces[k] = weighting_.weigh(points, distance);
    found.change += found.pieces[k].error;
  }
  found.change -= whole.error;
  return found;
}

// The literal evaluation above needs a nearest-vertex query for each piece. Most candidates never come near
// the top of their queue. For them a lower bound, from the distance that is known already, is enough.
WeightedGrid::Entry WeightedGrid::bound(Index tet, int& pieces) const {
  const Split split = split_by_table4(grid_, tet);
  pieces = split.pieces;
  if (split.on_surface && to_surface_)  // finding the new point itself is expensive
    return {-std::numeric_limits<double>::infinity(), tet, false};
  const auto corners = grid_.corner_points(tet);
  const Weight& whole = weights_[tet];
  const Eigen::Vector3d centre = centroid(corners[0], corners[1], corners[2], corners[3]);
  double change = -whole.error;
  for (int k = 0; k < split.pieces; ++k) {
    const auto [a, b, c, d] = piece(corners, split, k);
    // From the rounded centroids, so that the bound also holds far from the origin.
    const double moved_by = (centroid(a, b, c, d) - centre).norm();
    change += weighting_.least_error(volume(a, b, c, d), whole.d, moved_by);
  }
  constexpr double slack = 1e-12;  // far above the rounding errors of this sum and of the literal one
  return {change - slack * (whole.error + whole.volume), tet, false};
}

void WeightedGrid::enqueue(Index tet) {
  int pieces = 0;
  const Entry entry = bound(tet, pieces);
  queues_[pieces - 2].push(entry);
}

std::optional<Candidate> WeightedGrid::best() {
  for (;;) {
    std::array<double, 3> averages;
    averages.fill(std::numeric_limits<double>::infinity());
    int chosen = -1;
    for (int q = 0; q < 3; ++q) {
      while (!queues_[q].empty() && !grid_.alive(queues_[q].top().tet)) queues_[q].pop();
      if (queues_[q].empty()) continue;
      averages[q] = e_avg_after(queues_[q].top().change, q + 2);
      if (chosen < 0 || averages[q] < averages[chosen] ||
          (averages[q] == averages[chosen] && queues_[q].top().tet < queues_[chosen].top().tet))
        chosen = q;
    }
    if (chosen < 0) return std::nullopt;
    bool settled = true;  // whether every bound that might win has been made exact
    for (int q = 0; q < 3; ++q) {
      if (queues_[q].empty() || queues_[q].top().exact || averages[q] > averages[chosen]) continue;
      const Index tet = queues_[q].top().tet;
      queues_[q].pop();
      const Candidate c = candidate(tet);
      queues_[q].push({c.change, tet, true});
      evaluated_.insert_or_assign(tet, c);
      settled = false;
    }
    if (settled) return evaluated_.at(queues_[chosen].top().tet);
  }
}

bool WeightedGrid::is_positive(const Candidate& c) const {
  return pieces_positive(c.tet, c.split);
}

bool WeightedGrid::crosses_boundary(const Candidate& c) const {
  if (!c.moved) return false;
  const Corners& corners = grid_.corners(c.tet);
  std::vector<BoundaryFace> fresh;  // the parts into which the new point cuts the unshared faces that hold it
  for (int f = 0; f < 4; ++f) {
    const bool holds = std::none_of(c.split.replaced.begin(), c.split.replaced.begin() + c.split.pieces,
                                    [&](int corner) { return corner == f; });
    if (grid_.neighbour(c.tet, f) >= 0 || !holds) continue;
    for (int k = 0; k < c.split.pieces; ++k) {
      BoundaryFace piece = face(c.tet, f);
      for (int v = 0; v < 3; ++v)
        if (piece.names[v] == corners[c.split.replaced[k]]) {
          piece.names[v] = grid_.points();  // the number that the new point will get
          piece.corners[v] = c.split.point;
        }
      fresh.push_back(piece);
    }
  }
  // Every boundary face stays except those faces of the tetrahedron that hold the new point.
  const auto stays = [&](const BoundaryFace& other) {
    int replaced = 0;
    for (const Index name : other.names)
      for (int k = 0; k < c.split.pieces; ++k) replaced += name == corners[c.split.replaced[k]];
    const bool own = std::all_of(other.names.begin(), other.names.end(), [&](Index name) {
      return std::find(corners.begin(), corners.end(), name) != corners.end();
    });
    return !(own && replaced == c.split.pieces);
  };
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    if (boundary_->meets(fresh[i], stays)) return true;
    for (std::size_t j = 0; j < i; ++j)
      if (faces_meet(fresh[i], fresh[j])) return true;
  }
  return false;
}

void WeightedGrid::dequeue(Index tet) {
  for (Queue& queue : queues_)
    if (!queue.empty() && queue.top().tet == tet) queue.pop();
  evaluated_.erase(tet);
}

void WeightedGrid::leave_point(Index tet) {
  left_.insert(tet);
  dequeue(tet);
  enqueue(tet);
}

void WeightedGrid::refuse(Index tet) {
  dequeue(tet);
}

Index WeightedGrid::apply(const Candidate& c) {
  const Index point = grid_.add_point(c.split.point, c.split.on_surface);
  const auto pieces = pieces_of(grid_.corners(c.tet), c.split, point);
  evaluated_.erase(c.tet);
  left_.erase(c.tet);
  sum_.add(-weights_[c.tet].error);
  if (boundary_)
    for (int f = 0; f < 4; ++f)
      if (grid_.neighbour(c.tet, f) < 0) boundary_->remove(face(c.tet, f));
  const Index first = grid_.replace(std::array{c.tet}, std::span(pieces).first(c.split.pieces));
  for (int k = 0; k < c.split.pieces; ++k) {
    weights_.push_back(c.pieces[k]);
    sum_.add(c.pieces[k].error);
  }
  for (Index t = first; t < grid_.numbers(); ++t) enqueue(t);
  for (Index t = first; boundary_ && t < grid_.numbers(); ++t)
    for (int f = 0; f < 4; ++f)
      if (grid_.neighbour(t, f) < 0) boundary_->add(face(t, f));
  return first;
}

Index WeightedGrid::exchange(std::span<const Index> old, std::span<const Corners> fresh) {
  for (const Index t : old) {  // boundary_ stays as it is: no flip changes a boundary face
    evaluated_.erase(t);
    left_.erase(t);
    sum_.add(-weights_[t].error);
  }
  const Index first = grid_.replace(old, fresh);
  for (Index t = first; t < grid_.numbers(); ++t) {
    const auto corners = grid_.corner_points(t);
    weights_.push_back(weighting_.weigh(corners, weighting_.distance(corners)));
    sum_.add(weights_.back().error);
  }
  for (Index t = first; t < grid_.numbers(); ++t) enqueue(t);
  return first;
}

}  // namespace tetproof::reference
