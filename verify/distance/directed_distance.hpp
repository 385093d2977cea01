// SPDX-License-Identifier: GPL-3.0-or-later
// The directed Hausdorff distance with what the checks need besides: trees built once, a question to be
// decided, the nearest triangle of each. Internal; the public face is hausdorff.hpp.
#pragma once

#include <optional>
#include <vector>

#include "verify/distance/triangle_tree.hpp"
#include "verify/hausdorff.hpp"

namespace tetproof::verify {

struct DistanceQuestion {
  HausdorffOptions options;
  /// [length] Decide whether the distance is larger: the interval is narrowed beyond `options.error` while it
  /// holds this and work remains.
  std::optional<double> allowed{};
  /// With `allowed`: decide, and no more. The interval may be as wide as what is allowed; its lower end comes
  /// from every eighth triangle of A and from what had to be looked at.
  bool only_decide = false;
  /// If not null, and not only to decide: for each triangle of A one of B nearest to its centroid.
  std::vector<Index>* nearest = nullptr;
};

/// `a` and `b` in the same units.
DirectedDistance directed_distance(const TriangleTree& a, const TriangleTree& b,
                                   const DistanceQuestion& question);

}  // namespace tetproof::verify
