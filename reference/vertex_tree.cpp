// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/vertex_tree.hpp"

#include <nanoflann.hpp>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "reference/contacts.hpp"

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

// The closest vertex found so far. The slack keeps branches that rounding in the tree's own bounds would
// prune.
class Closest {
 public:
  Closest(const Vertices& vertices, double within)
      : vertices_(vertices), worst_(with_slack(within * within)) {}

  bool addPoint(double squared, Index vertex) {
    const bool closer =
        squared < squared_ ||
        (squared == squared_ && lexicographically_less(vertices_.points[vertex], vertices_.points[vertex_]));
    if (!closer) return true;
    squared_ = squared;
    vertex_ = vertex;
    worst_ = std::min(worst_, with_slack(squared));
    return true;
  }
  double worstDist() const { return worst_; }
  bool full() const { return true; }

  VertexTree::Nearest result() const {
    if (vertex_ < 0) throw std::logic_error("no surface vertex as close as was promised");
    return {vertex_, std::sqrt(squared_)};
  }

 private:
  static double with_slack(double squared) {
    return squared * (1 + 1e-9) + std::numeric_limits<double>::min();
  }
  const Vertices& vertices_;
  double worst_, squared_ = std::numeric_limits<double>::infinity();
  Index vertex_ = -1;
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

VertexTree::Nearest VertexTree::nearest(const Eigen::Vector3d& point, double within) const {
  Closest closest(tree_->vertices, within);
  tree_->index.findNeighbors(closest, point.data(), nanoflann::SearchParams());
  return closest.result();
}

}  // namespace tetproof::reference
