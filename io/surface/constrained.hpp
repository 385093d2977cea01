// SPDX-License-Identifier: GPL-3.0-or-later
// Constrained triangulations in the plane, and exact decisions about points.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace tetproof::io {

using Triangle2 = std::array<std::int32_t, 3>;  ///< positions of points, anticlockwise

/// An edge between two points that `count` sides of polygons cover. `net`: how many more of them run from its
/// first end to its second than back.
struct PlaneEdge {
  std::array<std::int32_t, 2> ends{};
  std::int64_t count = 1, net = 0;
};

struct PlaneTriangulation {
  std::vector<Triangle2> triangles;  ///< cover the convex hull of the points
  std::vector<PlaneEdge> edges;      ///< the given edges, cut where they pass over points
};

/// Some triangulation that has all edges, by exact predicates. The points must differ. Nothing if two edges
/// cross. Which of several triangulations it is may depend on the version of CGAL.
std::optional<PlaneTriangulation> constrained_triangulation(const std::vector<Eigen::Vector2d>& points,
                                                            const std::vector<PlaneEdge>& edges);

/// A way to measure lengths in a plane that is seen along an axis: the point (u, v) stands for
/// (u, v, slope[0] u + slope[1] v).
struct PlaneSlope {
  double u = 0, v = 0;
};

/// Whether d lies inside (1), on (0) or outside (-1) of the circle through a, b and c, which run
/// anticlockwise. Exact.
int side_of_circle(const PlaneSlope& slope, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                   const Eigen::Vector2d& c, const Eigen::Vector2d& d);
/// Whether a, b and c run anticlockwise (1), lie on a line (0) or run clockwise (-1). Exact.
int turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);
/// Whether d lies on the side of the plane through a, b and c from which these run anticlockwise (1), in it
/// (0), or on the other side (-1). Exact.
int side_of_plane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                  const Eigen::Vector3d& d);
/// Whether c and d, which lie in one plane with a and b, are on the same side of the line through a and b.
/// Exact.
bool same_side_of_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                       const Eigen::Vector3d& d);
/// Whether the three points lie on a line. Exact.
bool on_a_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);
/// Whether a b is longer (1) than c d, as long (0), or shorter (-1). Exact.
int compare_lengths(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                    const Eigen::Vector3d& d);

}  // namespace tetproof::io
