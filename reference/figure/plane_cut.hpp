// SPDX-License-Identifier: GPL-3.0-or-later
// The cut of a plane through a grid: a triangle or a quadrilateral for each tetrahedron that it cuts, and the
// outline of the surface.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::reference {

/// The plane normal . x = offset. If the normal is an axis, sides are decided exactly, by comparing
/// coordinates.
struct Plane {
  Eigen::Vector3d normal;
  double offset = 0;
};

/// Reads "x=0.5" (likewise y, z), "x" (the plane through the middle of the surface's box), or "a,b,c,d" (the
/// plane a x + b y + c z = d). Throws InputError for any other text.
Plane parse_plane(const std::string& text, const TriangleSurface& surface);
/// The plane as text, such as "x = 0.5".
std::string plane_text(const Plane& plane);

/// A power of two that no coordinate exceeds, and not much larger than the largest one; 1 if all are 0 or
/// none is finite. Figures divide by it, so that areas and volumes neither vanish nor overflow.
double unit_of(const std::vector<Eigen::Vector3d>& points);

/// On which side of a plane each point is: 1, -1, or 0 on it. The side is computed once for each point, so
/// that all that share a point agree. `points` must outlive it.
class PlaneSides {
 public:
  PlaneSides(const std::vector<Eigen::Vector3d>& points, const Plane& plane);
  int operator[](Index i) const { return side_[i]; }
  /// Where the plane meets the edge between a point above it and a point below it; the same point for both
  /// directions of the edge.
  Eigen::Vector3d crossing(Index a, Index b) const;

 private:
  const std::vector<Eigen::Vector3d>& points_;
  int axis_;  // that equals the normal; -1: none
  double offset_;
  std::vector<double> above_;
  std::vector<signed char> side_;
};

/// The polygon in which the plane cuts a tetrahedron. Its corners lie on the plane up to rounding; exactly,
/// if the normal is an axis. Tetrahedra that share an edge have the same point on it, to the last bit.
struct CutPolygon {
  Index tet;
  int corners;                            ///< 3 or 4
  std::array<Eigen::Vector3d, 4> points;  ///< in order around the polygon; the first `corners` are set
};
using CutSegment = std::array<Eigen::Vector3d, 2>;

struct PlaneCut {
  /// One for each tetrahedron that the plane cuts, in the order of the tetrahedra; then one for each face
  /// that lies in the plane.
  std::vector<CutPolygon> polygons;
  /// The segments in which the plane cuts the surface, each once. Of a part of the surface that lies in the
  /// plane, only the outer edges are among them.
  std::vector<CutSegment> outline;
};

/// Cuts the mesh and the surface. A tetrahedron that meets the plane only in a point or an edge has no
/// polygon. A face that lies in the plane belongs to the tetrahedron on its negative side, or to the other
/// one if there is none. All indices must exist.
PlaneCut cut(const TetMesh& mesh, const TriangleSurface& surface, const Plane& plane);

/// The unit vectors of the plane that point right and up in the picture. A plane normal to x is seen from +x,
/// with y to the right; one normal to y is seen from -y, with x to the right; one normal to z is seen from
/// +z, with x to the right.
std::array<Eigen::Vector3d, 2> picture_axes(const Plane& plane);
/// The same for a direction, of any length but 0, from which one looks: z is up, and y where one looks along
/// z.
std::array<Eigen::Vector3d, 2> axes_seen_from(const Eigen::Vector3d& direction);

}  // namespace tetproof::reference
