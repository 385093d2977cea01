// SPDX-License-Identifier: GPL-3.0-or-later
// The cut of a plane through a grid: a triangle or quadrilateral of each tetrahedron, and the surface's
// outline.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::reference {

/// normal . x = offset. Where the normal is an axis, sides are decided by comparing coordinates, exactly.
struct Plane {
  Eigen::Vector3d normal;
  double offset = 0;
};

/// "x=0.5" (or y, z), "x" (through the middle of the surface's box), or "a,b,c,d" for a x + b y + c z = d.
/// Throws InputError for anything else.
Plane parse_plane(const std::string& text, const TriangleSurface& surface);
/// As `parse_plane` reads it: "x = 0.5".
std::string plane_text(const Plane& plane);

/// A corner of a polygon lies on the plane to rounding, where the normal is an axis exactly; tetrahedra that
/// share an edge share the point on it to the last bit.
struct CutPolygon {
  Index tet;
  int corners;                            ///< 3 or 4, in order around it
  std::array<Eigen::Vector3d, 4> points;  ///< the first `corners` of them
};
using CutSegment = std::array<Eigen::Vector3d, 2>;

struct PlaneCut {
  std::vector<CutPolygon> polygons;  ///< by tetrahedra; then faces that lie in the plane, each once
  std::vector<CutSegment>
      outline;  ///< of the surface: each segment once; none within its parts that lie in the plane
};

/// Tetrahedra that only touch the plane in a point or an edge have no polygon. A face that lies in the plane
/// belongs to the tetrahedron on its negative side, or else the other. Indices must exist.
PlaneCut cut(const TetMesh& mesh, const TriangleSurface& surface, const Plane& plane);

/// The plane as a picture: right and up, two unit vectors. Axis planes are seen along their axis: x from +x
/// with y to the right, y from -y with x to the right, z from +z with x to the right.
std::array<Eigen::Vector3d, 2> picture_axes(const Plane& plane);

}  // namespace tetproof::reference
