// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/figure/plane_cut.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "io/bytes/scanner.hpp"
#include "io/error.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;

// The axis that equals the normal; -1 if there is none.
int axis_of(const Plane& plane) {
  for (int i = 0; i < 3; ++i)
    if (plane.normal == Vector3d::Unit(i)) return i;
  return -1;
}

// A face that lies in the plane, with its tetrahedron.
struct InPlane {
  std::array<Index, 3> face;
  int side;  // of the plane on which the tetrahedron lies; -1 sorts first
  Index tet;
  auto operator<=>(const InPlane&) const = default;
};

}  // namespace

double unit_of(const std::vector<Vector3d>& points) {
  double largest = 0;
  for (const Vector3d& point : points)
    if (point.allFinite()) largest = std::max(largest, point.cwiseAbs().maxCoeff());
  int exponent = 0;
  std::frexp(largest, &exponent);
  return largest > 0 ? std::ldexp(1, std::clamp(exponent, -1000, 1000)) : 1;
}

PlaneSides::PlaneSides(const std::vector<Vector3d>& points, const Plane& plane)
    : points_(points), axis_(axis_of(plane)), offset_(plane.offset) {
  for (const Vector3d& point : points) {
    const double along = axis_ >= 0 ? point[axis_] : plane.normal.dot(point);
    side_.push_back(along > offset_ ? 1 : along < offset_ ? -1 : 0);
    above_.push_back(along - offset_);
  }
}

Vector3d PlaneSides::crossing(Index a, Index b) const {
  if (a > b) std::swap(a, b);
  const double t = above_[a] / (above_[a] - above_[b]);
  Vector3d point = points_[a] + t * (points_[b] - points_[a]);
  if (axis_ >= 0) point[axis_] = offset_;
  return point;
}

PlaneCut cut(const TetMesh& mesh, const TriangleSurface& surface, const Plane& plane) {
  PlaneCut result;
  std::vector<InPlane> in_plane;
  const PlaneSides sides(mesh.points, plane);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    std::array<Index, 4> on, up, down;
    int ons = 0, ups = 0, downs = 0;
    for (const Index i : mesh.tets[t])
      (sides[i] == 0 ? on[ons++] : sides[i] > 0 ? up[ups++] : down[downs++]) = i;
    CutPolygon polygon{static_cast<Index>(t), 0, {}};
    const auto add = [&](const Vector3d& point) { polygon.points[polygon.corners++] = point; };
    if (ons == 3) {
      std::array<Index, 3> face{on[0], on[1], on[2]};
      std::sort(face.begin(), face.end());
      in_plane.push_back({face, ups ? 1 : -1, static_cast<Index>(t)});
      continue;
    }
    if (ups == 0 || downs == 0) continue;
    for (int i = 0; i < ons; ++i) add(mesh.points[on[i]]);
    // In order around the polygon: two successive crossings lie on edges with a common corner, hence on one
    // face.
    for (int i = 0; i < ups; ++i)
      for (int j = 0; j < downs; ++j) add(sides.crossing(up[i], down[i % 2 == 0 ? j : downs - 1 - j]));
    result.polygons.push_back(polygon);
  }
  std::sort(in_plane.begin(), in_plane.end());
  for (std::size_t i = 0; i < in_plane.size(); ++i) {
    const auto& [face, side, tet] = in_plane[i];
    if (i > 0 && in_plane[i - 1].face == face) continue;
    result.polygons.push_back(
        {tet, 3, {mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]], Vector3d::Zero()}});
  }

  const PlaneSides surface_sides(surface.vertices, plane);
  for (const auto& triangle : surface.triangles) {
    std::array<Vector3d, 3> ends;
    int count = 0;
    for (int i = 0; i < 3; ++i) {
      const Index a = triangle[i], b = triangle[(i + 1) % 3];
      if (surface_sides[a] == 0) ends[count++] = surface.vertices[a];
      if (surface_sides[a] * surface_sides[b] < 0) ends[count++] = surface_sides.crossing(a, b);
    }
    if (count == 2) result.outline.push_back({ends[0], ends[1]});
  }
  const auto before = [](const Vector3d& a, const Vector3d& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  for (CutSegment& segment : result.outline)
    if (before(segment[1], segment[0])) std::swap(segment[0], segment[1]);
  std::sort(result.outline.begin(), result.outline.end(), [&](const CutSegment& a, const CutSegment& b) {
    return before(a[0], b[0]) || (a[0] == b[0] && before(a[1], b[1]));
  });
  result.outline.erase(std::unique(result.outline.begin(), result.outline.end()), result.outline.end());
  return result;
}

