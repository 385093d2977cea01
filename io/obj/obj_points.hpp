// SPDX-License-Identifier: GPL-3.0-or-later
// The first of two passes over an OBJ file: its points, texture coordinates and normals, since an element may
// name such as come later.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "io/bytes/input_file.hpp"
#include "io/obj/obj_names.hpp"
#include "io/obj/obj_state.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {

struct ObjPoints {
  std::vector<Eigen::Vector3d> points;
  Rows weights, colors;         ///< the numbers behind x y z
  std::size_t odd_numbers = 0;  ///< points with numbers behind them that are neither
  ObjCorners texture, normal;
  /// Where the second pass starts, at the first element or what holds for those below it; and how many points
  /// stand above it. `above` of texture and normals is the same of these.
  std::size_t first_element = 0;
  std::int64_t points_above = 0;
  std::map<std::string, std::size_t, std::less<>> unread;  ///< statements that are not read, and how often
};

/// `names` takes the numbers that groups have as such.
ObjPoints read_obj_points(const InputFile& file, Wanted wanted, GroupNumbers& names);

}  // namespace tetproof::io
