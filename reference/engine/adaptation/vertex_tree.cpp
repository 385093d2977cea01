// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/adaptation/vertex_tree.hpp"

#include <nanoflann.hpp>

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "reference/engine/first_grid/contacts.hpp"

namespace tetproof::reference {
namespace {

// The vertices as nanoflann asks for them.
struct Vertices {
  std::vector<Eigen::Vector3d> points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][static_cast<int>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

// The slack keeps branches that rounding in the tree's own bounds would prune.
double with_slack(double squared) {
  return squared * (1 + 1e-9) + std::numeric_limits<double>::min();
}

// nanoflann 1.5 renamed its search options.
#if NANOFLANN_VERSION < 0x150
using SearchOptions = nanoflann::SearchParams;
#else
using SearchOptions = nanoflann::SearchParameters;
#endif

// The smallest distance found so far, for nanoflann.
struct Smallest {
  using DistanceType = double;
  double squared = std::numeric_limits<double>::infinity(), worst;
  explicit Smallest(double within) : worst(with_slack(within * within)) {}
  bool addPoint(double candidate, Index) {
    squared = std::min(squared, candidate);
    worst = std::min(worst, with_slack(squared));
    return true;
  }
  double worstDist() const { return worst; }
  bool full() const { return true; }
  void sort() {}  // one result needs no order
};

// Of the vertices within a distance, the lexicographically smallest, for nanoflann.
struct FirstWithin {
  using DistanceType = double;
  const Vertices& vertices;
  double limit;
  Index vertex = -1;
  bool addPoint(double squared, Index candidate) {
    if (squared <= limit &&
        (vertex < 0 || lexicographically_less(vertices.points[candidate], vertices.points[vertex])))
      vertex = candidate;
    return true;
  }
  double worstDist() const { return with_slack(limit); }
  bool full() const { return true; }
  void sort() {}  // one result needs no order
};

using KdTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Vertices>, Vertices, 3, Index>;

}  // namespace

struct VertexTree::Tree {
  Vertices vertices;
  KdTree index;
  explicit Tree(std::vector<Eigen::Vector3d> points) : vertices{std::move(points)}, index(3, vertices) {}
};

VertexTree::VertexTree(std::vector<Eigen::Vector3d> vertices)
    : tree_(std::make_unique<Tree>(std::move(vertices))) {}
VertexTree::~VertexTree() = default;
VertexTree::VertexTree(VertexTree&&) noexcept = default;

double VertexTree::distance(const Eigen::Vector3d& point, double within) const {
  Smallest smallest(within);
  tree_->index.findNeighbors(smallest, point.data(), SearchOptions());
  if (!std::isfinite(smallest.squared)) throw std::logic_error("no surface vertex as close as was promised");
  return std::sqrt(smallest.squared);
}

Index VertexTree::nearest(const Eigen::Vector3d& point, double smallest_distance) const {
  FirstWithin first{tree_->vertices, smallest_distance * smallest_distance * (1 + 2e-12)};
  tree_->index.findNeighbors(first, point.data(), SearchOptions());
  if (first.vertex < 0) throw std::logic_error("no surface vertex as close as was promised");
  return first.vertex;
}

std::string vertex_tree_library() {
  return fmt::format("nanoflann {:x}.{:x}.{:x}", NANOFLANN_VERSION >> 8, NANOFLANN_VERSION >> 4 & 0xF,
                     NANOFLANN_VERSION & 0xF);
}

}  // namespace tetproof::reference
