// SPDX-License-Identifier: GPL-3.0-or-later
// Step (v): the weight of a tetrahedron, from the surface vertex closest to its centroid.
#pragma once

#include <vector>

#include "io/triangle_surface.hpp"
#include "reference/engine/adaptation/vertex_tree.hpp"
#include "reference/equations.hpp"

namespace tetproof::reference {

/// The quantities of section 3 for one tetrahedron.
struct Weight {
  double d;        ///< eq. (3.2) [length]
  double kappa;    ///< absolute curvature at the closest surface vertex [1/length]; 0 without curvature
  double omega;    ///< eq. (3.6); 1 without curvature
  double volume;   ///< [length^3]
  double desired;  ///< eq. (3.1) at the weighted distance, omega d [length^3]
  double error;    ///< eq. (3.3) [length^3]
};

/// Computes weights. It holds the surface's vertices, their curvatures, and the law of eq. (3.1).
class Weighting {
 public:
  /// `curvature`: whether the distance is weighted by eq. (3.6) (reading D15).
  Weighting(const TriangleSurface& surface, bool curvature);

  void set_law(const VolumeLaw& law) { law_ = law; }
  const VolumeLaw& law() const { return law_; }
  bool with_curvature() const { return !kappas_.empty(); }
  double kappa_min() const { return kappa_min_; }
  double kappa_max() const { return kappa_max_; }
  const std::vector<double>& kappas() const { return kappas_; }

  /// The distance of eq. (3.2). `within`: a distance within which a surface vertex is known to lie; it saves
  /// time.
  double distance(const std::array<Eigen::Vector3d, 4>& corners,
                  double within = std::numeric_limits<double>::infinity()) const;
  /// The other quantities, from the distance.
  Weight weigh(const std::array<Eigen::Vector3d, 4>& corners, double distance) const;

  /// A lower bound of the error of a tetrahedron with this volume whose centroid lies within `reach` of a
  /// place with distance `d`. It holds because the distance of eq. (3.2) changes by at most as much as the
  /// place moves, and because eq. (3.1) is monotone.
  double least_error(double volume, double d, double reach) const;

 private:
  VertexTree tree_;
  std::vector<double> kappas_;
  double kappa_min_ = 0, kappa_max_ = 0;
  VolumeLaw law_{1, 1, 1, 1};
};

}  // namespace tetproof::reference
