// SPDX-License-Identifier: GPL-3.0-or-later
// A surface that is being built, with what its construction knows of it. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

struct Shape {
  TriangleSurface surface;
  std::optional<std::int64_t> components{}, cavities{}, genus{};
};

/// One body without cavities.
inline Shape one_body(TriangleSurface surface, std::int64_t genus = 0) {
  return {std::move(surface), 1, 0, genus};
}

/// Adds a copy of `part`, moved by `shift`; `inward`: with each triangle turned around.
void append(TriangleSurface& surface, const TriangleSurface& part, const Eigen::Vector3d& shift = {0, 0, 0},
            bool inward = false);

/// The axis-parallel box between two corners, 12 triangles.
TriangleSurface box_surface(const Eigen::Vector3d& low, const Eigen::Vector3d& high);

struct Box {
  Eigen::Vector3d low, high;
};
Box bounding_box(const TriangleSurface& surface);

/// The volume [length^3] that the oriented triangles enclose: the exact value, rounded once. The surface must
/// be closed, and finite.
double enclosed_volume(const TriangleSurface& surface);

/// Collects triangles whose corners are given as points. Equal points become one vertex.
class Collector {
 public:
  Index vertex(const Eigen::Vector3d& p);
  void triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const Index i = vertex(a), j = vertex(b), k = vertex(c);
    surface_.triangles.push_back({i, j, k});
  }
  TriangleSurface take() { return std::move(surface_); }

 private:
  TriangleSurface surface_;
  std::map<std::array<double, 3>, Index> numbers_;
};

}  // namespace tetproof::corpus
