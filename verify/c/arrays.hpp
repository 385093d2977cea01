// SPDX-License-Identifier: GPL-3.0-or-later
// Takes points, elements and tags from the arrays of a caller, and refuses arrays that cannot be.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "io/tet_mesh.hpp"
#include "verify/c/tetproof.h"

namespace tetproof::c {

/// The points of an array. `name`: the argument's, for messages. Refused: what tetproof.h does not permit.
std::vector<Eigen::Vector3d> points_of(const tetproof_points& array, const char* name);

/// The integers of an array of items of one integer each, which are no positions. Refused: likewise.
std::vector<std::int64_t> tags_of(const tetproof_integers& array, const char* name);

/// Numbers that name no point, each once, in the order of their first use.
class UnknownNumbers {
 public:
  /// -1-k for the number that is `numbers()[k]`.
  Index position(std::int64_t number);
  const std::vector<std::int64_t>& numbers() const { return numbers_; }

 private:
  std::vector<std::int64_t> numbers_;
  std::map<std::int64_t, Index> positions_;
};

/// The corners of elements, four of tetrahedra and three of triangles: positions among `points` points, or
/// those of `unknown`. Refused: likewise.
template <std::size_t Corners>
std::vector<std::array<Index, Corners>> elements_of(const tetproof_integers& array, std::size_t points,
                                                    UnknownNumbers& unknown, const char* name);

}  // namespace tetproof::c
