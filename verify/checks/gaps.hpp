// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps: sets of boundary faces that cover the same place from both sides. Internal.
#pragma once

#include <span>
#include <vector>

#include "verify/checks/interface.hpp"

namespace tetproof::verify {

/// Each face belongs to one gap at most. Faces are positions in `Boundary::faces`.
struct Gaps {
  std::vector<Index> of_face;  ///< -1: none
  Index count = 0;

  bool free(Index f) const { return of_face[static_cast<std::size_t>(f)] < 0; }
  void add(std::span<const Index> faces) {
    for (const Index f : faces) of_face[static_cast<std::size_t>(f)] = count;
    ++count;
  }
};

/// Adds gaps of one face that others cover from its other side.
void find_covered_faces(const Interface& interface, const FacesAtVertices& at, Gaps& gaps);
/// Adds gaps with several faces on either side, none of which is covered alone.
void find_interfaces(const Interface& interface, const FacesAtVertices& at, Gaps& gaps);

}  // namespace tetproof::verify
