// SPDX-License-Identifier: GPL-3.0-or-later
// The directed Hausdorff distance with the options that the checks need: trees that are built once, a yes-no
// question, and the nearest triangle of each triangle. Internal; the public header is verify/hausdorff.hpp.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "verify/deadline.hpp"
#include "verify/distance/triangle_tree.hpp"
#include "verify/hausdorff.hpp"

namespace tetproof::verify {

struct DistanceQuestion {
  HausdorffOptions options;
  /// [length] If given, also decide whether the distance is larger than this. While the interval contains
  /// this value and work remains, the interval is narrowed below `options.error`.
  std::optional<double> allowed{};
  /// With `allowed`: decide, and do nothing else. The interval may then be as wide as `allowed`. Its lower
  /// end comes from every eighth triangle of A and from the triangles that the decision needed.
  bool only_decide = false;
  /// With `only_decide`: end as soon as the distance is known to be larger. The upper end of the interval may
  /// then be far from it.
  bool stop_if_larger = false;
  /// With `allowed`: once the distance is known to be larger than allowed, the interval may be as wide as
  /// this share of it, even where that is more than `options.error`.
  double far_share = 0;
  /// If not null and not `only_decide`: receives, for each triangle of A, a triangle of B nearest to its
  /// centroid; -1 if none is within `nearest_within` [length] of it.
  std::vector<Index>* nearest = nullptr;
  double nearest_within = std::numeric_limits<double>::infinity();
  Deadline deadline{};  ///< OutOfTime is thrown soon after
};

/// Both trees must have the same units.
DirectedDistance directed_distance(const TriangleTree& a, const TriangleTree& b,
                                   const DistanceQuestion& question);

}  // namespace tetproof::verify
