// SPDX-License-Identifier: GPL-3.0-or-later
// The first of two passes over an OBJ file: points, texture coordinates and normals. An element may name
// points that come later, so these are read first.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "io/bytes/input_file.hpp"
#include "io/model/read_document.hpp"
#include "io/obj/obj_names.hpp"
#include "io/obj/obj_state.hpp"
#include "io/surface/rows.hpp"

namespace tetproof::io {

struct ObjPoints {
  std::vector<Eigen::Vector3d> points;
  Rows weights, colors;  ///< the numbers behind x y z
  ObjCorners texture, normal;
  /// The byte where the second pass starts: at the first element, or at the first statement that holds for
  /// elements below it.
  std::size_t first_element = 0;
  /// How many points stand above that byte. `above` of texture and normals counts these in the same way.
  std::int64_t points_above = 0;
};

/// Reads the points of `text`. `names` takes the numbers of groups that have no name. Statements that are not
/// read, and numbers without a meaning, are added to `dropped`. InputError for a text without any statement
/// of OBJ.
ObjPoints read_obj_points(const InputFile& file, std::string_view text, Wanted wanted, GroupNumbers& names,
                          std::vector<Loss>& dropped);

}  // namespace tetproof::io
