// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the faces that belong to one solid only.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::io {

inline constexpr Index no_corner = std::numeric_limits<Index>::max();

/// A face by its corners in ascending order; of a triangle the last is `no_corner`.
struct Face {
  std::array<Index, 4> corners{no_corner, no_corner, no_corner, no_corner};
  std::size_t id = 0;        ///< for the caller
  std::size_t opposite = 0;  ///< of a quadrangle: which of `corners` is opposite to the first

  Face() = default;
  /// `around`: the three or four corners, all different, as they follow each other.
  Face(std::span<const Index> around, std::size_t number) : id(number) {
    std::copy(around.begin(), around.end(), corners.begin());
    std::sort(corners.begin(), corners.end());
    if (around.size() < 4) return;
    const auto first =
        static_cast<std::size_t>(std::find(around.begin(), around.end(), corners[0]) - around.begin());
    opposite = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), around[(first + 2) % 4]) -
                                        corners.begin());
  }
};
inline bool operator<(const Face& a, const Face& b) {
  return std::tie(a.corners, a.id) < std::tie(b.corners, b.id);
}

/// The first of sorted faces that has the corners of `face`; the end if none has.
inline std::vector<Face>::const_iterator find_face(const std::vector<Face>& faces, const Face& face) {
  Face first = face;
  first.id = 0;
  const auto found = std::lower_bound(faces.begin(), faces.end(), first);
  return found != faces.end() && found->corners == face.corners ? found : faces.end();
}

/// What was not simply a face of one solid or two.
struct OuterCounts {
  std::size_t of_many = 0;  ///< faces of three solids or more
  std::size_t halved = 0;   ///< quadrangles of one solid that two triangles of others cover
};

/// Sorts the faces of all solids and keeps those that are on the boundary.
void keep_outer_faces(std::vector<Face>& faces, OuterCounts& counts);

}  // namespace tetproof::io
