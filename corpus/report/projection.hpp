// SPDX-License-Identifier: GPL-3.0-or-later
// A parallel projection into a frame of a picture, from the direction that shows most. Internal.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string>
#include <vector>

namespace tetproof::corpus {

/// A place in a picture, in units of a tenth of a pixel.
using Pixel = std::array<int, 2>;

struct Frame {
  int left = 0, top = 0, width = 0, height = 0;  ///< [pixel]
};

using DrawnTriangle = std::array<Eigen::Vector3d, 3>;

/// The direction, out of some fixed ones and the normals of the triangles, from which the triangles look
/// largest in all, while most of them are seen and few from their edge.
Eigen::Vector3d best_direction(std::span<const DrawnTriangle> triangles);

class Projection {
 public:
  /// Fits the points into the frame. `seen_from`: from the picture to the eye, of length 1. If the picture
  /// would be a thin strip, it is turned so that it lies along the frame, and stretched across.
  Projection(const Eigen::Vector3d& seen_from, std::span<const Eigen::Vector3d> points, const Frame& frame);

  Pixel operator()(const Eigen::Vector3d& p) const;
  double depth(const Eigen::Vector3d& p) const { return seen_from_.dot(p - middle_); }  ///< larger: nearer
  double pixels_per_length() const { return scale_[0]; }
  double stretch() const { return scale_[1] / scale_[0]; }  ///< of the vertical direction; 1: none
  const Eigen::Vector3d& seen_from() const { return seen_from_; }

 private:
  Eigen::Vector3d seen_from_, right_, up_, middle_;
  std::array<double, 2> scale_{1, 1}, low_{}, size_{};
  Frame frame_;
};

}  // namespace tetproof::corpus
