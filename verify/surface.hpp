// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of a surface: whether it is closed, manifold, oriented and free of self-intersections; its
// components, genus and exact volume.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::verify {

struct SurfaceComponent {
  std::int64_t triangles = 0;
  std::int64_t vertices = 0;
  Index first_triangle = 0;  ///< its lowest triangle
  bool outward = true;       ///< its exact signed volume is positive
  int depth = 0;             ///< the number of other components that it lies inside
  std::int64_t genus = 0;
  double volume = 0;  ///< [length^3], signed, the exact value rounded once
};

struct SurfaceReport {
  std::int64_t vertices = 0, triangles = 0;
  Eigen::Vector3d box_min = Eigen::Vector3d::Zero(), box_max = Eigen::Vector3d::Zero();
  double area = 0;  ///< [length^2], up to rounding
  /// [length^3] The volume of the points inside an odd number of components: the exact value, rounded once.
  double volume = 0;
  std::vector<SurfaceComponent> components;  ///< sorted by their lowest triangle
  std::int64_t genus = 0;                    ///< the sum over the components

  /// Empty if the surface is usable. Otherwise one line to print after "FILE: ", with the number of faults
  /// and the first place: "the surface is open: 12 edges have one triangle (first: 17-243 from (0, 0, 0) to
  /// (0, 1, 0), of triangle 8)". Vertices and triangles have the file's numbers. The line names the first
  /// fault in this order: not finite, open, non-manifold, not oriented, degenerate, self-intersecting. The
  /// values that would be computed after it (components, volume) are then absent.
  std::string fault;
  /// Remarks that are no faults: an inward orientation, a nested shell that points outward.
  std::vector<std::string> notes;

  /// The number of components at odd depth. They bound cavities.
  std::int64_t cavities() const;
};

struct SurfaceJudgement;

/// A surface with its judgement: it is judged once, and any number of meshes can be compared with it. Refers
/// to the surface, which must outlive it. What is said of the surface names it by the numbers of `numbering`.
class JudgedSurface {
 public:
  explicit JudgedSurface(const TriangleSurface& surface, SurfaceNumbering numbering = {});
  const TriangleSurface& surface() const { return *surface_; }
  const SurfaceReport& report() const;
  const SurfaceJudgement& judgement() const { return *judgement_; }  ///< internal to verify/

 private:
  const TriangleSurface* surface_;
  std::shared_ptr<const SurfaceJudgement> judgement_;
};

/// Judges a surface. Equal vertices must be welded. Decisions are exact; the report is the same for any
/// number of threads. Messages name vertices and triangles by the numbers that `numbering` gives them.
SurfaceReport judge_surface(const TriangleSurface& surface, SurfaceNumbering numbering = {});

}  // namespace tetproof::verify
