// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a closed surface, which of them lie inside which, and points between them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// The connected parts of a closed surface without self-intersections.
struct Nesting {
  std::vector<int> part_of_triangle;  ///< from 0, in the order of the parts' first triangles
  std::vector<int> parent;            ///< of each part: the innermost part around it; -1: none
  std::vector<int> depth;  ///< of each part: the number of parts around it; odd: it bounds a cavity
  int parts() const { return static_cast<int>(parent.size()); }
};

/// Finds the parts of a surface that is valid. Which lies inside which is decided exactly.
Nesting nesting(const TriangleSurface& surface);

/// A point strictly inside `part` and strictly outside of the parts inside it, proved exactly. Absent: none
/// was found; the room is then hardly wider than the distance of two doubles.
std::optional<Eigen::Vector3d> point_in(const TriangleSurface& surface, const Nesting& nesting, int part);

}  // namespace tetproof::corpus