Plane parse_plane(const std::string& text, const TriangleSurface& surface) {
  std::string plain;
  for (const char c : text)
    if (c != ' ') plain += c;
  const auto fail = [&]() -> Plane {
    throw InputError(
        fmt::format("--plane: expected an axis and a place, as x=0, an axis for the middle, or a,b,c,d for "
                    "ax + by + cz = d, found '{}'",
                    text));
  };
  const auto number = [&](const std::string& word) {
    double value;
    if (!parse_real(word, value) || !std::isfinite(value)) fail();
    return value;
  };
  if (!plain.empty() && plain[0] >= 'x' && plain[0] <= 'z') {
    const int axis = plain[0] - 'x';
    if (plain.size() == 1) {
      double low = 0, high = 0;
      for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
        const double at = surface.vertices[i][axis];
        low = i ? std::min(low, at) : at;
        high = i ? std::max(high, at) : at;
      }
      return {Vector3d::Unit(axis), low / 2 + high / 2};
    }
    if (plain[1] != '=') return fail();
    return {Vector3d::Unit(axis), number(plain.substr(2))};
  }
  std::array<double, 4> numbers{};
  for (int i = 0; i < 4; ++i) {
    const std::size_t comma = plain.find(',');
    if ((comma == std::string::npos) != (i == 3)) return fail();
    numbers[i] = number(plain.substr(0, comma));
    plain.erase(0, comma == std::string::npos ? plain.size() : comma + 1);
  }
  const Vector3d normal(numbers[0], numbers[1], numbers[2]);
  const double size = normal.stableNorm();
  if (!(size >= 1e-150 && size <= 1e150)) return fail();
  return {normal, numbers[3]};
}

std::string plane_text(const Plane& plane) {
  if (const int axis = axis_of(plane); axis >= 0)
    return fmt::format("{} = {:.6g}", "xyz"[axis], plane.offset);
  std::string text;
  for (int i = 0; i < 3; ++i) {
    const double factor = plane.normal[i], size = std::abs(factor);
    if (factor == 0) continue;
    text += text.empty() ? (factor < 0 ? "-" : "") : factor < 0 ? " - " : " + ";
    text += size == 1 ? fmt::format("{}", "xyz"[i]) : fmt::format("{:.6g} {}", size, "xyz"[i]);
  }
  return fmt::format("{} = {:.6g}", text, plane.offset);
}

std::array<Vector3d, 2> picture_axes(const Plane& plane) {
  switch (axis_of(plane)) {
    case 0:
      return {Vector3d::UnitY(), Vector3d::UnitZ()};
    case 1:
      return {Vector3d::UnitX(), Vector3d::UnitZ()};
    case 2:
      return {Vector3d::UnitX(), Vector3d::UnitY()};
    default:
      break;
  }
  return axes_seen_from(plane.normal);
}

std::array<Vector3d, 2> axes_seen_from(const Vector3d& direction) {
  const Vector3d towards = direction.stableNormalized();
  const Vector3d upright = towards.head<2>().norm() > 1e-3 ? Vector3d::UnitZ() : Vector3d::UnitY();
  const Vector3d up = (upright - upright.dot(towards) * towards).normalized();
  return {up.cross(towards), up};
}

}  // namespace tetproof::reference
