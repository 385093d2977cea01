// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of a surface: closed, manifold, oriented, free of self-intersections; components, genus, exact
// volume.
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
  int depth = 0;             ///< in how many other components it lies
  std::int64_t genus = 0;
  double volume = 0;  ///< [length^3], signed, the exact value rounded once
};

struct SurfaceReport {
  std::int64_t vertices = 0, triangles = 0;
  Eigen::Vector3d box_min = Eigen::Vector3d::Zero(), box_max = Eigen::Vector3d::Zero();
  double area = 0;  ///< [length^2], to rounding
  double volume =
      0;  ///< [length^3] of the points inside an odd number of components; exact value rounded once
  std::vector<SurfaceComponent> components;  ///< by their lowest triangle
  std::int64_t genus = 0;                    ///< sum over the components

  /// Empty when the surface is usable; otherwise one line for "FILE: ", with the number of faults and the
  /// first place: "the surface is open: 12 edges have one triangle (first: 17-243)". Vertices and triangles
  /// are positions from 0. The first of: not finite, open, non-manifold, not oriented, degenerate,
  /// self-intersecting. What is computed after the fault (components, volume) is then absent.
  std::string fault;
  std::vector<std::string> notes;  ///< no faults: an inward orientation, a nested shell that points outward

  /// Number of components at odd depth: they bound cavities.
  std::int64_t cavities() const;
};

struct SurfaceJudgement;

/// A surface with its judgement, so that it is judged once and meshes are compared with it any number of
/// times. Refers to the surface, which must outlive it.
class JudgedSurface {
 public:
  explicit JudgedSurface(const TriangleSurface& surface);
  const TriangleSurface& surface() const { return *surface_; }
  const SurfaceReport& report() const;
  const SurfaceJudgement& judgement() const { return *judgement_; }  ///< internal to verify/

 private:
  const TriangleSurface* surface_;
  std::shared_ptr<const SurfaceJudgement> judgement_;
};

/// Judges a surface whose equal vertices are welded. Exact decisions; same report for any number of threads.
SurfaceReport judge_surface(const TriangleSurface& surface);

}  // namespace tetproof::verify
